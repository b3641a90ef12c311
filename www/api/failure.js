// Errors of the API's own JavaScript: a sentence, and a `code` as the wasm exports have it.

/**
 * What went wrong, for code that handles it. `no_wasm`, `no_weights`, `no_style`: a file could not be read; `no_model`:
 * there is no model of this name; the others are those of the wasm exports.
 * @typedef {import("../pkg/pathlight.js").ErrorCode | "no_wasm" | "no_weights" | "no_style" | "no_model"} ErrorCode
 */

/**
 * Returns an Error with a code.
 * @param {ErrorCode} code
 * @param {string} sentence
 */
export function failure(code, sentence) {
  return Object.assign(new Error(sentence), { code });
}
