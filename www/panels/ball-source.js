// Says which earlier puzzle led the model to its ball, with a link to a task.

import { templateOf } from "../puzzles/templates.js";
import { text } from "../text/text.js";

/** @typedef {import("../model/model-memory.js").Source} Source */

/**
 * Shows it in a line, or nothing. Returns whether there is something new to read.
 * @param {HTMLElement} line
 * @param {Source | null} source
 * @param {(task: string) => string | null} hrefOf the address of a puzzle, or null if there is no way to it
 */
export function showSource(line, source, hrefOf) {
  const [before, after] = source ? text.panels.remembers.source(source.mirrored) : ["", ""];
  const name = source ? nameOf(source) : "";
  // What is the same stays, for the link may have the focus.
  if (line.textContent === before + name + after) return false;
  const href = source?.task ? hrefOf(source.task) : null;
  const named = document.createElement(href ? "a" : "span");
  if (href) named.setAttribute("href", href);
  named.textContent = name;
  line.replaceChildren(...(source ? [before, named, after] : []));
  return source !== null;
}

/** @param {Source} source */
function nameOf({ task, name }) {
  const { custom, puzzle } = text.panels.remembers;
  const template = task === null ? undefined : templateOf(task);
  return template && task ? puzzle(template.name, template.tasks.indexOf(task) + 1) : custom(name);
}
