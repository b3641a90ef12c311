// How fast a run is played: slowly around the touch that decides, fast where nothing moves. Pure.

import { STEPS_PER_SECOND } from "../shell/constants.js";

/** @typedef {Pick<import("../pkg/pathlight.js").Moments, "quiet" | "deciding">} Paced */

/** How many times as fast a stretch is played in which nothing moves. */
const IDLE = 5;
/** A part of it is played in real time, so that the eye sees that everything has come to rest, steps. */
const REST = 0.4 * STEPS_PER_SECOND;
/** How many times as fast the deciding touch is played. */
const SLOW = 0.3;
/** The steps before and after it that are slow. */
const BEFORE = 10;
const AFTER = 6;

/**
 * How many times as fast as in real time a step is played.
 * @param {Paced} moments
 * @param {number} step
 */
export function paceAt(moments, step) {
  const { deciding } = moments;
  if (deciding !== null && step >= deciding - BEFORE && step < deciding + AFTER) return SLOW;
  return quietEnd(moments, step) === null ? 1 : IDLE;
}

/**
 * The end of the stretch in which nothing moves at a step; null if something does.
 * @param {Paced} moments
 * @param {number} step
 */
export function quietEnd({ quiet }, step) {
  const stretch = quiet.find(([first, last]) => step >= first + REST && step < last);
  return stretch ? stretch[1] : null;
}
