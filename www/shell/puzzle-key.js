// What the attempts at a puzzle are kept under: the id of a task, or the digest of an own scene.

import { pathlight } from "./page-api.js";

/** @param {import("../pkg/pathlight.js").Played} played */
export function puzzleKey(played) {
  return typeof played === "string" ? played : pathlight.sceneDigest(played);
}
