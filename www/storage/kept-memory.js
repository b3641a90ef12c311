// What each model remembers of the puzzles that were played in this browser: the JSON of the wasm's memory, in which
// each puzzle also has the key that its attempts are kept under, and a custom one its name. What cannot be read is
// forgotten. Knows nothing of the document, nor how a memory is used.

/**
 * A puzzle that is remembered; all but its key and its name is the wasm's.
 * @typedef {{ key: string, name?: string, attempts: { ball: import("../pkg/pathlight.js").Ball }[] }} Remembered
 */
/** @typedef {{ puzzles: Remembered[], [rest: string]: unknown }} Memory */

const PREFIX = "memory.";
/**
 * The most characters of a memory: some 3,700 attempts, of the 4,000 that the wasm remembers, or fewer at custom
 * scenes. Browsers keep some 5 million characters in all.
 */
const MOST = 200_000;

/** Fires "change" whenever a model remembers something else, also when another tab has written it. */
export class KeptMemory extends EventTarget {
  /** Was a memory damaged or of another format, so that it is gone? */
  damaged = false;
  #store;

  /** @param {import("./browser-store.js").BrowserStore} store */
  constructor(store) {
    super();
    this.#store = store;
  }

  /**
   * The puzzles that a model remembers, the latest last.
   * @param {string} model
   */
  puzzles(model) {
    return this.#read(model)?.puzzles ?? [];
  }

  /**
   * What a model remembers of all puzzles but one: they, and as JSON for the wasm; null for nothing.
   * @param {string} model
   * @param {string} key
   */
  without(model, key) {
    const memory = this.#read(model);
    const puzzles = memory?.puzzles.filter((puzzle) => puzzle.key !== key) ?? [];
    return { puzzles, json: puzzles.length > 0 ? JSON.stringify({ ...memory, puzzles }) : null };
  }

  /**
   * Adds the last puzzle of the wasm's `Memory`. Each ball at a puzzle is remembered once.
   * @param {string} model
   * @param {{ key: string, name: string | null }} puzzle
   * @param {string} json
   */
  add(model, { key, name }, json) {
    const { puzzles: played, ...head } = /** @type {Memory} */ (JSON.parse(json));
    const latest = played.at(-1);
    if (!latest) return;
    const all = this.puzzles(model);
    const before = all.find((puzzle) => puzzle.key === key)?.attempts ?? [];
    const balls = new Set(before.map(({ ball }) => String(ball)));
    const attempts = [...before, ...latest.attempts.filter(({ ball }) => !balls.has(String(ball)))];
    const puzzle = { ...latest, key, ...(name === null ? {} : { name }), attempts };
    const puzzles = [...all.filter((one) => one.key !== key), puzzle];
    // The wasm also counts the puzzles that it forgot. Here puzzles change places, so that number would mean nothing.
    const text = () => JSON.stringify({ ...head, forgotten: 0, puzzles });
    while (text().length > MOST) puzzles.shift();
    // What the browser does not take lasts as long as the page, which the home page says of all that is kept.
    this.#store.set(PREFIX + model, text());
    this.#changed();
  }

  /** @param {string} model */
  forget(model) {
    this.#store.set(PREFIX + model, null);
    this.damaged = false;
    this.#changed();
  }

  /** Forgets what all models remember. */
  clear() {
    for (const key of this.#store.keys(PREFIX)) this.#store.set(key, null);
    this.#changed();
  }

  /**
   * Deletes a memory that cannot be read, here or by the wasm.
   * @param {string} model
   */
  dropDamaged(model) {
    this.#store.set(PREFIX + model, null);
    this.damaged = true;
  }

  /**
   * Another tab has written this key; that counts more than what the browser had not taken.
   * @param {string | null} key null for all
   */
  refresh(key) {
    if (!(key ?? PREFIX).startsWith(PREFIX)) return;
    if (key !== null) this.#store.revert(key);
    this.#changed();
  }

  /**
   * @param {string} model
   * @returns {Memory | null}
   */
  #read(model) {
    const text = this.#store.get(PREFIX + model);
    if (text === null) return null;
    try {
      /** @type {Memory} */
      const memory = JSON.parse(text);
      // The rest of it is checked by the wasm.
      if (memory.puzzles.every(({ key, attempts }) => key && attempts.every(({ ball }) => ball))) return memory;
    } catch {
      // It is damaged too.
    }
    this.dropDamaged(model);
    return null;
  }

  #changed() {
    this.dispatchEvent(new Event("change"));
  }
}
