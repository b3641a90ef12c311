// Errors of the package's own: a sentence, and a `code` as the wasm's errors have one.

import type { ErrorCode as WasmCode } from "../pkg/worker/pathlight.js";

/**
 * What went wrong, for code that handles it. `no_wasm`, `no_weights`: a file could not be read; `no_model`: there is no
 * model of this name; the others are those of the wasm.
 */
export type ErrorCode = WasmCode | "no_wasm" | "no_weights" | "no_model";

/** What the package throws. */
export type CodedError = Error & { code: ErrorCode };

export function failure(code: ErrorCode, sentence: string): CodedError {
  return Object.assign(new Error(sentence), { code });
}

/** After a panic the wasm refuses also to free what it holds, which must not hide the error of the panic. */
export function cleanUp(act: () => void): void {
  try {
    act();
  } catch {
    // The error of the call is on its way.
  }
}
