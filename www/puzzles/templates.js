// The templates of the benchmark and all their tasks.

import { TEMPLATES } from "../pkg/constants.js";

export { TEMPLATES };
/** The 2,500 tasks. */
export const TASKS = TEMPLATES.flatMap(({ tasks }) => tasks);

/**
 * The template of a task; undefined if the benchmark has none of this name.
 * @param {string} task
 */
export function templateOf(task) {
  return TEMPLATES.find(({ id }) => task.startsWith(id));
}
