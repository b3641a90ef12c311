// What shows the model think, joined: the story of its four stages and the value under the pointer. The page
// hands it the session and the state; it asks for other states by "set", and says by "lay" that what lies over
// the scene has changed.

import { Reading } from "./reading.js";
import { Story } from "./story.js";

export class Thinking extends EventTarget {
  #imagine;
  #story;
  #reading;

  constructor(imagine) {
    super();
    this.#imagine = imagine;
    this.#story = new Story(imagine);
    this.#reading = new Reading(imagine);
    for (const part of [this.#story]) {
      part.addEventListener("set", ({ detail }) => this.dispatchEvent(new CustomEvent("set", { detail })));
    }
  }

  show() {
    this.#reading.clear();
  }

  set(state) {
    this.#story.set(state);
    this.#reading.set(state);
  }

  /** The maps to lay over the scene, canvases. */
  get maps() {
    return this.#imagine.shown;
  }
}
