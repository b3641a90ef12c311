// The top of the home page: what this is in one sentence, the moving scene, and the ways to play it. It is there before
// the wasm.

import { byId, setText } from "../widgets/dom.js";
import { hrefOf, showsHome } from "../state/links.js";
import { text } from "../text/text.js";
import { SCENE_TASK } from "./home-tasks.js";
import { MovingScene } from "./moving-scene.js";
import { readRecording } from "./recording.js";

/** @typedef {import("../state/url-state.js").State} State */

export class Hero {
  #started = false;

  /** @param {State} state */
  setState(state) {
    if (showsHome(state)) this.#start();
    const { title, titleWithoutModel } = text.home;
    setText(byId(document, "gallery-title"), state.hide.includes("imagine") ? titleWithoutModel : title);
    // With the first model, whose guess it is.
    const recorded = { ...state, model: null };
    byId(document, "hero-play", HTMLAnchorElement).href = hrefOf(recorded, SCENE_TASK) ?? "#";
    byId(document, "hero-make", HTMLAnchorElement).href = hrefOf(recorded, SCENE_TASK, "make") ?? "#";
  }

  /** Starts the moving scene, when the home page is first seen. */
  #start() {
    if (this.#started) return;
    this.#started = true;
    readRecording().then(
      ({ scene }) => new MovingScene(scene),
      // The words and the links stand alone.
      () => (byId(document, "hero-scene").hidden = true),
    );
  }
}
