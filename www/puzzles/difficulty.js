// How hard the puzzles are, in words, and which one is next by that.

import { pathlight } from "../shell/page-api.js";
import { text } from "../text/text.js";
import { TASKS } from "./templates.js";

/** The least solve rates of puzzles that are called easy, and medium. */
const EASY = 0.02;
const MEDIUM = 0.004;
/**
 * A puzzle is a little harder than another if its solve rate is this many times the other’s; a little easier, if the
 * other way round.
 */
const LITTLE = { most: 0.75, least: 0.35 };

/**
 * The solve rates of all tasks, once one has been asked for.
 * @type {Map<string, number> | null}
 */
let rates = null;

/**
 * The share of valid balls that solve a puzzle, 0..1.
 * @param {string} task
 */
export function solveRateOf(task) {
  rates ??= new Map(Array.from(pathlight.solveRates(), (rate, index) => [TASKS[index], rate]));
  return rates.get(task) ?? 0;
}

/**
 * @param {number} rate of solving balls
 * @returns {import("../text/en/puzzles.js").Difficulty}
 */
function difficultyOf(rate) {
  return rate >= EASY ? "easy" : rate >= MEDIUM ? "medium" : "hard";
}

/** @param {number} rate of solving balls */
export function difficultyName(rate) {
  return text.puzzles.difficulties[difficultyOf(rate)];
}

/**
 * "medium: about 1 ball in 120 solves it".
 * @param {string} task
 */
export function difficultyWords(task) {
  const { solve_rate: rate, balls } = pathlight.difficulty(task);
  const { oneInSolves, fewerSolve, howHard } = text.puzzles;
  return howHard(difficultyOf(rate), rate > 0 ? oneInSolves(1 / rate) : fewerSolve(balls));
}

/**
 * The next puzzle of another kind that is a little harder, or easier: the first after `task` in the order of `tasks`,
 * and then from their beginning. Null if there is none.
 * @param {string} task
 * @param {string[]} tasks those to choose from
 * @param {"harder" | "easier"} by
 */
export function nextByDifficulty(task, tasks, by) {
  const rate = solveRateOf(task);
  /** @param {string} other */
  const fits = (other) => {
    const [lower, higher] = by === "harder" ? [solveRateOf(other), rate] : [rate, solveRateOf(other)];
    return (
      kindOf(other) !== kindOf(task) && lower <= LITTLE.most * higher && lower >= LITTLE.least * higher && higher > 0
    );
  };
  const candidates = tasks.filter(fits);
  return candidates.find((other) => other > task) ?? candidates[0] ?? null;
}

/**
 * The template of a task.
 * @param {string} task
 */
export function kindOf(task) {
  return task.split(":")[0];
}
