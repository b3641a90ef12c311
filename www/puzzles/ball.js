// Balls as values. Knows nothing of the wasm or the document.

/** @typedef {import("../pkg/pathlight.js").Ball} Ball */

/**
 * Whether two balls have the same place and radius; two that are missing are the same.
 * @param {Ball | null | undefined} first
 * @param {Ball | null | undefined} second
 */
export function sameBall(first, second) {
  if (!first || !second) return !first && !second;
  return first.every((value, index) => value === second[index]);
}
