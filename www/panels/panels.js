// What shows the model think, joined: the story of its stages, the value under the pointer, imagined against real,
// predictions, its balls one by one, the map of all solutions, and the scoreboard. The page hands it the session
// and the state; it asks for another state by "set", and lays what belongs there over the scene.

import { Actual } from "./imagined-vs-real.js";
import { Predict } from "./predict.js";
import { Reading } from "./probe.js";
import { Scoreboard } from "./scoreboard.js";
import { SolveMap } from "./solve-map.js";
import { Stack } from "./proposals.js";
import { Story } from "./story.js";

export class Thinking extends EventTarget {
  #imagine;
  #canvas;
  #story;
  #reading;
  #actual;
  #predict;
  #stack;
  #solveMap;
  #scoreboard;
  #state = null;

  /** `canvas`: the scene's. `progress`: the player's record. */
  constructor(wasm, model, imagine, canvas, progress) {
    super();
    this.#imagine = imagine;
    this.#canvas = canvas;
    this.#story = new Story(imagine);
    this.#reading = new Reading(imagine);
    this.#actual = new Actual(wasm, imagine);
    this.#predict = new Predict(wasm, imagine);
    this.#stack = new Stack(model, imagine);
    this.#solveMap = new SolveMap(wasm, model, imagine);
    this.#scoreboard = new Scoreboard(wasm, model, progress);
    for (const part of [this.#story, this.#stack, this.#solveMap]) {
      part.addEventListener("set", ({ detail }) => this.dispatchEvent(new CustomEvent("set", { detail })));
    }
    imagine.addEventListener("imagined", () => this.#lay());
    this.#predict.addEventListener("sketch", () => this.#lay());
    this.#solveMap.addEventListener("lay", () => this.#lay());
  }

  show(session) {
    this.#reading.clear();
    for (const part of [this.#actual, this.#predict, this.#stack, this.#solveMap, this.#scoreboard]) part.show(session);
    session.addEventListener("change", () => this.#lay());
  }

  /** The puzzle is being left. */
  leave() {
    this.#solveMap.leave();
  }

  set(state) {
    this.#state = state;
    for (const part of [this.#story, this.#reading, this.#predict, this.#stack, this.#solveMap]) part.set(state);
    this.#lay();
  }

  set dark(dark) {
    for (const part of [this.#actual, this.#predict, this.#solveMap]) part.dark = dark;
  }

  /** Lays over the scene what the state asks for. */
  #lay() {
    if (!this.#state) return;
    const { panel, opacity, layers } = this.#state;
    // Where a ball of the model's comes from is seen on the map that orders the balls.
    const source = this.#imagine.values?.judge ? "judge" : "placement";
    const shown = this.#stack.open && !layers.includes(source) ? [...layers, source] : layers;
    const drawing = panel === "predict";
    Object.assign(this.#canvas, {
      maps: [...this.#solveMap.maps, ...this.#imagine.laid(shown)],
      opacity,
      marks: this.#stack.marks,
      sketch: drawing ? this.#predict.sketch : [],
      pen: drawing ? this.#predict : null,
    });
    this.#canvas.draw();
  }
}
