// What the panel says of one of the model's balls. Knows nothing of the document.

import { chanceWords, errorWords } from "../model/chance-words.js";
import { endingWords } from "../play/ending-words.js";
import { sentence } from "../text/sentence.js";
import { text } from "../text/text.js";

/** @typedef {import("../model/ball-imaginer.js").BallImaginer} BallImaginer */

/**
 * What comes of the ball that is shown.
 * @param {NonNullable<import("../play/session.js").Session["shown"]>} shown
 * @param {boolean} tells is it also told that the model has not tried the ball in its turn?
 */
export function outcomeWords({ ending, tried }, tells) {
  const untried = tells && !tried ? text.panels.proposals.notTried : "";
  return `${ending.solved ? "✓" : "×"} ${sentence(endingWords(ending))} ${untried}`;
}

/**
 * What the model imagines for it, beside what really happens; nothing as long as one of them is missing.
 * @param {BallImaginer["answer"]} answer
 * @param {Parameters<typeof errorWords>[1] | undefined} real
 */
export function imaginedWords(answer, real) {
  if (!answer || !real) return "";
  return `${sentence(chanceWords(answer.imagined.probability))} ${errorWords(answer.imagined, real)}`;
}
