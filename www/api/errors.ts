// The package's errors: a sentence, and a `code` like that of the wasm's errors.

import type { ErrorCode as WasmCode } from "../pkg/worker/pathlight.js";

/**
 * Codes of errors. `no_wasm`, `no_weights`: a file could not be read; `no_model`: there is no model of this name; the
 * other codes are those of the wasm.
 */
export type ErrorCode = WasmCode | "no_wasm" | "no_weights" | "no_model";

/** The errors that the package throws. */
export type CodedError = Error & { code: ErrorCode };

export function failure(code: ErrorCode, sentence: string): CodedError {
  return Object.assign(new Error(sentence), { code });
}

/** After a panic, the wasm also refuses to free what it holds. That must not hide the error of the panic. */
export function cleanUp(act: () => void): void {
  try {
    act();
  } catch {
    // The error of the call itself is reported.
  }
}
