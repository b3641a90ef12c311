// Which puzzle a state asks for: a task that exists, or a custom scene, whose text has to be unpacked first.

import { TASKS } from "../puzzles/templates.js";
import { knownScene, sceneOfText } from "../editor/scene-link.js";
import { text as catalogue } from "../text/text.js";

/** @typedef {import("../state/url-state.js").State} State */

const KNOWN_TASKS = new Set(TASKS);

export class AskedPuzzle {
  #onRead;
  /**
   * The text of a custom scene that could not be read, and why.
   * @type {{ text: string, sentence: string } | null}
   */
  #unreadable = null;

  /** @param {(scene: string) => void} onRead is called when the text of a custom scene was read, or could not be */
  constructor(onRead) {
    this.#onRead = onRead;
  }

  /**
   * What a state plays; null if it is nothing, or a custom scene that is still to be read.
   * @param {State} state
   * @returns {import("../pkg/pathlight.js").Puzzle | null}
   */
  puzzleOf({ task, scene }) {
    if (scene === null) return task;
    const known = knownScene(scene);
    if (!known && this.#unreadable?.text !== scene) this.#read(scene);
    return known;
  }

  /**
   * Why there is no puzzle for a state; null if there is one, or may be.
   * @param {State} state
   */
  problemOf({ task, scene }) {
    if (scene !== null) return this.#unreadable?.text === scene ? this.#unreadable.sentence : null;
    return task === null || KNOWN_TASKS.has(task) ? null : catalogue.element.noPuzzle(task);
  }

  /** @param {string} text */
  async #read(text) {
    try {
      await sceneOfText(text);
    } catch (error) {
      this.#unreadable = { text, sentence: /** @type {Error} */ (error).message };
    }
    this.#onRead(text);
  }
}
