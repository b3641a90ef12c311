// The attempts themselves, as this device keeps them: for each puzzle the balls of the player and of each model, with
// what became of them. Kept in localStorage as JSON lines, an attempt a line: a key for each task, and one for all own
// scenes, of which only the latest attempts stay. A store that is forbidden, full or damaged loses attempts but never
// breaks the page. Knows nothing of the document.
//
// {"task":"00007:008","by":"player","ball":[128,200,12],"status":"solved","steps":312,"longest_touch":180,
//  "final_touch":180,"simulator":3}
// An own scene has its digest as "scene" instead of the "task"; in files it may be the scene itself. "by" is "player"
// or the name of a model, and then "agents" is the version of the agents; lengths are in px, times in steps;
// "simulator" is the version of the simulator.

import { AGENTS_VERSION, SIMULATOR_VERSION } from "./constants.js";
import { pathlight } from "./page-api.js";

/** @typedef {import("../pkg/pathlight.js").Attempt} Attempt */

/** @typedef {{ simulator: number, agents?: number }} Versions what an attempt depends on; a person's has no agents */

/**
 * An attempt at a puzzle: the id of a task, or the digest of an own scene.
 * @typedef {Attempt & Versions & { puzzle: string, by: string }} KeptAttempt
 */

const PREFIX = "pathlight.attempts.";
/** What follows the prefix in the key of all own scenes; that of a task is its id. */
const OWN = "own";
export const TASK = /^\d{5}:\d{3}$/;
const DIGEST = /^[0-9a-f]{64}$/;
/** The name of a model, or "player". */
export const NAME = /^[\w.-]{1,60}$/;
/** More attempts of one contender at one puzzle than this are damage. */
const MOST = 100;
/** So many attempts at own scenes are kept, some 200 kB: every change to a scene makes another. */
const MOST_OWN = 1000;
/** More steps than this are damage. */
const MOST_STEPS = 1e5;

/**
 * What attempts at a puzzle are kept under.
 * @param {import("../pkg/pathlight.js").Played} played
 */
export function puzzleKey(played) {
  return typeof played === "string" ? played : pathlight.sceneDigest(played);
}

/** Fires "change" whenever it holds something else, also when another tab has written it. */
export class AttemptStore extends EventTarget {
  #persistent;
  /** @type {Map<string, KeptAttempt[]>} what the browser's store did not take, by slot: it lasts as long as the page */
  #unwritten = new Map();

  /** @param {boolean} persistent does it outlast the page? */
  constructor(persistent) {
    super();
    this.#persistent = persistent;
    if (!persistent) return;
    addEventListener("storage", ({ key }) => {
      if (key === null || key.startsWith(PREFIX)) this.#changed();
    });
  }

  /**
   * The attempts at a puzzle, in the order in which they were made.
   * @param {string} puzzle
   * @returns {KeptAttempt[]}
   */
  of(puzzle) {
    return this.#read(slotOf(puzzle)).filter((one) => one.puzzle === puzzle);
  }

  /** All attempts at own scenes, in the order in which they were made. */
  get ofOwnScenes() {
    return this.#read(OWN);
  }

