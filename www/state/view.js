// What the page shows for a state: of what the address names, what is not hidden and belongs to the panel that is
// shown. Knows nothing of the document.

import { MAPS } from "../shell/constants.js";
import { PANELS } from "./url-state.js";

/** @typedef {import("../pkg/pathlight.js").MapName} MapName */
/** @typedef {import("./url-state.js").Panel} Panel */
/** @typedef {import("./url-state.js").State} State */

/**
 * What is on the page: the state, but `panel` is the one that is shown, which is never hidden, and `layers` are those
 * that lie over the scene there; `checkedLayers` are those that the address names. `forecast` is whether it is seen
 * there.
 * @typedef {State & { checkedLayers: MapName[] }} View
 */

/**
 * The panels that are not hidden; Play if all are.
 * @param {State} state
 * @returns {Panel[]}
 */
export function visiblePanels({ hide }) {
  const visible = PANELS.filter((name) => !hide.includes(name));
  return visible.length > 0 ? visible : ["play"];
}

/**
 * What the page shows for a state.
 * @param {State} state
 * @returns {View}
 */
export function viewOf(state) {
  const panel = shownPanel(state);
  // It belongs to placing the ball; in Predict it would reveal the answer.
  const forecast =
    state.forecast &&
    panel === "play" &&
    !["forecast", "imagine"].some((part) => state.hide.some((one) => one === part));
  return { ...state, panel, forecast, layers: visibleLayers(state, panel), checkedLayers: state.layers };
}

/**
 * The panel that is shown. In the presentation none is seen, but the story is Imagine's, and without it the ball is
 * placed as in Play.
 * @param {State} state
 * @returns {Panel}
 */
function shownPanel(state) {
  const panels = visiblePanels(state);
  if (state.view === "presentation") return state.step && panels.includes("imagine") ? "imagine" : "play";
  return panels.includes(state.panel) ? state.panel : panels[0];
}

/**
 * The maps that lie over the scene in a panel.
 * @param {State} state
 * @param {Panel} panel
 * @returns {MapName[]}
 */
function visibleLayers({ hide, layers, step, view }, panel) {
  if (hide.includes("imagine")) return [];
  if (view === "presentation" && step) return MAPS.filter((one) => one === step);
  switch (panel) {
    case "imagine":
      return layers;
    case "map":
      return layers.filter((layer) => layer === "placement");
    case "predict":
      // They would reveal the answer while the player draws a prediction.
      return [];
    default:
      // Those that the person switched on stay to be played by; the one of a walkthrough's step does not.
      return step ? [] : layers;
  }
}
