// Texts by key, in localStorage. What the browser does not take, because it is full or forbids it, lasts as long as the
// page, and is written once there is room. Knows nothing of the document.

const PREFIX = "pathlight.";

export class BrowserStore {
  /**
   * Why not everything is kept; null if it is.
   * @type {"forbidden" | "full" | null}
   */
  failure = null;
  #persistent;
  /** @type {Map<string, string | null>} the entries that were not written; null is one that was deleted */
  #unwritten = new Map();

  /**
   * @param {boolean} persistent does it outlast the page?
   * @param {(key: string | null) => void} [onChange] another tab has written this key, or cleared all
   */
  constructor(persistent, onChange) {
    this.#persistent = persistent;
    if (!persistent || !onChange) return;
    globalThis.addEventListener?.("storage", ({ key }) => {
      if (key === null) onChange(null);
      else if (key.startsWith(PREFIX)) onChange(key.slice(PREFIX.length));
    });
  }

  /** @param {string} key */
  get(key) {
    const unwritten = this.#unwritten.get(key);
    return unwritten === undefined ? (this.#ask((storage) => storage.getItem(PREFIX + key)) ?? null) : unwritten;
  }

  /**
   * Returns whether the browser has taken it. If so, there may be room again for what it has refused before.
   * @param {string} key
   * @param {string | null} text null deletes it
   */
  set(key, text) {
    const isWritten = this.#write(key, text);
    if (isWritten) {
      // The newest first: it may be small and count what the others have lost.
      for (const [other, refused] of [...this.#unwritten].reverse()) this.#write(other, refused);
    } else {
      this.#unwritten.delete(key);
      this.#unwritten.set(key, text);
    }
    if (this.#unwritten.size === 0) this.failure = null;
    return isWritten;
  }

  /**
   * @param {string} key
   * @param {string | null} text
   */
  #write(key, text) {
    const isWritten = this.#ask((storage) => {
      if (text === null) storage.removeItem(PREFIX + key);
      else storage.setItem(PREFIX + key, text);
      return true;
    });
    if (isWritten) this.#unwritten.delete(key);
    return isWritten ?? false;
  }

  /**
   * Leaves an entry as the browser has it.
   * @param {string} key
   */
  revert(key) {
    this.#unwritten.delete(key);
    if (this.#unwritten.size === 0) this.failure = null;
  }

  /**
   * The keys that begin so, sorted.
   * @param {string} start
   */
  keys(start) {
    const written = this.#ask((storage) => Object.keys(storage)) ?? [];
    const keys = written.filter((key) => key.startsWith(PREFIX)).map((key) => key.slice(PREFIX.length));
    return [...new Set([...keys, ...this.#unwritten.keys()])].filter((key) => key.startsWith(start)).sort();
  }

  /** The keys that the browser has not taken. */
  get unwritten() {
    return this.#persistent ? [...this.#unwritten.keys()] : [];
  }

  /**
   * What the browser's store answers; undefined if there is none, or if it refuses.
   * @template T
   * @param {(storage: Storage) => T} act
   * @returns {T | undefined}
   */
  #ask(act) {
    if (!this.#persistent) return undefined;
    try {
      return act(localStorage);
    } catch (error) {
      this.failure = /** @type {Error} */ (error)?.name === "QuotaExceededError" ? "full" : "forbidden";
      return undefined;
    }
  }
}
