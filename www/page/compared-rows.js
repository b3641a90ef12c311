// The rows of the table of our agents beside what others have published.

import { AGENTS } from "../model/results.js";
import { text } from "../text/text.js";
import { createCell } from "../widgets/dom.js";
import { fragmentOf } from "../element/markup.js";

/** @param {import("../model/results.js").Results["compared"]} compared */
export function ourRows({ ours, online_with_other_data: otherData }) {
  const rows = AGENTS.flatMap((name) => {
    const found = ours.find(({ agent }) => agent === name);
    return found ? [row(found.auccess, text.results.namedAgent(name, text.model.agents[name]))] : [];
  });
  if (!otherData.some(Boolean)) return rows;
  const auccess = otherData.map((measured) => measured ?? "–");
  return [row(auccess, text.results.beside.otherData), ...rows];
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
 * Returns the content of a `details` with the table of the paper's nets: a row for each template, with the published
 * and our auccess within, then cross.
 * @param {import("../pkg/pathlight.js").Template[]} templates
 * @param {{ published: string[], ours: string[] }[]} setups
 */
export function paperNets(templates, setups) {
  const { byKind, within, cross } = text.results.beside;
  const columns = `<th scope="col">${byKind.published}<th scope="col">${byKind.ours}`;
  const parts = fragmentOf(
    `<summary id="results-by-kind">${byKind.title}</summary><p>${byKind.about}</p>
    <div class="wide" tabindex="0" role="group" aria-labelledby="results-by-kind"><table class="beside">
    <thead><tr><th scope="col" rowspan="2">${byKind.kind}<th colspan="2" scope="colgroup">${within}<th colspan="2" scope="colgroup">${cross}
    <tr>${columns}${columns}<tbody></table></div>`,
  );
  parts.querySelector("tbody")?.append(
    ...templates.map(({ name }, index) =>
      row(
        setups.flatMap(({ published, ours }) => [published[index], ours[index]]),
        name,
      ),
    ),
  );
  return parts;
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
