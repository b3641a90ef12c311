// The counts that this browser keeps, a key for each contender. Knows nothing of the document.

import { PLAYER } from "./attempts.js";
import { Counts } from "./counts.js";

const MODEL = "model.";

export class CountStore {
  #store;
  /** @type {Counts} */
  #counts;

  /** @param {import("./browser-store.js").BrowserStore} store */
  constructor(store) {
    this.#store = store;
    this.#counts = this.#read();
  }

  get counts() {
    return this.#counts;
  }

  /** Reads what another tab may have written. */
  refresh() {
    this.#counts = this.#read();
  }

  /**
   * Adds what is known from elsewhere. Returns how to undo it; what has been counted since stays.
   * @param {Counts} added
   */
  add(added) {
    if (added.names.length === 0) return () => {};
    const before = this.#read();
    this.refresh();
    this.#counts.merge(added);
    const after = this.#counts;
    this.#write(added.names);
    return () => {
      this.refresh();
      for (const by of added.names)
        for (const [task] of added.entries(by)) {
          const [written, now] = [after.of(by, task), this.#counts.of(by, task)];
          if (written.attempts === now.attempts && written.solved === now.solved)
            this.#counts.set(by, task, before.of(by, task));
        }
      this.#write(added.names);
    };
  }

  clear() {
    for (const key of [keyOf(PLAYER), ...this.#store.keys(MODEL)]) this.#store.set(key, null);
    this.#counts = new Counts();
  }

  #read() {
    const counts = new Counts();
    for (const key of [keyOf(PLAYER), ...this.#store.keys(MODEL)]) {
      try {
        const { tasks } = Object(JSON.parse(this.#store.get(key) ?? "null"));
        counts.read(key === keyOf(PLAYER) ? PLAYER : key.slice(MODEL.length), tasks);
      } catch {
        // It is damaged.
      }
    }
    return counts;
  }

  /** @param {string[]} names */
  #write(names) {
    for (const by of names) {
      const tasks = Object.fromEntries(this.#counts.entries(by));
      this.#store.set(keyOf(by), Object.keys(tasks).length > 0 ? JSON.stringify({ tasks }) : null);
    }
  }
}

/** @param {string} by */
function keyOf(by) {
  return by === PLAYER ? "progress" : MODEL + by;
}
