// The names beside the balls of a run, and whether it is the model's. Knows nothing of the document.

import { text } from "../text/text.js";

/** @typedef {Pick<import("./session.js").Session, "state">} Showing */

/**
 * The names of the balls, in their order: none for a person's run alone.
 * @param {Showing} session
 * @returns {string[]}
 */
export function namesOf(session) {
  const { state } = session;
  const { you, model } = text.play.panel;
  if (isModels(session)) return [model];
  if (state.kind !== "compare" || state.pair[0].author === state.pair[1]?.author) return [];
  return state.pair.map(({ author }) => (author === "player" ? you : model));
}

/**
 * Is the run that is shown the model's alone? Somebody's attempt from a file is not.
 * @param {Showing} session
 */
export function isModels({ state }) {
  return state.kind === "attempt" && state.attempt.author === "model" && !state.attempt.opened;
}
