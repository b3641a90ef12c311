// What a state shows (a puzzle, the home page, or what stands instead of it), and the addresses of other puzzles and
// views, which keep the model and what is hidden.

import { INITIAL_STATE, PAGE_VIEWS, formatFragment } from "./url-state.js";

/** @typedef {import("./url-state.js").State} State */
/** @typedef {import("./url-state.js").PageView} PageView */
/** @typedef {import("./panels.js").Panel} Panel */

/**
 * Whether a state shows a puzzle: a task or a custom scene.
 * @param {State} state
 */
export function showsPuzzle({ task, scene }) {
  return task !== null || scene !== null;
}

/**
 * Whether a state shows the home page.
 * @param {State} state
 */
export function showsHome(state) {
  return !showsPuzzle(state) && pageViewOf(state) === null && !state.hide.includes("puzzles");
}

/**
 * What a state shows instead of the home page, or null.
 * @param {State} state
 */
export function pageViewOf(state) {
  const view = PAGE_VIEWS.find((view) => view === state.view);
  return view && !showsPuzzle(state) && pageViewHref(view, state) !== null ? view : null;
}

/**
 * The address of what is shown instead of the home page. Null if the link that the person came by hides the puzzles
 * or the model.
 * @param {PageView} view
 * @param {State} state
 */
export function pageViewHref(view, { model, hide }) {
  if (hide.some((part) => part === "puzzles" || part === "imagine" || part === "compare")) return null;
  return `#${formatFragment({ ...INITIAL_STATE, view, model, hide })}`;
}

/**
 * The address of another puzzle (null: the home page) that keeps the model and what is hidden. Null if the link that
 * the person came by hides the ways to other puzzles.
 * @param {State} state
 * @param {string | null} task
 * @param {Panel} [panel]
 */
export function hrefOf({ model, hide }, task, panel = "play") {
  return hide.includes("puzzles") ? null : `#${formatFragment({ ...INITIAL_STATE, task, panel, model, hide })}`;
}
