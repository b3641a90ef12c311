// How many attempts an author has made at a task, and which solved it first: what the kept attempts do not tell,
// because they were deleted or there is no room for them. Older versions counted all attempts, in a key for each
// author.
//
// { "player": { "00007:013": { "attempts": 4, "solved": 3 } } }   "solved" is null as long as no attempt solved it

import { MAX_NUMBER, PLAYER, TASK, grouped, turnOf } from "./attempt-lines.js";

/** @typedef {import("./attempt-lines.js").KeptAttempt} KeptAttempt */
/** @typedef {{ attempts: number, solved: number | null }} TaskProgress */

const KEY = "counts";
const OLD_PLAYER_KEY = "progress";
const OLD_MODEL_KEY = "model.";

/** @type {TaskProgress} */
const UNTRIED = Object.freeze({ attempts: 0, solved: null });

export class Counts {
  /** @type {Map<string, TaskProgress>} by author and task */
  #entries = new Map();

  /** @param {Counts} [counts] that it begins with */
  constructor(counts) {
    if (counts) this.merge(counts);
  }

  /**
   * @param {string} by
   * @param {string} task
   */
  of(by, task) {
    return this.#entries.get(`${by} ${task}`) ?? UNTRIED;
  }

  /** Each author and task of which anything is known. */
  get all() {
    return [...this.#entries].map(([key, progress]) => {
      const [by, task] = key.split(" ");
      return { by, task, progress };
    });
  }

  /**
   * @param {string} by
   * @param {string} task
   * @param {TaskProgress} progress
   */
  set(by, task, progress) {
    if (progress.attempts > 0) this.#entries.set(`${by} ${task}`, progress);
    else this.#entries.delete(`${by} ${task}`);
  }

  clear() {
    this.#entries.clear();
  }

  /** @param {Counts} counts what is known from elsewhere */
  merge(counts) {
    for (const { by, task, progress } of counts.all) this.set(by, task, merge(this.of(by, task), progress));
  }

  /**
   * Counts attempts that are not kept.
   * @param {KeptAttempt[]} gone
   * @param {KeptAttempt[]} all with those of their turns that are kept
   */
  addGone(gone, all) {
    const names = new Set(gone.map(turnOf));
    for (const [name, turn] of grouped(all, turnOf)) {
      const [{ by, puzzle }] = turn;
      if (names.has(name) && TASK.test(puzzle)) this.set(by, puzzle, merge(this.of(by, puzzle), progressOf(turn)));
    }
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
      if (TASK.test(task) && isCount(attempts, MAX_NUMBER) && (solved === null || isCount(solved, attempts)))
        this.set(by, task, merge(this.of(by, task), { attempts, solved }));
    }
  }
}

/** The counts that this browser keeps. */
export class StoredCounts extends Counts {
  #store;

  /** @param {import("./browser-store.js").BrowserStore} store */
  constructor(store) {
    super();
    this.#store = store;
    this.refresh();
  }

  /**
   * Reads what is stored now: another tab may have written it. What the browser had not taken is added to that.
   * @param {boolean} [heard] another tab has written it; if it has forgotten all, what was not taken is forgotten too
   */
  refresh(heard = false) {
    const unwritten = this.#store.unwritten.includes(KEY) ? new Counts(this) : null;
    if (unwritten) this.#store.revert(KEY);
    super.clear();
    for (const [by, tasks] of Object.entries(Object(this.#parsed(KEY)))) this.read(by, tasks);
    this.read(PLAYER, Object(this.#parsed(OLD_PLAYER_KEY)).tasks);
    for (const key of this.#store.keys(OLD_MODEL_KEY))
      this.read(key.slice(OLD_MODEL_KEY.length), Object(this.#parsed(key)).tasks);
    if (!unwritten || (heard && this.#store.get(KEY) === null)) return;
    this.merge(unwritten);
    this.#write();
  }

  /**
   * Adds what is known from elsewhere. Returns how to undo it; what has been counted since stays.
   * @param {Counts} added
   */
  add(added) {
    if (added.all.length === 0) return () => {};
    this.refresh();
    const changes = added.all.map(({ by, task, progress }) => {
      const before = this.of(by, task);
      return { by, task, before, after: merge(before, progress) };
    });
    for (const { by, task, after } of changes) this.set(by, task, after);
    this.#write();
    return () => {
      this.refresh();
      for (const { by, task, before, after } of changes) {
        const { attempts, solved } = this.of(by, task);
        if (attempts === after.attempts && solved === after.solved) this.set(by, task, before);
      }
      this.#write();
    };
  }

  /** @param {string} key null if it is damaged */
  #parsed(key) {
    try {
      return JSON.parse(this.#store.get(key) ?? "null");
    } catch {
      return null;
    }
  }

  #write() {
    /** @type {Record<string, Record<string, TaskProgress>>} without a prototype, whose name a model may have */
    const authors = Object.create(null);
    for (const { by, task, progress } of this.all) (authors[by] ??= {})[task] = progress;
    this.#store.set(KEY, this.all.length > 0 ? JSON.stringify(authors) : null);
  }

  clear() {
    super.clear();
    for (const key of [KEY, OLD_PLAYER_KEY, ...this.#store.keys(OLD_MODEL_KEY)]) this.#store.set(key, null);
  }
}

/** @param {string} key that another tab has written */
export function isCountsKey(key) {
  return key === KEY || key === OLD_PLAYER_KEY || key.startsWith(OLD_MODEL_KEY);
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
 * What the attempts of one author at one puzzle tell.
 * @param {KeptAttempt[]} attempts
 * @returns {TaskProgress}
 */
export function progressOf(attempts) {
  let number = attempts.length;
  /** @type {number | null} */
  let solved = null;
  for (const attempt of attempts) {
    number = Math.max(number, attempt.number);
    if (attempt.ending.solved) solved = Math.min(solved ?? attempt.number, attempt.number);
  }
  return { attempts: number, solved };
}
