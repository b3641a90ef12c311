// The panels of a puzzle. Tabs, links, what a link may hide and the dialog for lessons derive from this list; what a
// panel shows and does is in its module, which element/panel-components.js lists; its name is in the catalogue. Knows
// nothing of the document.

import { MAPS } from "../shell/constants.js";

/** @typedef {import("../pkg/pathlight.js").MapName} MapName */
/** @typedef {"play" | "imagine" | "compare" | "predict" | "map" | "make"} Panel */

/**
 * `tab`: the panel in whose tab this one is a part; it has a tab of its own if there is none. `below`: it opens below
 * the others of its tab, not in their place. `tool`: what a pointer does in the scene; it places the ball if nothing is
 * said. `maps`: those that may lie over the scene here; if nothing is said, all that the person has switched on, but
 * none of the story's.
 * @typedef {object} PanelFacts
 * @property {Panel} name in links
 * @property {Panel} [tab]
 * @property {boolean} [below]
 * @property {import("../play/shown.js").Tool} [tool]
 * @property {readonly MapName[]} [maps]
 */

/**
 * In the order in which a link names them.
 * @type {readonly PanelFacts[]}
 */
export const PANELS = [
  { name: "play" },
  { name: "imagine", maps: MAPS },
  { name: "compare", tab: "play", below: true },
  // Maps would tell the answer while the player draws a prediction.
  { name: "predict", tab: "imagine", tool: "line", maps: [] },
  { name: "map", tab: "imagine", maps: ["placement"] },
  { name: "make", tool: "bodies", maps: [] },
];

/** The panels that have a tab. */
export const TABS = PANELS.filter(({ tab }) => !tab);

/** @param {Panel} name */
export function factsOf(name) {
  return /** @type {PanelFacts} */ (PANELS.find((panel) => panel.name === name));
}

/**
 * The panel in whose tab a panel is.
 * @param {Panel} name
 * @returns {Panel}
 */
export function tabOf(name) {
  return factsOf(name).tab ?? name;
}

/**
 * The panels of a tab.
 * @param {Panel} tab
 */
export function partsOf(tab) {
  return PANELS.filter(({ name }) => tabOf(name) === tab);
}
