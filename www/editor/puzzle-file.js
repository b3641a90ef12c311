// Puzzles as files: the JSON of one scene, or an array of several. What is read is checked whole before anything is
// made of it.

import { download, fileName } from "../widgets/download.js";
import { pathlight } from "../shell/page-api.js";
import { sceneName } from "../puzzles/puzzle-name.js";
import { FileProblem, inSlices } from "../storage/sliced-work.js";
import { plainScene } from "./plain-scene.js";

/** @typedef {import("../pkg/pathlight.js").CustomScene} CustomScene */

/** Parsed at once; more would freeze the page, bytes. */
const MAX_SIZE = 8e6;

/**
 * Saves one puzzle.
 * @param {CustomScene} scene
 */
export function savePuzzle(scene) {
  download(fileName(sceneName(scene), "json"), jsonBlob(scene));
}

/**
 * Saves puzzles in one file.
 * @param {CustomScene[]} scenes
 */
export function savePuzzles(scenes) {
  download("custom-puzzles.json", jsonBlob(scenes));
}

/** @param {unknown} value */
function jsonBlob(value) {
  return new Blob([JSON.stringify(value, null, 1)], { type: "application/json" });
}

/**
 * Returns the puzzles of a file. Rejects with a FileProblem if it holds none, or one that may not be played.
 * @param {File} file
 * @param {Parameters<typeof inSlices>[1]} [slices]
 * @returns {Promise<CustomScene[]>}
 */
export async function readPuzzles(file, slices) {
  if (/\.jsonl$/i.test(file.name)) {
    throw new FileProblem(
      `${file.name} is a file of attempts, not of puzzles: open a puzzle, and then the file by “Open attempts”. Nothing was changed.`,
    );
  }
  const foreign = `${file.name} is not a file of puzzles from Pathlight. Nothing was changed.`;
  if (file.size > MAX_SIZE)
    throw new FileProblem(`${file.name} is larger than ${MAX_SIZE / 1e6} MB. Split it. Nothing was changed.`);
  /** @type {unknown} */
  let value;
  try {
    value = JSON.parse(await file.text());
  } catch {
    throw new FileProblem(foreign);
  }
  const scenes = Array.isArray(value) ? value : [value];
  if (scenes.length === 0) throw new FileProblem(`${file.name} holds no puzzle.`);
  return inSlices(playable(file.name, scenes), slices);
}

/**
 * @param {string} name of the file
 * @param {any[]} scenes
 */
function* playable(name, scenes) {
  /** @type {CustomScene[]} */
  const plain = [];
  for (const scene of scenes) {
    const [problem] = pathlight.sceneProblems(scene);
    if (problem) {
      const which = scenes.length > 1 ? `Puzzle ${plain.length + 1} of ${name}` : name;
      throw new FileProblem(`${which} cannot be played: ${problem.sentence} Nothing was changed.`);
    }
    yield plain.push(plainScene(scene)) / scenes.length;
  }
  return plain;
}
