// Puzzles as files: the JSON of one scene, or an array of several. What is read is checked whole before anything is
// made of it.

import { download, fileName } from "../widgets/download.js";
import { pathlight } from "../shell/page-api.js";
import { sceneName } from "../puzzles/puzzle-name.js";
import { FileProblem, inSlices } from "../storage/sliced-work.js";
import { text } from "../text/text.js";
import { plainScene } from "./plain-scene.js";
import { problemWords } from "./problem-words.js";

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
  const { attempts, foreign, tooLarge, empty } = text.editor.file;
  if (/\.jsonl$/i.test(file.name)) throw new FileProblem(attempts(file.name));
  if (file.size > MAX_SIZE) throw new FileProblem(tooLarge(file.name, MAX_SIZE / 1e6));
  /** @type {unknown} */
  let value;
  try {
    value = JSON.parse(await file.text());
  } catch {
    throw new FileProblem(foreign(file.name));
  }
  const scenes = Array.isArray(value) ? value : [value];
  if (scenes.length === 0) throw new FileProblem(empty(file.name));
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
      const place = scenes.length > 1 ? plain.length + 1 : null;
      throw new FileProblem(text.editor.file.unplayable(name, place, problemWords(problem, scene)));
    }
    yield plain.push(plainScene(scene)) / scenes.length;
  }
  return plain;
}
