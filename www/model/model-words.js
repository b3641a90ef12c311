// What the shipped models are, in words, and whether a model has seen a puzzle. Knows nothing of the document.

/** What agents are called where their results stand. */
export const AGENT_NAMES = /** @type {Record<string, string>} */ ({
  online: "the model as it plays here: it learns from its attempts",
  dynamics: "the same without learning from its attempts",
  judge: "the judge alone",
  paper: "the paper’s four nets alone",
  random: "random balls",
});

/**
 * What kind of puzzles a model knows, by its name.
 * @param {string} name like "within-0"
 */
export function modelWords(name) {
  if (name.startsWith("within-")) return "has learned from other puzzles of all 25 kinds";
  if (name.startsWith("cross-")) return "has learned from 20 of the 25 kinds of puzzles";
  return "";
}

/**
 * @param {boolean} seen was the model trained on the puzzle?
 */
export function seenWords(seen) {
  return seen ? "seen in training" : "never seen";
}
