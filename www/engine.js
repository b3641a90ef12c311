// Fetches the wasm and compiles it once, for the page and its worker.

/** { wasm, module }: the exports, ready to be called, and the compiled module. Throws a sentence for the person. */
export async function start() {
  if (typeof WebAssembly !== "object") {
    throw new Error("This browser has no WebAssembly, or it is switched off. Pathlight needs it: try a current browser.");
  }
  const answer = await fetch("pkg/pathlight_bg.wasm");
  if (!answer.ok) {
    throw new Error(`Pathlight’s engine did not come: the server answered ${answer.status} for pkg/pathlight_bg.wasm. Build it with “make play”.`);
  }
  const wasm = await import("./pkg/pathlight.js");
  const module = await WebAssembly.compileStreaming(answer);
  await wasm.default({ module_or_path: module });
  return { wasm, module };
}