  /**
   * Adds attempts of one contender at a puzzle, beside those that another tab has kept. An attempt with the same ball
   * is replaced, and so are those of a model that other versions made, for they are not brought back.
   * @param {string} puzzle
   * @param {string} by
   * @param {Attempt[]} attempts
   * @param {Versions} versions
   */
  add(puzzle, by, attempts, { simulator, agents }) {
    if (attempts.length === 0) return;
    const balls = new Set(attempts.map(({ ball }) => String(ball)));
    const stays = (/** @type {KeptAttempt} */ one) =>
      !isOf(one, puzzle, by) ||
      (!balls.has(String(one.ball)) && (by === "player" || (one.simulator === simulator && one.agents === agents)));
    this.#change(slotOf(puzzle), (kept) => [
      ...kept.filter(stays),
      ...attempts.map(({ ball, ending }) => ({ puzzle, by, ball, ending, simulator, agents })),
    ]);
  }

  /**
   * Deletes the attempts of one contender at a puzzle with these balls.
   * @param {string} puzzle
   * @param {string} by
   * @param {string[]} balls as text
   */
  remove(puzzle, by, balls) {
    if (balls.length)
      this.#change(slotOf(puzzle), (kept) =>
        kept.filter((one) => !isOf(one, puzzle, by) || !balls.includes(String(one.ball))),
      );
  }

  /** All attempts, by puzzle; those at own scenes come last. */
  get all() {
    const keys = this.#ask((storage) => Object.keys(storage).filter((key) => key.startsWith(PREFIX))) ?? [];
    const slots = new Set([...keys.map((key) => key.slice(PREFIX.length)), ...this.#unwritten.keys()]);
    return [...slots].sort().flatMap((slot) => this.#read(slot));
  }

  /**
   * Takes attempts that were saved: of each contender at a puzzle they replace those that are here if they are more.
   * First count those that are brought back.
   * @param {KeptAttempt[]} attempts
   */
  take(attempts) {
    for (const [slot, saved] of Map.groupBy(attempts, ({ puzzle }) => slotOf(puzzle))) {
      this.#change(slot, (kept) => {
        let taken = kept;
        for (const ofOne of Map.groupBy(saved, ({ puzzle, by }) => `${puzzle} ${by}`).values()) {
          const others = taken.filter((one) => !isOf(one, ofOne[0].puzzle, ofOne[0].by));
          const here = taken.filter((one) => !others.includes(one));
          const [more, current] = [
            ofOne.length - here.length,
            ofOne.filter(isCurrent).length - here.filter(isCurrent).length,
          ];
          if (current > 0 || (current === 0 && more > 0)) taken = [...others, ...ofOne];
        }
        return taken;
      });
    }
  }

  /**
   * Forgets the attempts of all at a puzzle.
   * @param {string} puzzle
   */
  forget(puzzle) {
    this.#change(slotOf(puzzle), (kept) => kept.filter((one) => one.puzzle !== puzzle));
  }

  /** Forgets all attempts. */
  clear() {
    this.#unwritten.clear();
    this.#ask((storage) => {
      for (const key of Object.keys(storage)) if (key.startsWith(PREFIX)) storage.removeItem(key);
    });
    this.#changed();
  }

  /**
   * @param {string} slot
   * @returns {KeptAttempt[]}
   */
  #read(slot) {
    const unwritten = this.#unwritten.get(slot);
    if (unwritten) return unwritten;
    const text = this.#ask((storage) => storage.getItem(PREFIX + slot)) ?? "";
    return parseAttempts(text).attempts.filter(({ puzzle }) => slotOf(puzzle) === slot);
  }

  /**
   * @param {string} slot
   * @param {(kept: KeptAttempt[]) => KeptAttempt[]} change
   */
  #change(slot, change) {
    const changed = change(this.#read(slot));
    const attempts = slot === OWN ? changed.slice(-MOST_OWN) : changed;
    const isWritten = this.#ask((storage) => {
      if (attempts.length) storage.setItem(PREFIX + slot, formatAttempts(attempts));
      else storage.removeItem(PREFIX + slot);
      return true;
    });
    if (isWritten) this.#unwritten.delete(slot);
    else this.#unwritten.set(slot, attempts);
    this.#changed();
  }

  #changed() {
    this.dispatchEvent(new Event("change"));
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
 * What follows the prefix in the key of a puzzle's attempts.
 * @param {string} puzzle
 */
function slotOf(puzzle) {
  return TASK.test(puzzle) ? puzzle : OWN;
}

/**
 * @param {KeptAttempt} attempt
 * @param {string} puzzle
 * @param {string} by
 */
