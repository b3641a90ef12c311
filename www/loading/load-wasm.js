// Loads the wasm once, for all puzzles of a page and their workers. It starts with this module, because the first
// picture waits for nothing longer.

// By the path from another folder: in a bundle this import stays, in a file that lies in one.
import { compileWasm } from "./compile-wasm.js";
import { failure } from "../api/failure.js";
import { load as loadPathlight } from "../api/index.js";
import { text } from "../text/text.js";

/** @type {Promise<WebAssembly.Module> | null} */
let loaded = null;

/**
 * Returns the compiled module once the API can be called. Rejects with a sentence for the person; the next call then
 * tries again.
 */
export function loadWasm() {
  loaded ??= load().catch((error) => {
    loaded = null;
    throw error;
  });
  return loaded;
}

// Those who call handle the rejection.
loadWasm().catch(() => {});

async function load() {
  const module = await compileWasm().catch(({ code, message }) => {
    throw failure(code, text.reading.wasm.failed(message));
  });
  await loadPathlight({ wasm: module, weights: null });
  return module;
}
