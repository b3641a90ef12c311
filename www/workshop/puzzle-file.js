// Puzzles as files: the JSON of one scene, or an array of several. What is read is checked whole before anything is
// made of it.

import { download, fileName } from "../shell/download.js";
import { pathlight } from "../shell/page-api.js";
import { sceneName } from "../shell/puzzle-name.js";
import { plainScene } from "./plain-scene.js";

/** @typedef {import("../pkg/pathlight.js").OwnScene} OwnScene */

/** More than a browser keeps, bytes. */
const MAX_SIZE = 8e6;

/**
 * Saves one puzzle.
 * @param {OwnScene} scene
 */
export function savePuzzle(scene) {
  download(fileName(sceneName(scene), "json"), jsonBlob(scene));
}

/**
 * Saves puzzles in one file.
 * @param {OwnScene[]} scenes
 */
export function savePuzzles(scenes) {
  download("own-puzzles.json", jsonBlob(scenes));
}

/** @param {unknown} value */
function jsonBlob(value) {
  return new Blob([JSON.stringify(value, null, 1)], { type: "application/json" });
}

/**
 * Returns the puzzles of a file. Rejects with a sentence if it holds none, or one that may not be played.
 * @param {File} file
 * @returns {Promise<OwnScene[]>}
 */
export async function readPuzzles(file) {
  if (/\.jsonl$/i.test(file.name)) {
    throw new Error(
      `${file.name} is a file of attempts, not of puzzles: open a puzzle, and then the file by “Open attempts”. Nothing was changed.`,
    );
  }
  const foreign = `${file.name} is not a file of puzzles from Pathlight. Nothing was changed.`;
  if (file.size > MAX_SIZE) throw new Error(foreign);
  /** @type {unknown} */
  let value;
  try {
    value = JSON.parse(await file.text());
  } catch {
    throw new Error(foreign);
  }
  const scenes = Array.isArray(value) ? value : [value];
  if (scenes.length === 0) throw new Error(`${file.name} holds no puzzle.`);
  scenes.forEach((scene, index) => {
    const [problem] = pathlight.sceneProblems(scene);
    if (!problem) return;
    const which = scenes.length > 1 ? `Puzzle ${index + 1} of ${file.name}` : file.name;
    throw new Error(`${which} cannot be played: ${problem.sentence} Nothing was changed.`);
  });
  return scenes.map(plainScene);
}
