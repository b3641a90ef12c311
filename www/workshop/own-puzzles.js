// The puzzles of a person's own that this browser keeps, for all of the page.

import { pathlight } from "../shell/pathlight.js";
import { PuzzleStore } from "../storage/puzzle-store.js";

/** @type {PuzzleStore | null} */
let shared = null;

export function ownPuzzles() {
  return (shared ??= new PuzzleStore((scene) => pathlight.sceneProblems(scene).length === 0));
}
