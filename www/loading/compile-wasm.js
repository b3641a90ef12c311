// Begins to compile the wasm, which the first picture waits for longest. The page loads this module first and by
// itself, and its bundle leaves it apart, so that the wasm is compiled and checked on other threads while the rest is
// still read.

import { compileWasm } from "../api/files.js";

// Those who call it again handle the rejection.
compileWasm().catch(() => {});

export { compileWasm };
