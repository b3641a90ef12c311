// The puzzle of the day: from the date alone, the same for everybody, without a server.

import { solveRateOf } from "../puzzles/difficulty.js";

/** A puzzle of the day is solved by at least this share of the valid balls, so that it is never too hard. */
const LEAST_SOLVE_RATE = 0.01;
/**
 * A prime: each day’s puzzle lies this many places after the last one’s, so that kinds alternate and none comes twice
 * before all have come.
 */
const STRIDE = 7919;
/** ms */
const DAY = 86_400_000;

/**
 * The puzzle of a day of the person’s own calendar.
 * @param {Date} date
 * @param {string[]} tasks all tasks of the benchmark
 */
export function taskOfDay(date, tasks) {
  const possible = tasks.filter((task) => solveRateOf(task) >= LEAST_SOLVE_RATE);
  const day = Date.UTC(date.getFullYear(), date.getMonth(), date.getDate()) / DAY;
  return possible[(day * STRIDE) % possible.length];
}