function isOf(attempt, puzzle, by) {
  return attempt.puzzle === puzzle && attempt.by === by;
}

/**
 * May it be brought back? A person's attempts are made again; a model's are of no use once it plays otherwise.
 * @param {KeptAttempt} attempt
 */
function isCurrent({ by, simulator, agents }) {
  return by === "player" || (simulator === SIMULATOR_VERSION && agents === AGENTS_VERSION);
}

/**
 * Attempts as JSON lines.
 * @param {KeptAttempt[]} attempts
 */
export function formatAttempts(attempts) {
  return attempts.map((attempt) => `${JSON.stringify(lineOf(attempt))}\n`).join("");
}

/** @param {KeptAttempt} attempt */
function lineOf({ puzzle, by, ball, ending: { solved, ...times }, simulator, agents }) {
  return {
    ...(TASK.test(puzzle) ? { task: puzzle } : { scene: puzzle }),
    by,
    ball,
    status: solved ? "solved" : "not_solved",
    ...times,
    simulator,
    agents,
  };
}

/**
 * The attempts of JSON lines, and how many lines are none, or too many; lines may hold more than is read.
 * @param {string} text
 * @returns {{ attempts: KeptAttempt[], unread: number }}
 */
export function parseAttempts(text) {
  const lines = text.split("\n").filter((line) => line.trim());
  /** @type {Map<string, number>} */
  const counts = new Map();
  const isOver = (/** @type {string} */ what, /** @type {number} */ most) => {
    const count = (counts.get(what) ?? 0) + 1;
    counts.set(what, count);
    return count > most;
  };
  const attempts = lines.flatMap((line) => {
    const parsed = parsedLine(line);
    if (parsed?.scene !== undefined && isOver(OWN, MOST_OWN)) return [];
    const attempt = attemptOf(parsed);
    return attempt && !isOver(`${attempt.puzzle} ${attempt.by}`, MOST) ? [attempt] : [];
  });
  return { attempts, unread: lines.length - attempts.length };
}

/**
 * @param {string} line
 * @returns {any}
 */
function parsedLine(line) {
  try {
    return JSON.parse(line);
  } catch {
    return null;
  }
}

/**
 * @param {any} parsed
 * @returns {KeptAttempt | null}
 */
function attemptOf(parsed) {
  // A line with a digest names who made it: it may be the model's.
  const {
    task,
    scene,
    digest,
    by = digest === undefined ? "player" : null,
    ball,
    status,
    steps,
    longest_touch = 0,
    final_touch = 0,
    simulator = 0,
    agents,
  } = parsed ?? {};
  /** @type {(value: unknown) => boolean} */
  const isSteps = (value) => Number.isSafeInteger(value) && Number(value) >= 0 && Number(value) <= MOST_STEPS;
  const isBall = Array.isArray(ball) && ball.length === 3 && ball.every((value) => Number.isFinite(value));
  const fits = typeof by === "string" && NAME.test(by) && isBall && ["solved", "not_solved"].includes(status);
  if (!fits || ![steps, longest_touch, final_touch, simulator, agents ?? 0].every(isSteps)) return null;
  const puzzle = scene === undefined ? taskOf(task) : digestOf(scene);
  if (puzzle === null) return null;
  return {
    puzzle,
    by,
    ball: /** @type {import("../pkg/pathlight.js").Ball} */ (ball),
    ending: { solved: status === "solved", steps, longest_touch, final_touch },
    simulator,
    agents,
  };
}

/** @param {unknown} task */
function taskOf(task) {
  return typeof task === "string" && TASK.test(task) ? task : null;
}

/**
 * The digest of an own scene, which is there itself or by its digest; null if it is neither.
 * @param {any} scene
 */
function digestOf(scene) {
  if (typeof scene === "string") return DIGEST.test(scene) ? scene : null;
  try {
    return pathlight.sceneDigest(scene);
  } catch {
    return null;
  }
}
