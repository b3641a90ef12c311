// What the model imagines for a ball, in words: how likely the ball solves the puzzle, and how far the imagined paths
// are from the real ones. Knows nothing of the document.

import { text } from "../text/text.js";

/** @typedef {import("../pkg/pathlight.js").ImaginedBall} ImaginedBall */

/**
 * Names for probabilities below a bound.
 * @type {[below: number, chance: import("../text/en/model.js").Chance][]}
 */
const CHANCES = [
  [0.05, "none"],
  [0.3, "little"],
  [0.45, "less"],
  [0.55, "even"],
  [0.7, "more"],
  [0.95, "good"],
  [Infinity, "full"],
];

/**
 * A probability as words and number, like "almost surely won’t work (3%)".
 * @param {number} probability 0..1
 */
export function chanceWords(probability) {
  const [, chance] = CHANCES.find(([below]) => probability < below) ?? CHANCES[CHANCES.length - 1];
  return text.model.chance(chance, percent(probability));
}

/**
 * A probability in percent, never as none or all.
 * @param {number} probability 0..1
 */
export function percent(probability) {
  if (probability < 0.01) return text.model.hardlyAny();
  return probability > 0.99 ? text.model.nearlyAll() : text.format.percent(probability);
}

/**
 * How far the imagined path of the green object is from the real one, as a sentence.
 * @param {ImaginedBall} imagined
 * @param {Pick<ImaginedBall, "object">} real
 */
export function errorWords({ steps, object }, { object: real }) {
  const distances = Array.from(steps, (_, index) =>
    Math.hypot(object[2 * index] - real[2 * index], object[2 * index + 1] - real[2 * index + 1]),
  );
  const mean = distances.reduce((sum, distance) => sum + distance, 0) / distances.length;
  return text.model.off(Math.max(1, Math.round(mean)));
}
