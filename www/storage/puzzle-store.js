// The custom puzzles that this browser keeps, as JSON: an array of scenes, oldest first. A store that is forbidden,
// full or damaged keeps nothing but never breaks the page. Knows nothing of the document.

import { text as catalogue } from "../text/text.js";
import { BrowserStore } from "./browser-store.js";

/** @typedef {import("../pkg/pathlight.js").CustomScene} CustomScene */

const KEY = "own-puzzles";
/** The most puzzles that are kept; the grid shows them without delay. */
export const MOST_PUZZLES = 500;

export class PuzzleStore extends EventTarget {
  #store;
  /** @type {string | null} what was read last */
  #text = null;
  /** @type {Map<string, CustomScene>} by its JSON */
  #scenes = new Map();

  /** Fires "change" whenever it holds something else, also when another tab has written it. */
  constructor() {
    super();
    this.#store = new BrowserStore(true, (key) => {
      if (key !== KEY && key !== null) return;
      this.#read();
      this.dispatchEvent(new Event("change"));
    });
    this.#read();
  }

  /** All puzzles, oldest first. Some may not be playable, as another version may have written them. */
  get scenes() {
    return [...this.#scenes.values()];
  }

  /**
   * Keeps puzzles; those that are kept already stay once. Returns how many are new, for how many there was no room, and
   * why no new one could be kept, or null.
   * @param {CustomScene[]} scenes plain ones
   */
  add(scenes) {
    this.#read();
    const all = new Map(this.#scenes);
    let left = 0;
    for (const scene of scenes) {
      const text = JSON.stringify(scene);
      if (all.has(text)) continue;
      if (all.size < MOST_PUZZLES) all.set(text, scene);
      else left += 1;
    }
    const added = all.size - this.#scenes.size;
    const full = catalogue.reading.puzzleStore.full(MOST_PUZZLES);
    return { added, left, failure: added > 0 ? this.#write(all) : left > 0 ? full : null };
  }

  /**
   * Forgets a puzzle. Returns why it could not, or null.
   * @param {CustomScene} scene
   */
  remove(scene) {
    this.#read();
    const all = new Map(this.#scenes);
    all.delete(JSON.stringify(scene));
    return this.#write(all);
  }

  #read() {
    const text = this.#store.get(KEY);
    if (text === this.#text) return;
    this.#text = text;
    const stored = parsed(text);
    this.#scenes = new Map((Array.isArray(stored) ? stored : []).map((scene) => [JSON.stringify(scene), scene]));
  }

  /** @param {Map<string, CustomScene>} scenes */
  #write(scenes) {
    const text = `[${[...scenes.keys()].join(",")}]`;
    if (!this.#store.set(KEY, text)) {
      this.#store.revert(KEY);
      return catalogue.reading.puzzleStore.refused;
    }
    this.#text = text;
    this.#scenes = scenes;
    this.dispatchEvent(new Event("change"));
    return null;
  }
}

/** @param {string | null} text */
function parsed(text) {
  try {
    return JSON.parse(text ?? "[]");
  } catch {
    return [];
  }
}

/** @type {PuzzleStore | null} */
let shared = null;

/** The puzzles that this browser keeps. */
export function customPuzzles() {
  return (shared ??= new PuzzleStore());
}
