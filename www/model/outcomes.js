// The outcomes of a model's balls: what became of each, in three kinds, and the list as comma-separated values. Knows
// nothing of the document.

import { STEPS_PER_SECOND } from "../shell/constants.js";
import { text } from "../text/text.js";
import { toCsv } from "./csv.js";

/** @typedef {import("../pkg/pathlight.js").TriedProposal} TriedProposal */
/** @typedef {"solved" | "touched" | "missed"} Outcome */

/**
 * What became of a ball: it solves, or the green object touches its goal for less than three seconds, or never.
 * @param {Pick<TriedProposal, "ending">} tried
 * @returns {Outcome}
 */
export function outcomeOf({ ending }) {
  if (ending.solved) return "solved";
  return ending.longest_touch > 0 ? "touched" : "missed";
}

/**
 * The index of the next ball with another outcome than that at an index; null if there is none in this direction.
 * @param {TriedProposal[]} tried
 * @param {number} index
 * @param {1 | -1} by
 */
export function otherOutcome(tried, index, by) {
  for (let other = index + by; other >= 0 && other < tried.length; other += by) {
    if (outcomeOf(tried[other]) !== outcomeOf(tried[index])) return other;
  }
  return null;
}

/**
 * The numbers of the outcomes, as a sentence.
 * @param {TriedProposal[]} tried
 */
export function outcomesWords(tried) {
  const count = (/** @type {Outcome} */ outcome) => tried.filter((one) => outcomeOf(one) === outcome).length;
  const words = text.model.outcomes;
  const solving = count("solved");
  if (tried.length === 1 && solving === 1) return words.first;
  return words.counted(tried.length, solving, count("touched"), count("missed"));
}

/**
 * The balls of a model on a task as comma-separated values, a line each; lengths in px and s, chances from 0 to 1.
 * @param {TriedProposal[]} tried
 * @param {{ task: string, model: string, seen: boolean, simulator: number }} about
 */
export function ballsCsv(tried, { task, model, seen, simulator }) {
  const names = [
    "task",
    "model",
    "seen_in_training",
    "simulator",
    "number",
    "x",
    "y",
    "r",
    "outcome",
    "longest_touch",
    "seconds",
    "origin",
    "chance",
    "chance_before",
    "lowered_by",
  ];
  const rows = tried.map((one, index) => {
    const { ball, ending, origin } = one;
    const chances =
      origin.kind === "imagined"
        ? [origin.probability, origin.prior, origin.lowered_by]
        : [origin.kind === "success" ? origin.probability : null, null, null];
    const seconds = [ending.longest_touch, ending.steps].map((steps) => (steps / STEPS_PER_SECOND).toFixed(2));
    return [task, model, seen, simulator, index + 1, ...ball, outcomeOf(one), ...seconds, origin.kind, ...chances];
  });
  return toCsv([names, ...rows]);
}
