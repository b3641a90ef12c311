// How a person likes the page, as far as this browser remembers it: whether the model's guess is shown, whether the
// model remembers puzzles, and whether the story has been told. Knows nothing of the document.

import { BrowserStore } from "./browser-store.js";

const GUESS = "guess";
const REMEMBERS = "remembers";
const STORY = "story";

export class Preferences {
  #persistent;
  #store;

  /** @param {boolean} persistent do they outlast the page? If not, nothing is shown that was not asked for */
  constructor(persistent) {
    this.#persistent = persistent;
    this.#store = new BrowserStore(persistent);
  }

  /** Is the model's guess shown where a link does not say? To newcomers it is, where they can turn it off for good. */
  get guess() {
    const said = this.#store.get(GUESS);
    return said === null ? this.#persistent : said !== "off";
  }
  set guess(on) {
    this.#store.set(GUESS, on ? "on" : "off");
  }

  /** Does the model remember puzzles where a link does not make it play afresh? Only if the person has asked for it. */
  get remembers() {
    return this.#store.get(REMEMBERS) === "on";
  }
  set remembers(on) {
    this.#store.set(REMEMBERS, on ? "on" : "off");
  }

  /** Returns true the first time. */
  takeStory() {
    if (!this.#persistent || this.#store.get(STORY) !== null) return false;
    this.#store.set(STORY, "told");
    return true;
  }
}
