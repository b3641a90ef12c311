// Where a ball that the model proposes comes from: the place, and in words.

import { chanceWords, percent } from "../model/chance-words.js";
import { valueAt } from "../model/map-summary.js";

/** @typedef {import("../pkg/pathlight.js").TriedProposal} Proposal */

/**
 * @param {Proposal} proposal
 * @param {Float32Array} [placement] the placement map, if there is one
 */
export function originWords({ origin }, placement) {
  if (origin.kind === "perturbed") return `Ball ${origin.number}, moved at random.`;
  if (origin.kind === "imagined") return imaginedWords(origin);
  if (origin.kind === "success")
    return `The success net: after what was tried before, this ball has the highest probability of solving, ${Math.round(100 * origin.probability)} %.`;
  if (origin.kind === "uniform") return "Random: the placement map shows no place where a ball may be.";
  const { x, y } = origin;
  const value = placement ? ` it is ${valueAt(placement, [x, y]).toFixed(2)} at x ${x}, y ${y}.` : "";
  return `The placement map:${value} From there the ball was moved to cover more of the map.`;
}

/**
 * Why a ball that was imagined is next.
 * @param {Extract<Proposal["origin"], { kind: "imagined" }>} origin
 */
function imaginedWords({ prior, probability, lowered_by: number }) {
  if (number === null)
    return `By what the model imagines it was the likeliest to solve the puzzle of all balls not tried yet: ${chanceWords(probability)}.`;
  return `By what the model imagines its chance was ${percent(prior)} before the first attempt. Then ball ${number} failed, and it resembles this one, by where it starts or by what happened: ${percent(probability)}, but still the likeliest of those left.`;
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
