// What this device remembers: the attempts of the player and of each model. Progress follows from them; what they do
// not tell, because they were deleted or an older version did not keep them, is kept as counts. A store that is
// forbidden, full or damaged loses attempts but never breaks the page. Knows nothing of the document.

import {
  ATTEMPT_LIMIT,
  MAX_NUMBER,
  PLAYER,
  compareAttempts,
  compareVersions,
  grouped,
  identityOf,
  isOf,
  mergeAttempts,
  sameVersions,
  turnOf,
} from "./attempt-lines.js";
import { AttemptStore, CUSTOM, slotOf } from "./attempt-store.js";
import { BrowserStore } from "./browser-store.js";
import { KeptMemory } from "./kept-memory.js";
import { AuthorProgress } from "./author-progress.js";
import { Counts, StoredCounts, isCountsKey, merge, progressOf } from "./counts.js";

/** @typedef {import("./attempt-lines.js").KeptAttempt} KeptAttempt */
/** @typedef {import("./counts.js").TaskProgress} TaskProgress */

/** The most attempts at custom scenes that are kept, some 200 kB. */
const MOST_CUSTOM = 1000;
/** The most attempts that a file may fill the store to, which leaves room for those that follow. */
export const MOST_ATTEMPTS = 20_000;
/** Attempts that are merged at once. */
const PIECE = 1000;

/**
 * What merging has changed: the puzzles and attempts that were given, and of these the new attempts, the puzzles that
 * the player had not solved before, and the attempts for which there was no room.
 * @typedef {{ puzzles: number, attempts: number, added: number, solved: number, left: number, undo: () => void }}
 *   Merged
 */

/** Fires "change" whenever it holds something else, also when another tab has written it. */
export class Progress extends EventTarget {
  player = new AuthorProgress(this, PLAYER);
  /** What the models remember. */
  memory;
  #store;
  #isKept;
  #attempts;
  #counts;

