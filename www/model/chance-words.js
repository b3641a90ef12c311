// What the model imagines for a ball, in words: how likely the ball solves the puzzle, and how far the imagined paths
// are from the real ones. Knows nothing of the document.

/** @typedef {import("../pkg/pathlight.js").ImaginedBall} ImaginedBall */

/**
 * Words for probabilities below a bound.
 * @type {[below: number, words: string][]}
 */
const WORDS = [
  [0.05, "very unlikely"],
  [0.3, "unlikely"],
  [0.45, "rather unlikely"],
  [0.55, "even odds"],
  [0.7, "rather likely"],
  [0.95, "likely"],
  [Infinity, "very likely"],
];

/**
 * A probability as words and number, like "very unlikely (3 %)".
 * @param {number} probability 0..1
 */
export function chanceWords(probability) {
  const [, words] = WORDS.find(([below]) => probability < below) ?? WORDS[WORDS.length - 1];
  return `${words} (${percent(probability)})`;
}

/**
 * A probability in percent, never as none or all.
 * @param {number} probability 0..1
 */
export function percent(probability) {
  if (probability < 0.01) return "under 1 %";
  return probability > 0.99 ? "over 99 %" : `${Math.round(100 * probability)} %`;
}

/**
 * How far the model expects the imagined path of the green object to be from the real one, as a sentence.
 * @param {ImaginedBall} imagined
 */
export function expectedErrorWords({ steps, errors }) {
  return `Its paths may be ${pixels(mean(Array.from(errors.subarray(0, steps.length))))} off.`;
}

/**
 * How far it is from it, as a sentence.
 * @param {ImaginedBall} imagined
 * @param {Pick<ImaginedBall, "object">} real
 */
export function errorWords({ steps, object }, { object: real }) {
  const distances = Array.from(steps, (_, index) =>
    Math.hypot(object[2 * index] - real[2 * index], object[2 * index + 1] - real[2 * index + 1]),
  );
  return `It imagined the green object ${pixels(mean(distances))} from where it really was, on average.`;
}

/** @param {number[]} values */
function mean(values) {
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}

/** @param {number} distance px */
function pixels(distance) {
  return `${Math.max(1, Math.round(distance))} px`;
}
