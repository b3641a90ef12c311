// What the page says of puzzles that the model has played with a memory and without, and when each try is shown. Knows
// nothing of the document.

import { templateOf } from "../puzzles/templates.js";
import { text } from "../text/text.js";

/** @typedef {import("../pkg/pathlight.js").Reminder} Reminder */

/**
 * A puzzle that was played twice: the try, from 1, that solved it with the memory, and without; null if none did.
 * `reminder` is what the ball of the last try with the memory owes to an earlier puzzle.
 * @typedef {{ task: string, learned: number | null, fresh: number | null, reminder: Reminder | null }} Played
 */
/**
 * A try that is shown, from 1, and from when to when, s.
 * @typedef {{ number: number, start: number, end: number }} ShownTry
 */

/** Tries before the last that are shown. */
const MOST_SHOWN = 5;
/** How long the last try is shown, and how long all before it together at most, s. */
const LAST = 1.1;
const BEFORE = 1;
/** How long one of them is shown at most, s. */
const ONE = 0.4;
/** Puzzles of which the curve shows the geometric mean. */
const WINDOW = 5;

/**
 * Which of some tries are shown, and when: the last at length, a few before it in short.
 * @param {number} count
 * @returns {ShownTry[]}
 */
export function shownTries(count) {
  const before = Math.min(count - 1, MOST_SHOWN);
  const each = before ? Math.min(BEFORE / before, ONE) : 0;
  const shown = Array.from({ length: before }, (_, index) => ({
    number: 1 + Math.round((index * (count - 1)) / before),
    start: index * each,
    end: (index + 1) * each,
  }));
  return [...shown, { number: count, start: before * each, end: before * each + LAST }];
}

/**
 * For each puzzle the geometric mean of its tries and of those of the few before it.
 * @param {number[]} tries
 */
export function runningMeans(tries) {
  return tries.map((_, index) => {
    const latest = tries.slice(Math.max(index + 1 - WINDOW, 0), index + 1);
    return Math.exp(latest.reduce((sum, count) => sum + Math.log(count), 0) / latest.length);
  });
}

/**
 * Which puzzle helped, like ", helped by puzzle 3"; empty if none did.
 * @param {Played} played
 * @param {string[]} earlier the tasks of its kind that were played before it, in order
 */
export function reminderWords({ task, learned, reminder }, earlier) {
  if (learned === null || !reminder?.solved || !reminder.task || reminder.change < 0) return "";
  const place = earlier.indexOf(reminder.task) + 1;
  const { same, other } = text.learns.helped;
  if (place) return same(place, reminder.mirrored);
  const template = templateOf(reminder.task);
  const kind = template === templateOf(task) ? "" : (template?.name ?? "");
  return other(kind, reminder.task, reminder.mirrored);
}

/**
 * A puzzle in a sentence.
 * @param {Played} played
 * @param {string[]} earlier the tasks of its kind that were played before it, in order
 * @param {number} limit
 */
export function playedWords(played, earlier, limit) {
  return text.learns.played(played.learned, played.fresh, limit, reminderWords(played, earlier));
}

/**
 * All puzzles in a sentence.
 * @param {Played[]} all
 * @param {number} limit
 */
export function totalWords(all, limit) {
  const sum = (/** @type {(number | null)[]} */ firsts) =>
    firsts.reduce((/** @type {number} */ sum, first) => sum + (first ?? limit), 0);
  return text.learns.total(all.length, sum(all.map(({ learned }) => learned)), sum(all.map(({ fresh }) => fresh)));
}
