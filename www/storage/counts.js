// How many attempts a contender has made at a task, and which solved it first. Older versions kept these numbers alone;
// now they are kept only for what the kept attempts do not tell.
//
// { "tasks": { "00007:013": { "attempts": 4, "solved": 3 } } }   "solved" is null as long as no attempt solved it

import { MAX_NUMBER, TASK, grouped, turnOf } from "./attempts.js";

/** @typedef {import("./attempts.js").KeptAttempt} KeptAttempt */
/** @typedef {{ attempts: number, solved: number | null }} TaskProgress */

/** @type {TaskProgress} */
export const UNTRIED = Object.freeze({ attempts: 0, solved: null });

/** What is known of each contender, by name, and then of each task. */
export class Counts {
  /** @type {Map<string, Map<string, TaskProgress>>} */
  #contenders = new Map();

  /**
   * @param {string} by
   * @param {string} task
   */
  of(by, task) {
    return this.#contenders.get(by)?.get(task) ?? UNTRIED;
  }

  /** The contenders of whom anything is known. */
  get names() {
    return [...this.#contenders.keys()];
  }

  /** @param {Counts} counts what is known from elsewhere */
  merge(counts) {
    for (const by of counts.names) for (const [task, progress] of counts.entries(by)) this.add(by, task, progress);
  }

  /**
   * Counts attempts that are not kept.
   * @param {KeptAttempt[]} gone
   * @param {KeptAttempt[]} all with those of their turns that are kept
   */
  addGone(gone, all) {
    const names = new Set(gone.map(turnOf));
    for (const [name, turn] of grouped(all, turnOf))
      if (names.has(name)) this.add(turn[0].by, turn[0].puzzle, progressOf(turn));
  }

  /**
   * The tasks of a contender, with the progress on each.
   * @param {string} by
   * @returns {[string, TaskProgress][]}
   */
  entries(by) {
    return [...(this.#contenders.get(by) ?? [])];
  }

  /**
   * Reads the entries of JSON that make sense.
   * @param {string} by
   * @param {any} tasks
   */
  read(by, tasks) {
    /** @type {(value: unknown, most: number) => boolean} */
    const isCount = (value, most) => Number.isSafeInteger(value) && Number(value) >= 1 && Number(value) <= most;
    for (const [task, progress] of Object.entries(/** @type {Record<string, any>} */ (Object(tasks)))) {
      const { attempts, solved } = Object(progress);
      if (isCount(attempts, MAX_NUMBER) && (solved === null || isCount(solved, attempts)))
        this.add(by, task, { attempts, solved });
    }
  }

  /**
   * Replaces what is known.
   * @param {string} by
   * @param {string} task
   * @param {TaskProgress} progress
   */
  set(by, task, progress) {
    const tasks = this.#contenders.get(by) ?? new Map();
    if (progress.attempts > 0) tasks.set(task, progress);
    else tasks.delete(task);
    if (tasks.size > 0) this.#contenders.set(by, tasks);
    else this.#contenders.delete(by);
  }

  /**
   * Adds what is known from elsewhere.
   * @param {string} by
   * @param {string} task
   * @param {TaskProgress} progress
   */
  add(by, task, progress) {
    if (TASK.test(task)) this.set(by, task, merge(this.of(by, task), progress));
  }
}

/**
 * The more attempts, and the earlier solution.
 * @param {TaskProgress} a
 * @param {TaskProgress} b
 * @returns {TaskProgress}
 */
export function merge(a, b) {
  const attempts = Math.max(a.attempts, b.attempts);
  return { attempts, solved: a.solved && b.solved ? Math.min(a.solved, b.solved) : (a.solved ?? b.solved) };
}

/**
 * What the attempts of one contender at one puzzle tell.
 * @param {KeptAttempt[]} attempts
 * @returns {TaskProgress}
 */
export function progressOf(attempts) {
  let [number, solved] = [attempts.length, Infinity];
  for (const attempt of attempts) {
    number = Math.max(number, attempt.number);
    if (attempt.ending.solved) solved = Math.min(solved, attempt.number);
  }
  return { attempts: number, solved: Number.isFinite(solved) ? solved : null };
}