  /** @param {boolean} persistent does it outlast the page? */
  constructor(persistent) {
    super();
    this.#isKept = persistent;
    this.#store = new BrowserStore(persistent, (key) => this.#onStored(key));
    this.memory = new KeptMemory(this.#store);
    this.#counts = new StoredCounts(this.#store);
    this.#attempts = new AttemptStore(this.#store, (by, task) => this.#counts.of(by, task).solved);
  }

  /** Does it outlast the page? */
  get persistent() {
    return this.#isKept && this.#store.failure === null;
  }

  /** @param {string} name */
  ofModel(name) {
    return new AuthorProgress(this, name);
  }

  /** What would still count if all attempts were deleted. Of a model all turns count, not only what `of` returns. */
  get counts() {
    const counts = new Counts(this.#counts);
    counts.addGone(this.all, this.all);
    return counts;
  }

  /**
   * An author's progress on a task.
   * @param {string} by
   * @param {string} task
   * @returns {TaskProgress}
   */
  of(by, task) {
    const kept = this.#attempts.in(slotOf(task)).filter((attempt) => isOf(attempt, task, by));
    const turns = [...grouped(kept, turnOf).values()].sort(([a], [b]) => compareVersions(a, b));
    // Once a model's turn of the newest versions has ended, it alone counts.
    const last = progressOf(turns.at(-1) ?? []);
    if (by !== PLAYER && (last.solved !== null || last.attempts >= ATTEMPT_LIMIT)) return last;
    return turns.map(progressOf).reduce(merge, this.#counts.of(by, task));
  }

  /**
   * The tasks that an author has tried, sorted.
   * @param {string} by
   */
  tasksOf(by) {
    const slots = this.#attempts.slots.filter((slot) => slot !== CUSTOM);
    const kept = slots.filter((slot) => this.#attempts.in(slot).some((one) => one.by === by));
    return [...new Set([...kept, ...this.#counts.all.filter((one) => one.by === by).map(({ task }) => task)])].sort();
  }

  /**
   * The attempts at a puzzle, in the order in which they were made.
   * @param {string} puzzle
   */
  attemptsAt(puzzle) {
    return this.#attempts
      .in(slotOf(puzzle))
      .filter((attempt) => attempt.puzzle === puzzle)
      .sort(compareAttempts);
  }

  /** All attempts at custom scenes. */
  get ofCustomScenes() {
    return this.#attempts.in(CUSTOM);
  }

  /** All attempts, by puzzle; those at custom scenes come last. */
  get all() {
    return this.#attempts.all;
  }

  /** Why the browser does not keep everything, or null; and how many attempts it does not keep. */
  get unkept() {
    return { failure: this.#store.failure, attempts: this.#attempts.unwritten };
  }

  /**
   * Adds attempts that an author has just made, beside those that another tab has kept. Deletes a model's turn of other
   * versions, which is never brought back.
   * @param {string} puzzle
   * @param {string} by
   * @param {import("./attempt-lines.js").Attempt[]} attempts
   * @param {import("./attempt-lines.js").Versions} versions
   */
  add(puzzle, by, attempts, versions) {
    if (attempts.length === 0) return;
    this.#change(slotOf(puzzle), (all) => {
      const stays = all.filter((one) => !isOf(one, puzzle, by) || by === PLAYER || sameVersions(one, versions));
      const before = by === PLAYER ? this.of(by, puzzle).attempts : stays.filter((one) => isOf(one, puzzle, by)).length;
      const made = attempts.map(({ ball, ending }, index) => {
        const number = Math.min(before + index + 1, MAX_NUMBER);
        return { puzzle, by, number, ball, ending, ...versions };
      });
      const { here, fresh, left } = mergeAttempts(stays, made);
      this.#addGone(left, [...here, ...fresh, ...left]);
      return [...here, ...fresh];
    });
  }

  /**
   * Deletes the attempts of one author at a puzzle with these balls. They still count.
   * @param {string} puzzle
   * @param {string} by
   * @param {string[]} balls as text
   */
  remove(puzzle, by, balls) {
    if (balls.length > 0)
      this.#change(slotOf(puzzle), (all) =>
        all.filter((attempt) => !isOf(attempt, puzzle, by) || !balls.includes(String(attempt.ball))),
      );
  }

  /**
   * Deletes the attempts of all at a puzzle. They still count, unless it is a custom scene.
   * @param {string} puzzle
   */
  forget(puzzle) {
    this.#change(slotOf(puzzle), (all) => all.filter((attempt) => attempt.puzzle !== puzzle));
  }

  /** Forgets everything, also what the models remember of it. */
  clear() {
    this.#attempts.clear();
    this.#counts.clear();
    this.memory.clear();
    this.#changed();
  }

  /**
   * Merges in what was kept elsewhere, step by step. Nothing that is here goes: the earlier solution stays, and so does
   * each attempt.
   * @param {KeptAttempt[]} attempts
   * @param {Counts} [counts]
   * @returns {Generator<number, Merged, void>} yields how much is done, 0..1
   */
  *merging(attempts, counts = new Counts()) {
    const puzzles = new Set(counts.all.map(({ task }) => task));
    /** @type {Map<string, KeptAttempt[]>} */
    const slots = new Map();
    for (const [index, attempt] of attempts.entries()) {
      puzzles.add(attempt.puzzle);
      const slot = slotOf(attempt.puzzle);
      const before = slots.get(slot);
      if (before) before.push(attempt);
      else slots.set(slot, [attempt]);
      if (index % PIECE === 0) yield 0;
    }
    const pieces = [...slots].flatMap(([slot, all]) =>
      Array.from({ length: Math.ceil(all.length / PIECE) }, (_, index) => ({
        slot,
        piece: all.slice(index * PIECE, (index + 1) * PIECE),
      })),
    );
    const solvedBefore = this.#solved;
    const counted = new Counts(counts);
    let room = Math.max(0, MOST_ATTEMPTS - this.all.length);
    let [added, left, done] = [0, 0, 0];
    /** @type {(() => void)[]} */
    const undos = [];
    let complete = false;
    try {
      for (const { slot, piece } of pieces) {
        const before = this.#attempts.latestIn(slot);
        const merged = mergeAttempts(
          before,
          piece,
          slot === CUSTOM ? Math.min(room, MOST_CUSTOM - before.length) : room,
        );
        // When the oldest have to go, those that were here go last.
        const after = [...merged.fresh, ...merged.here];
        this.#attempts.write(slot, after);
        counted.addGone(merged.left, [...after, ...merged.left]);
        undos.unshift(() => this.#attempts.undo(slot, before, merged.fresh));
        room -= merged.fresh.length;
        added += merged.fresh.length;
        left += merged.left.length;
        done += piece.length;
        yield done / attempts.length;
      }
      complete = true;
    } finally {
      // The person has stopped it.
      if (!complete) for (const undo of undos) undo();
    }
    undos.push(this.#counts.add(counted));
    const solved = this.#solved - solvedBefore;
    this.#changed();
    const undo = () => {
      for (const step of undos) step();
      this.#changed();
    };
    return { puzzles: puzzles.size, attempts: attempts.length, added, solved, left, undo };
  }

  /** How many puzzles the player has solved. */
  get #solved() {
    const tasks = this.player.tasks.filter((task) => this.player.of(task).solved !== null);
    const scenes = this.ofCustomScenes.filter(({ by, ending }) => by === PLAYER && ending.solved);
    return tasks.length + new Set(scenes.map(({ puzzle }) => puzzle)).size;
  }

  /**
   * Changes a slot. What goes still counts.
   * @param {string} slot
   * @param {(all: KeptAttempt[]) => KeptAttempt[]} change
   */
  #change(slot, change) {
    const before = this.#attempts.latestIn(slot);
    const changed = change(before);
    const after = slot === CUSTOM ? changed.slice(-MOST_CUSTOM) : changed;
    const stays = new Set(after.map(identityOf));
    const gone = before.filter((attempt) => !stays.has(identityOf(attempt)));
    this.#addGone(gone, before);
    this.#attempts.write(slot, after);
    this.#changed();
  }

  /**
   * @param {KeptAttempt[]} gone
   * @param {KeptAttempt[]} all
   */
  #addGone(gone, all) {
    const counts = new Counts();
    counts.addGone(gone, all);
    this.#counts.add(counts);
  }

  /** @param {string | null} key */
  #onStored(key) {
    this.memory.refresh(key);
    const isCounts = key === null || isCountsKey(key);
    if (isCounts) this.#counts.refresh(true);
    if (this.#attempts.refresh(key) || isCounts) this.#changed();
  }

  #changed() {
    this.dispatchEvent(new Event("change"));
  }
}

/** @type {Partial<Record<"kept" | "forgotten", Progress>>} */
const shared = {};

/** @param {"kept" | "forgotten"} which the one that is kept in this browser, or forgotten with the page */
export function sharedProgress(which) {
  return (shared[which] ??= new Progress(which === "kept"));
}
