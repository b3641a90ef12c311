// What models are, in words, and whether a model has seen a puzzle. Knows nothing of the document.

/** What agents are called where their results stand. */
export const AGENT_NAMES = /** @type {Record<string, string>} */ ({
  online: "the model as it plays here: it learns from its attempts",
  dynamics: "the same without learning from its attempts",
  success: "the success net alone",
  paper: "the paper’s four nets alone",
  random: "random balls",
});

/**
 * What kind of puzzles a model knows.
 * @param {{ setup: import("../pkg/pathlight.js").Setup }} card
 */
export function modelWords({ setup }) {
  return setup === "within" ? "knows all 25 kinds of puzzles" : "knows 20 of the 25 kinds of puzzles";
}

/**
 * @param {boolean} seen was the model trained on the puzzle?
 */
export function seenWords(seen) {
  return seen ? "practised this one" : "new to the model";
}
