// Whose balls a scene shows: their names beside them, and whether the model plays. Knows nothing of the document.

import { text } from "../text/text.js";

/** @typedef {Pick<import("./session.js").Session, "state">} Showing */

/**
 * Whose ball is whose: of the model's, and of a person's and the model's that run over each other. A person's alone
 * needs no name.
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
