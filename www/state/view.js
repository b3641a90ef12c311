// What the page shows for a state: of what the address names, what is not hidden and belongs to the panel that is
// shown. Knows nothing of the document.

import { PANELS, TABS, factsOf, tabOf } from "./panels.js";

/** @typedef {import("../pkg/pathlight.js").MapName} MapName */
/** @typedef {import("./panels.js").Panel} Panel */
/** @typedef {import("./url-state.js").State} State */
/** @typedef {import("./url-state.js").Step} Step */

/**
 * What is on the page: the state, but `panel` is the one that is shown, which is never hidden, in the tab `tab`, and
 * `layers` are those that lie over the scene there; `checkedLayers` are those that are switched on. `forecast` is
 * whether it is seen there.
 * @typedef {State & { tab: Panel, layers: MapName[], checkedLayers: MapName[], forecast: boolean }} View
 */

/**
 * What Imagine lays over the scene when nobody has chosen maps: where green should go, and what red must do for that.
 * @type {MapName[]}
 */
const FIRST_LAYERS = ["target", "action"];

/**
 * The maps that each step of the story lays over the scene.
 * @type {Record<Step, MapName[]>}
 */
export const STEP_LAYERS = {
  base: ["base"],
  target: ["target"],
  action: ["action"],
  placement: ["placement", "success"],
  imagined: [],
  run: [],
};

/**
 * The panels that are not hidden; Play if all are.
 * @param {State} state
 * @returns {Panel[]}
 */
export function visiblePanels({ hide }) {
  const visible = PANELS.map(({ name }) => name).filter((name) => !hide.includes(name));
  return visible.length > 0 ? visible : ["play"];
}

/**
 * What the tabs open that are not hidden: of each the first panel that is not.
 * @param {State} state
 * @returns {Panel[]}
 */
export function visibleTabs(state) {
  const visible = visiblePanels(state);
  return TABS.flatMap(({ name }) => visible.find((panel) => tabOf(panel) === name) ?? []);
}

/**
 * What the page shows for a state.
 * @param {State} state
 * @param {boolean} [guess] does the person like to see the model's guess?
 * @returns {View}
 */
export function viewOf(state, guess = false) {
  const panel = shownPanel(state);
  const tab = tabOf(panel);
  // Whoever is challenged plays alone.
  const wanted = state.forecast ?? (guess && state.challenge === null && state.view === null);
  // It belongs to placing the ball; in Predict it would reveal the answer.
  const forecast =
    wanted && tab === "play" && !["forecast", "imagine"].some((part) => state.hide.some((one) => one === part));
  const own = state.step ? STEP_LAYERS[state.step] : FIRST_LAYERS;
  const checkedLayers = state.layers ?? (panel === "imagine" ? own : []);
  return { ...state, panel, tab, forecast, layers: visibleLayers(state, panel, checkedLayers), checkedLayers };
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
 * @param {MapName[]} layers those that are switched on
 * @returns {MapName[]}
 */
function visibleLayers({ hide, step, view }, panel, layers) {
  if (hide.includes("imagine")) return [];
  if (view === "presentation" && step) return STEP_LAYERS[step];
  const { maps } = factsOf(panel);
  if (maps) return layers.filter((layer) => maps.includes(layer));
  // In Play, maps that the person switched on stay; that of a step of the story does not.
  return step ? [] : layers;
}

/**
 * What changes when the presentation begins: the story begins with the goal, unless the person was in the middle of it.
 * @param {Pick<State, "step" | "panel">} state
 * @returns {Partial<State>}
 */
export function withPresentation({ step, panel }) {
  return { view: "presentation", step: panel === "imagine" ? step : null };
}

/**
 * What changes when the presentation is left: a story goes on in its panel.
 * @param {Pick<State, "step">} state
 * @returns {Partial<State>}
 */
export function withoutPresentation({ step }) {
  return step ? { view: null, panel: "imagine" } : { view: null };
}
