// The rows of the table of our agents beside what others have published.

import { AGENTS } from "../model/results.js";
import { text } from "../text/text.js";
import { createCell } from "../widgets/dom.js";

/** @param {import("../model/results.js").Results["compared"]} compared */
export function ourRows({ ours, random_scenes: withRandom }) {
  const rows = AGENTS.flatMap((name) => {
    const found = ours.find(({ agent }) => agent === name);
    return found ? [row(found.auccess, text.results.namedAgent(name, text.model.agents[name]))] : [];
  });
  return withRandom ? [row(withRandom, text.results.beside.withRandom), ...rows] : rows;
}

/** @param {import("../model/results.js").Results["compared"]["published"]} published */
export function publishedRows(published) {
  return published.map(({ method, source, url, auccess }) => {
    const link = document.createElement("a");
    link.href = url;
    link.textContent = source;
    return row(auccess, method && `${method}, `, link);
  });
}

/**
 * The rows of the table of the paper's nets, a template each: published and ours, within and then cross.
 * @param {import("../pkg/pathlight.js").Template[]} templates
 * @param {{ published: string[], ours: string[] }[]} setups
 */
export function paperRows(templates, setups) {
  return templates.map(({ name }, index) =>
    row(
      setups.flatMap(({ published, ours }) => [published[index], ours[index]]),
      name,
    ),
  );
}

/**
 * @param {string[]} auccess as it is published, with as many decimals
 * @param {(string | Node)[]} name
 */
function row(auccess, ...name) {
  const head = document.createElement("th");
  head.scope = "row";
  head.append(...name);
  const created = document.createElement("tr");
  const local = (/** @type {string} */ number) => text.format.number(Number(number), number.includes(".") ? 1 : 0);
  created.append(head, ...auccess.map((words) => createCell(words.replace(/[\d.]+/g, local))));
  return created;
}
