// The kept attempts as the browser's store has them: JSON lines, a key (slot) for each task, and one for all custom
// scenes. Knows nothing of the document.

import { AttemptReader, TASK, formatAttempts, identityOf, mergeAttempts } from "./attempt-lines.js";
import { linesOf } from "./sliced-work.js";

/** @typedef {import("./attempt-lines.js").KeptAttempt} KeptAttempt */

const PREFIX = "attempts.";
/** The slot of all custom scenes: every change to a scene makes another scene. */
export const CUSTOM = "own";

export class AttemptStore {
  #store;
  #solvedAt;
  /** @type {Map<string, { text: string, attempts: KeptAttempt[] }>} what was read or written last */
  #known = new Map();

  /**
   * @param {import("./browser-store.js").BrowserStore} store
   * @param {(by: string, task: string) => number | null} solvedAt see AttemptReader
   */
  constructor(store, solvedAt) {
    this.#store = store;
    this.#solvedAt = solvedAt;
  }

  get slots() {
    return this.#store.keys(PREFIX).map((key) => key.slice(PREFIX.length));
  }

  /**
   * @param {string} slot
   * @returns {KeptAttempt[]}
   */
  in(slot) {
    return this.#known.get(slot)?.attempts ?? this.latestIn(slot);
  }

  /**
   * Those that are stored now: another tab may have written meanwhile.
   * @param {string} slot
   */
  latestIn(slot) {
    const text = this.#store.get(PREFIX + slot) ?? "";
    const known = this.#known.get(slot);
    if (known && known.text === text) return known.attempts;
    const reader = new AttemptReader(this.#solvedAt);
    for (const { line } of linesOf(text)) reader.addLine(line);
    const attempts = reader.attempts.filter(({ puzzle }) => slotOf(puzzle) === slot);
    this.#known.set(slot, { text, attempts });
    return attempts;
  }

  /** All attempts, by puzzle; those at custom scenes come last. */
  get all() {
    return this.slots.flatMap((slot) => this.in(slot));
  }

  /** How many the browser has not taken. */
  get unwritten() {
    const keys = this.#store.unwritten.filter((key) => key.startsWith(PREFIX));
    return keys.reduce((sum, key) => sum + this.in(key.slice(PREFIX.length)).length, 0);
  }

  /**
   * @param {string} slot
   * @param {KeptAttempt[]} attempts
   */
  write(slot, attempts) {
    const text = formatAttempts(attempts);
    this.#known.set(slot, { text, attempts });
    this.#store.set(PREFIX + slot, text || null);
  }

  /**
   * Takes attempts out again that were merged in. What has been made since stays.
   * @param {string} slot
   * @param {KeptAttempt[]} before what was there
   * @param {KeptAttempt[]} added
   */
  undo(slot, before, added) {
    const gone = new Set(added.map(identityOf));
    const earlier = new Map(before.map((attempt) => [identityOf(attempt), attempt]));
    const stays = this.latestIn(slot).filter((attempt) => !gone.has(identityOf(attempt)));
    this.write(
      slot,
      stays.map((attempt) => earlier.get(identityOf(attempt)) ?? attempt),
    );
  }

  clear() {
    for (const slot of this.slots) this.#store.set(PREFIX + slot, null);
    this.#known.clear();
  }

  /**
   * Forgets what was read, as another tab has written it. What the browser had not taken is added to that. Returns
   * whether the key is of attempts.
   * @param {string | null} key null for all
   */
  refresh(key) {
    if (key === null) this.#known.clear();
    if (!key?.startsWith(PREFIX)) return false;
    const slot = key.slice(PREFIX.length);
    const unwritten = this.#store.unwritten.includes(key) ? this.in(slot) : [];
    this.#known.delete(slot);
    if (unwritten.length > 0) {
      this.#store.revert(key);
      const { here, fresh } = mergeAttempts(this.latestIn(slot), unwritten);
      this.write(slot, [...here, ...fresh]);
    }
    return true;
  }
}

/** @param {string} puzzle */
export function slotOf(puzzle) {
  return TASK.test(puzzle) ? puzzle : CUSTOM;
}
