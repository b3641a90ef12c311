// Fetches the wasm and compiles it once, for the page and its worker. It begins as soon as this file is here, while the
// other modules are still on their way: nothing takes longer on the way to the first picture.

/** Resolves to { wasm, module }: the exports, ready to be called, and the compiled module. Rejects with a sentence for
 * the person. */
export const engine = start();

// Whoever waits for it hears of a failure; nobody may do so yet.
engine.catch(() => {});

async function start() {
  if (typeof WebAssembly !== "object") {
    throw new Error("This browser has no WebAssembly, or it is switched off. Pathlight needs it: try a current browser.");
  }
  const [answer, wasm] = await Promise.all([fetch("pkg/pathlight_bg.wasm"), import("../pkg/pathlight.js")]);
  if (!answer.ok) {
    throw new Error(`Pathlight’s engine did not come: the server answered ${answer.status} for pkg/pathlight_bg.wasm. Build it with “make play”.`);
  }
  const module = await WebAssembly.compileStreaming(answer);
  await wasm.default({ module_or_path: module });
  return { wasm, module };
}
