// Why a ball may not be placed, as a phrase: "the ball overlaps the black bar". Knows nothing of the document.

import { text } from "../text/text.js";

/**
 * @param {import("../pkg/pathlight.js").InvalidBall} reason
 * @param {import("../pkg/pathlight.js").Scene} scene
 */
export function invalidWords(reason, { bodies }) {
  const words = text.play.invalid;
  return reason.kind === "overlaps" ? words.overlaps(bodies[reason.body]) : words[reason.kind];
}
