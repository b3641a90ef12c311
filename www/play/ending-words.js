// How an attempt ended, as a phrase: "touched for 1.4 s, then lost". Knows nothing of the document.

import { STEPS_PER_SECOND } from "../shell/constants.js";
import { text } from "../text/text.js";

/** Shorter than this is a moment, s. */
const MOMENT = 0.05;

/** @param {import("../pkg/pathlight.js").Ending} ending */
export function endingWords({ solved, steps, longest_touch, final_touch }) {
  const words = text.play.ending;
  const time = (/** @type {number} */ count) =>
    count / STEPS_PER_SECOND < MOMENT ? words.moment : text.play.time(count / STEPS_PER_SECOND);
  if (solved) return words.solved(time(steps));
  if (longest_touch === 0) return words.never;
  return final_touch > 0 ? words.touching(time(final_touch)) : words.lost(time(longest_touch));
}
