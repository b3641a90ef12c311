// The templates of the benchmark and all their tasks.

import { TEMPLATES as FACTS } from "../pkg/constants.js";
import { text } from "../text/text.js";

/** The templates with their tasks; names and stories are in the language of the page. */
export const TEMPLATES = FACTS.map(({ id, tasks }) => ({
  id,
  tasks,
  get name() {
    return text.kinds[id].name;
  },
  get story() {
    return text.kinds[id].story;
  },
}));
/** The 2,500 tasks. */
export const TASKS = TEMPLATES.flatMap(({ tasks }) => tasks);

/**
 * The template of a task; undefined if the benchmark has none of this name.
 * @param {string} task
 */
export function templateOf(task) {
  return TEMPLATES.find(({ id }) => task.startsWith(id));
}
