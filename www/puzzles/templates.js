// The templates of the benchmark and all their tasks, read from the wasm once.

import { pathlight } from "../shell/pathlight.js";

/** @typedef {import("../pkg/pathlight.js").Template} Template */

/** The 25 templates, each with its 100 tasks. */
export const TEMPLATES = pathlight.templates();
/** The 2,500 tasks. */
export const TASKS = TEMPLATES.flatMap(({ tasks }) => tasks);

/**
 * The template of a task; undefined if the benchmark has none of this name.
 * @param {string} task
 */
export function templateOf(task) {
  return TEMPLATES.find(({ id }) => task.startsWith(id));
}
