// The puzzles of a person's own that this browser keeps, in localStorage as JSON: an array of scenes, oldest first. A
// store that is forbidden, full or damaged keeps nothing but never breaks the page. Knows nothing of the document.

import { pathlight } from "../shell/page-api.js";
import { plainScene } from "./plain-scene.js";

/** @typedef {import("../pkg/pathlight.js").OwnScene} OwnScene */

const KEY = "pathlight.own-puzzles";

class OwnPuzzles extends EventTarget {
  /** @type {OwnScene[]} */
  #scenes = [];
  /**
   * What is stored but may not be played, as another version may have written it; it stays there.
   * @type {unknown[]}
   */
  #unread = [];

  /** Fires "change" whenever it holds something else, also when another tab has written it. */
  constructor() {
    super();
    this.#read();
    addEventListener("storage", ({ key }) => {
      if (key !== KEY && key !== null) return;
      this.#read();
      this.dispatchEvent(new Event("change"));
    });
  }

  /** All puzzles, oldest first. */
  get scenes() {
    return [...this.#scenes];
  }

  /** @param {OwnScene} scene */
  #has(scene) {
    return this.#scenes.some((one) => same(one, scene));
  }

  /**
   * Keeps puzzles; those that are kept already stay once. Returns why they could not be kept, or null.
   * @param {OwnScene[]} scenes
   * @returns {string | null}
   */
  add(scenes) {
    this.#read();
    const own = scenes.map(plainScene);
    const fresh = own.filter(
      (scene, index) => !this.#has(scene) && !own.slice(0, index).some((one) => same(one, scene)),
    );
    return this.#write([...this.#scenes, ...fresh]);
  }

  /**
   * Forgets a puzzle.
   * @param {OwnScene} scene
   */
  remove(scene) {
    this.#read();
    return this.#write(this.#scenes.filter((one) => !same(one, scene)));
  }

  #read() {
    try {
      const stored = JSON.parse(localStorage.getItem(KEY) ?? "[]");
      const all = Array.isArray(stored) ? stored : [];
      this.#scenes = all.filter((scene) => pathlight.sceneProblems(scene).length === 0);
      this.#unread = all.filter((scene) => !this.#scenes.includes(scene));
    } catch {
      this.#scenes = [];
      this.#unread = [];
    }
  }

  /** @param {OwnScene[]} scenes */
  #write(scenes) {
    try {
      localStorage.setItem(KEY, JSON.stringify([...scenes, ...this.#unread]));
    } catch {
      return "This browser keeps nothing for the page, or has no room left: save the puzzle as a file, or copy its link.";
    }
    this.#scenes = scenes;
    this.dispatchEvent(new Event("change"));
    return null;
  }
}

/**
 * @param {OwnScene} one
 * @param {OwnScene} other
 */
function same(one, other) {
  return JSON.stringify(one) === JSON.stringify(other);
}

/** @type {OwnPuzzles | null} */
let shared = null;

/** The puzzles that this browser keeps. */
export function ownPuzzles() {
  return (shared ??= new OwnPuzzles());
}
