// Where a ball that the model proposes comes from: the place, and in words.

import { chanceWords, percent } from "../model/chance-words.js";
import { valueAt } from "../model/map-summary.js";
import { text } from "../text/text.js";

/** @typedef {import("../pkg/pathlight.js").TriedProposal} Proposal */

/**
 * @param {Proposal} proposal
 * @param {Float32Array} [placement] the placement map, if there is one
 */
export function originWords({ origin }, placement) {
  const words = text.panels.proposals.origin;
  switch (origin.kind) {
    case "perturbed":
      return words.perturbed(origin.number);
    case "success":
      return words.success(origin.probability);
    case "uniform":
      return words.uniform;
    case "map":
      return words.map(placement ? valueAt(placement, [origin.x, origin.y]) : null, origin.x, origin.y);
    case "imagined": {
      const { prior, probability, lowered_by: number } = origin;
      if (number === null) return words.likeliest(chanceWords(probability));
      return words.lowered(percent(prior), number, percent(probability));
    }
  }
}

/**
 * The place that a ball comes from, px, or null.
 * @param {Proposal} proposal
 * @param {Proposal[]} before those before it
 * @returns {[x: number, y: number] | null}
 */
export function sourceOf({ origin }, before) {
  if (origin.kind === "map") return [origin.x, origin.y];
  if (origin.kind !== "perturbed") return null;
  const [x, y] = before[origin.number - 1].ball;
  return [x, y];
}
