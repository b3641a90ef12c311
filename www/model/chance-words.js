// What the model imagines for a ball, in words: how likely the ball solves the puzzle, and how far the imagined paths
// are from the real ones. Knows nothing of the document.

/** @typedef {import("../pkg/pathlight.js").ImaginedBall} ImaginedBall */

/**
 * Words for probabilities below a bound.
 * @type {[below: number, words: string][]}
 */
const WORDS = [
  [0.05, "almost surely won’t work"],
  [0.3, "probably won’t work"],
  [0.45, "may not work"],
  [0.55, "could go either way"],
  [0.7, "may work"],
  [0.95, "probably works"],
  [Infinity, "almost surely works"],
];

/**
 * A probability as words and number, like "almost surely won’t work (3 %)".
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
 * How far the imagined path of the green object is from the real one, as a sentence.
 * @param {ImaginedBall} imagined
 * @param {Pick<ImaginedBall, "object">} real
 */
export function errorWords({ steps, object }, { object: real }) {
  const distances = Array.from(steps, (_, index) =>
    Math.hypot(object[2 * index] - real[2 * index], object[2 * index + 1] - real[2 * index + 1]),
  );
  return `Its path for green was ${pixels(mean(distances))} off, on average.`;
}

/** @param {number[]} values */
function mean(values) {
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}

/** @param {number} distance px */
function pixels(distance) {
  return `${Math.max(1, Math.round(distance))} px`;
}
