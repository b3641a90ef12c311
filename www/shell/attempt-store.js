// The attempts themselves, as this device keeps them: for each puzzle the balls of the player and of each model, with what became
// of them. Kept in localStorage, a key for each puzzle, as JSON lines: an attempt a line. A store that is forbidden, full or
// damaged loses attempts but never breaks the page. Knows nothing of the document.
//
// {"task":"00007:008","by":"player","ball":[128,200,12],"status":"solved","steps":312,"longest_touch":180,"final_touch":180,"simulator":3}
// "by" is "player" or the name of a model; lengths are in px, times in steps; "simulator" is the version of the simulator.

/** @typedef {import("../pkg/pathlight.js").Attempt} Attempt */

/** @typedef {Attempt & { task: string, by: string, simulator: number }} KeptAttempt */

const PREFIX = "pathlight.attempts.";
const TASK = /^\d{5}:\d{3}$/;
/** The name of a model, or "player". */
export const NAME = /^[\w.-]{1,60}$/;
/** More attempts of one contender at one puzzle than this are damage. */
const MOST = 100;
/** More steps than this are damage. */
const MOST_STEPS = 1e5;

export class AttemptStore {
  #persistent;
  /** @type {Map<string, KeptAttempt[]>} what the browser's store did not take, by puzzle: it lasts as long as the page */
  #unwritten = new Map();

  /** @param {boolean} persistent does it outlast the page? */
  constructor(persistent) {
    this.#persistent = persistent;
  }

  /**
   * The attempts at a puzzle, in the order in which they were made.
   * @param {string} task
   * @returns {KeptAttempt[]}
   */
  of(task) {
    const unwritten = this.#unwritten.get(task);
    if (unwritten) return unwritten;
    const text = this.#ask((storage) => storage.getItem(PREFIX + task)) ?? "";
    return parseAttempts(text).attempts.filter((one) => one.task === task);
  }

  /**
   * Adds attempts of one contender at a puzzle, beside those that another tab has kept. An attempt with the same ball is replaced,
   * and so are those of a model that another simulator made, for they are not brought back.
   * @param {string} task
   * @param {string} by
   * @param {Attempt[]} attempts
   * @param {number} simulator
   */
  add(task, by, attempts, simulator) {
    if (attempts.length === 0) return;
    const balls = new Set(attempts.map(({ ball }) => String(ball)));
    const stays = (/** @type {KeptAttempt} */ one) => one.by !== by || (!balls.has(String(one.ball)) && (by === "player" || one.simulator === simulator));
    this.#write(task, [...this.of(task).filter(stays), ...attempts.map(({ ball, ending }) => ({ task, by, ball, ending, simulator }))]);
  }

  /**
   * Deletes the attempts of one contender at a puzzle with these balls.
   * @param {string} task
   * @param {string} by
   * @param {string[]} balls as text
   */
  remove(task, by, balls) {
    if (balls.length) this.#write(task, this.of(task).filter((one) => one.by !== by || !balls.includes(String(one.ball))));
  }

  /** All attempts, by puzzle. */
  get all() {
    const keys = this.#ask((storage) => Object.keys(storage).filter((key) => key.startsWith(PREFIX))) ?? [];
    const tasks = new Set([...keys.map((key) => key.slice(PREFIX.length)), ...this.#unwritten.keys()]);
    return [...tasks].sort().flatMap((task) => this.of(task));
  }

  /**
   * Takes attempts that were saved: of each contender at a puzzle they replace those that are here if they are more.
   * @param {KeptAttempt[]} attempts
   */
  take(attempts) {
    for (const [task, ofTask] of Map.groupBy(attempts, (one) => one.task)) {
      for (const [by, saved] of Map.groupBy(ofTask, (one) => one.by)) {
        const here = this.of(task);
        const others = here.filter((one) => one.by !== by);
        if (saved.length > here.length - others.length) this.#write(task, [...others, ...saved]);
      }
    }
  }

  /**
   * Forgets the attempts of all at a puzzle.
   * @param {string} task
   */
  forget(task) {
    this.#write(task, []);
  }

  /** Forgets all attempts. */
  clear() {
    this.#unwritten.clear();
    this.#ask((storage) => {
      for (const key of Object.keys(storage)) if (key.startsWith(PREFIX)) storage.removeItem(key);
    });
  }

  /**
   * @param {string} task
   * @param {KeptAttempt[]} attempts
   */
  #write(task, attempts) {
    const isWritten = this.#ask((storage) => {
      if (attempts.length) storage.setItem(PREFIX + task, formatAttempts(attempts));
      else storage.removeItem(PREFIX + task);
      return true;
    });
    if (isWritten) this.#unwritten.delete(task);
    else this.#unwritten.set(task, attempts);
  }

  /**
   * What the browser's store answers; undefined if there is none, or if it is full.
   * @template T
   * @param {(storage: Storage) => T} act
   * @returns {T | undefined}
   */
  #ask(act) {
    try {
      return this.#persistent ? act(localStorage) : undefined;
    } catch {
      return undefined;
    }
  }
}

/**
 * Attempts as JSON lines.
 * @param {KeptAttempt[]} attempts
 */
export function formatAttempts(attempts) {
  return attempts.map(({ task, by, ball, ending: { solved, ...times }, simulator }) => `${JSON.stringify({ task, by, ball, status: solved ? "solved" : "not_solved", ...times, simulator })}\n`).join("");
}

/**
 * The attempts of JSON lines, and how many lines are none; lines may hold more than is read.
 * @param {string} text
 * @returns {{ attempts: KeptAttempt[], unread: number }}
 */
export function parseAttempts(text) {
  const lines = text.split("\n").filter((line) => line.trim());
  /** @type {Map<string, number>} */
  const counts = new Map();
  const attempts = lines.flatMap((line) => {
    const attempt = attemptOf(line);
    if (!attempt) return [];
    const contender = `${attempt.task} ${attempt.by}`;
    const count = (counts.get(contender) ?? 0) + 1;
    counts.set(contender, count);
    return count <= MOST ? [attempt] : [];
  });
  return { attempts, unread: lines.length - attempts.length };
}

/**
 * @param {string} line
 * @returns {KeptAttempt | null}
 */
function attemptOf(line) {
  /** @type {any} */
  let parsed;
  try {
    parsed = JSON.parse(line);
  } catch {
    return null;
  }
  // A line with a digest names who made it: it may be the model's.
  const { task, digest, by = digest === undefined ? "player" : null, ball, status, steps, longest_touch = 0, final_touch = 0, simulator = 0 } = parsed ?? {};
  /** @type {(value: unknown) => boolean} */
  const isSteps = (value) => Number.isSafeInteger(value) && Number(value) >= 0 && Number(value) <= MOST_STEPS;
  const isBall = Array.isArray(ball) && ball.length === 3 && ball.every((value) => Number.isFinite(value));
  const fits = typeof task === "string" && TASK.test(task) && typeof by === "string" && NAME.test(by) && isBall && ["solved", "not_solved"].includes(status);
  if (!fits || ![steps, longest_touch, final_touch, simulator].every(isSteps)) return null;
  return { task, by, ball: /** @type {import("../pkg/pathlight.js").Ball} */ (ball), ending: { solved: status === "solved", steps, longest_touch, final_touch }, simulator };
}
