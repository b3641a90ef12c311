// Fetches the wasm and compiles it once, for the page and its worker. It starts as soon as this file has arrived, while
// the other modules are still on their way, because the first picture waits for nothing longer.

/**
 * Resolves to the compiled module once the exports of pkg/pathlight.js can be called. Rejects with a sentence for the
 * person.
 */
export const wasmLoaded = load();

// main.js handles the rejection, but may attach its handler only later.
wasmLoaded.catch(() => {});

/** @returns {Promise<WebAssembly.Module>} */
async function load() {
  if (typeof WebAssembly !== "object") {
    throw new Error("This browser has no WebAssembly, or it is switched off. Pathlight needs it: try a current browser.");
  }
  const [response, { default: initialise }] = await Promise.all([fetch(new URL("../pkg/pathlight_bg.wasm", import.meta.url)), import("../pkg/pathlight.js")]);
  if (!response.ok) {
    throw new Error(`Pathlight’s wasm could not be loaded: the server answered ${response.status} for pkg/pathlight_bg.wasm. Build it with “make play”.`);
  }
  // Not every static server knows wasm's media type, without which the browser refuses to compile while it loads.
  const streams = response.headers.get("content-type") === "application/wasm";
  const module = await (streams ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer()));
  await initialise({ module_or_path: module });
  return module;
}
