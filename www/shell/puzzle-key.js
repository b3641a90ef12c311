// What the attempts at a puzzle are kept under: the id of a task, or the digest of a custom scene.

import { pathlight } from "./page-api.js";

/** @param {import("../pkg/pathlight.js").Puzzle} puzzle */
export function puzzleKey(puzzle) {
  return typeof puzzle === "string" ? puzzle : pathlight.sceneDigest(puzzle);
}
