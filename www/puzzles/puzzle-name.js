// The names that people read: "Funnel, 8 of 100" for a task, and those that people give their custom puzzles.

import { text } from "../text/text.js";
import { TEMPLATES } from "./templates.js";

/** @type {Map<string, string>} */
const names = new Map();

/**
 * The name of a task of the benchmark; the task itself if it is none.
 * @param {string} task
 */
export function puzzleName(task) {
  if (names.size === 0) {
    for (const { name, tasks } of TEMPLATES)
      tasks.forEach((one, index) => names.set(one, text.puzzles.numbered(name, index + 1, tasks.length)));
  }
  return names.get(task) ?? task;
}

/**
 * The name of a custom puzzle, also of one that has none or is not read yet.
 * @param {{ name?: string | null } | null | undefined} scene
 */
export function sceneName(scene) {
  return scene?.name ?? text.puzzles.custom;
}
