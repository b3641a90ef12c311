// What this device remembers of a contender's attempts: for each puzzle how many there were, and which solved it first.
// Kept in localStorage as JSON. A store that is forbidden, full or damaged loses the progress but never breaks the
// page. Knows nothing of the document.
//
// { "tasks": { "00007:013": { "attempts": 4, "solved": 3 } } }   "solved" is null as long as no attempt solved it

import { AttemptStore, TASK } from "./attempt-store.js";

/** @typedef {{ attempts: number, solved: number | null }} TaskProgress */

const PLAYER_KEY = "pathlight.progress";
/** More attempts than a person can make: a stored number above it is damage. */
const MAX_STORED_ATTEMPTS = 1e6;

export class ProgressStore extends EventTarget {
  /** Does it outlast the page? */
  persistent;
  #key;
  /** Is it meant to outlast the page? */
  #isKept;
  /** @type {Record<string, TaskProgress>} */
  #tasks = {};

  /**
   * The player's store. Fires "change" whenever it holds something else, also when another tab has written it.
   * @param {string} [key]
   * @param {boolean} [persistent]
   */
  constructor(key = PLAYER_KEY, persistent = true) {
    super();
    this.#key = key;
    this.#isKept = persistent;
    this.persistent = persistent;
    if (!persistent) return;
    this.#read();
    addEventListener("storage", (event) => {
      if (event.key !== this.#key && event.key !== null) return;
      this.#read();
      this.#changed();
    });
  }

  /**
   * The progress on a task; no attempts if it was never tried.
   * @param {string} task
   * @returns {TaskProgress}
   */
  of(task) {
    return Object.hasOwn(this.#tasks, task) ? this.#tasks[task] : { attempts: 0, solved: null };
  }

  /** The tasks that were tried, sorted. */
  get tasks() {
    return Object.keys(this.#tasks).sort();
  }

  /**
   * Of some tasks: how many were tried, how many are solved, and the attempts on all of them.
   * @param {string[]} tasks
   */
  sum(tasks) {
    const tried = tasks.map((task) => this.of(task)).filter(({ attempts }) => attempts > 0);
    const attempts = tried.reduce((sum, one) => sum + one.attempts, 0);
    return { tried: tried.length, solved: tried.filter(({ solved }) => solved !== null).length, attempts };
  }

  /**
   * Adds one attempt at a task.
   * @param {string} task
   * @param {boolean} solves
   */
  add(task, solves) {
    // Another tab may have written meanwhile.
    if (this.persistent) this.#read();
    const { attempts, solved } = this.of(task);
    this.#tasks[task] = { attempts: attempts + 1, solved: solved ?? (solves ? attempts + 1 : null) };
    this.#write();
  }

  /**
   * Replaces the progress on a task.
   * @param {string} task
   * @param {TaskProgress} progress
   */
  set(task, { attempts, solved }) {
    if (this.persistent) this.#read();
    this.#tasks[task] = { attempts, solved };
    this.#write();
  }

  /**
   * Takes progress from elsewhere, where it tells of more attempts than are known here.
   * @param {unknown} tasks as stored; what makes no sense is left out
   */
  take(tasks) {
    if (this.persistent) this.#read();
    for (const [task, progress] of Object.entries(validTasks({ tasks }))) {
      if (progress.attempts > this.of(task).attempts) this.#tasks[task] = progress;
    }
    this.#write();
  }

  clear() {
    this.#tasks = {};
    // A store that was full can be cleared, and has room afterwards.
    this.persistent = this.#isKept;
    this.#store((storage) => storage.removeItem(this.#key));
  }

  toJson() {
    return JSON.stringify({ tasks: this.#tasks }, null, 1);
  }

  #read() {
    try {
      this.#tasks = validTasks(JSON.parse(localStorage.getItem(this.#key) ?? "null"));
    } catch (error) {
      // Text that is not JSON is ignored; a store that may not be read is not asked again.
      this.#tasks = {};
      if (!(error instanceof SyntaxError)) this.persistent = false;
    }
  }

  #write() {
    this.#store((storage) => storage.setItem(this.#key, this.toJson()));
  }

  /** @param {(storage: Storage) => void} change */
  #store(change) {
    try {
      if (this.persistent) change(localStorage);
    } catch {
      this.persistent = false;
    }
    this.#changed();
  }

  #changed() {
    this.dispatchEvent(new Event("change"));
  }
}

const GUIDE_KEY = "pathlight.guide";

/** Has the introduction been offered in this browser, and taken or declined? */
export function guideOffered() {
  try {
    return localStorage.getItem(GUIDE_KEY) !== null;
  } catch {
    // It could not be remembered that it was.
    return true;
  }
}

export function rememberGuide() {
  try {
    localStorage.setItem(GUIDE_KEY, "offered");
  } catch {
    // It is offered once more.
  }
}

const MODEL_KEY = "pathlight.model.";

/**
 * The progress of the player and of each model, and the attempts themselves, which all puzzles of a page share. Fires
 * "change" when any progress changes.
 */
class Progress extends EventTarget {
  player;
  attempts;
  #persistent;
  /** @type {Map<string, ProgressStore>} */
  #models = new Map();

  /** @param {boolean} persistent */
  constructor(persistent) {
    super();
    this.#persistent = persistent;
    this.player = this.#create(PLAYER_KEY);
    this.attempts = new AttemptStore(persistent);
  }

  /**
   * The progress of a model in its own turns.
   * @param {string} name
   */
  ofModel(name) {
    const store = this.#models.get(name) ?? this.#create(MODEL_KEY + name);
    this.#models.set(name, store);
    return store;
  }

  /** The names of the models that have progress. */
  get modelNames() {
    /** @type {string[]} */
    let kept = [];
    try {
      if (this.#persistent)
        kept = Object.keys(localStorage)
          .filter((key) => key.startsWith(MODEL_KEY))
          .map((key) => key.slice(MODEL_KEY.length));
    } catch {
      // It may not be asked; what was made in this page is known.
    }
    return [...new Set([...kept, ...this.#models.keys()])].sort();
  }

  /** @param {string} key */
  #create(key) {
    const store = new ProgressStore(key, this.#persistent);
    store.addEventListener("change", () => this.dispatchEvent(new Event("change")));
    return store;
  }
}
/** @typedef {Progress} SharedProgress */

/** @type {Partial<Record<"kept" | "forgotten", Progress>>} */
const shared = {};

/**
 * The progress that is kept in this browser, or the one that is forgotten with the page.
 * @param {"kept" | "forgotten"} which
 */
export function sharedProgress(which) {
  return (shared[which] ??= new Progress(which === "kept"));
}

/**
 * The entries of stored JSON that make sense.
 * @param {any} stored
 * @returns {Record<string, TaskProgress>}
 */
export function validTasks(stored) {
  /** @type {(value: unknown, most: number) => boolean} */
  const isCount = (value, most) => Number.isSafeInteger(value) && Number(value) >= 1 && Number(value) <= most;
  const entries = Object.entries(/** @type {Record<string, any>} */ (stored?.tasks ?? {})).filter(
    ([task, one]) =>
      TASK.test(task) &&
      isCount(one?.attempts, MAX_STORED_ATTEMPTS) &&
      (one.solved === null || isCount(one.solved, one.attempts)),
  );
  return Object.fromEntries(entries.map(([task, { attempts, solved }]) => [task, { attempts, solved }]));
}
