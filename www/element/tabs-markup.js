// The tabs and what each of them shows, made from the list of panels. What a panel shows is in its own element, which
// has its name as id; only Play is filled from the beginning.

import { playMarkup } from "../play/play-markup.js";
import { TABS, partsOf } from "../state/panels.js";
import { text } from "../text/text.js";

/** @typedef {import("../state/panels.js").PanelFacts} PanelFacts */

/** @param {PanelFacts} tab */
const tabMarkup = ({ name }) =>
  `<button type="button" role="tab" id="tab-${name}" aria-controls="tabpanel-${name}">${text.element.panels[name]}</button>`;

/** @param {PanelFacts} tab */
function panelMarkup({ name }) {
  const parts = partsOf(name);
  const inPlace = parts.filter(({ below }) => !below);
  return `<div role="tabpanel" id="tabpanel-${name}" aria-labelledby="tab-${name}" tabindex="0" hidden>
    ${inPlace.length > 1 ? `<div class="parts" id="parts-${name}" role="group" aria-label="${text.element.parts}">${inPlace.map(openerMarkup).join("")}</div>` : ""}
    ${parts.map(partMarkup).join("")}
  </div>`;
}

/** @param {PanelFacts} part */
const openerMarkup = ({ name, below }) =>
  `<button type="button" class="${below ? "opener" : ""}" id="open-${name}" aria-controls="${name}" data-hideable="${name}">${openerLabel(name)}</button>`;

/**
 * A part that has the name of its tab is called otherwise inside of it.
 * @param {import("../state/panels.js").Panel} name
 */
const openerLabel = (name) => (name === "imagine" ? text.element.insideOf.imagine : text.element.panels[name]);

/** @param {PanelFacts} part */
const partMarkup = (part) =>
  `${part.below ? openerMarkup(part) : ""}<div class="part" id="${part.name}" hidden>${part.name === "play" ? playMarkup() : ""}</div>`;

export function tabsMarkup() {
  const { tabs, more } = text.element;
  return `
<div class="tab-row">
  <div class="tabs" id="tabs" role="tablist" aria-label="${tabs}">${TABS.map(tabMarkup).join("")}</div>
  <button type="button" id="more-button" popovertarget="more" title="${more.title}" aria-label="${more.title}" data-hideable="fields imagine compare attempts"><svg><use href="#icon-more"/></svg></button>
</div>
${TABS.map(panelMarkup).join("")}
`;
}
