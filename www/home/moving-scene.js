// The moving scene at the top of the home page: plays the recorded story a few times while it is in sight, then rests
// at the end of the run, as it does at once under reduced motion. It can be paused and played again.

import { DARK_PALETTE, LIGHT_PALETTE } from "../pkg/constants.js";
import { text } from "../text/text.js";
import { byId, contextOf, setText } from "../widgets/dom.js";
import { Story } from "./story.js";

const darkScheme = matchMedia("(prefers-color-scheme: dark)");
const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");
/** More device pixels per CSS px than this are not worth their time. */
const MAX_PIXEL_RATIO = 2;
/** A frame that comes later than this, as after a while in another tab, goes on where the last one was, ms. */
const LONGEST_FRAME = 100;
/** 30 frames a second are enough for it, and take half the work of 60, ms. */
const SHORTEST_FRAME = 30;
/** How often the story plays until it rests: a page that is left open should not keep a computer busy. */
const ROUNDS = 3;

export class MovingScene {
  #figure = byId(document, "hero-scene");
  #canvas = byId(document, "hero-canvas", HTMLCanvasElement);
  #pause = byId(document, "hero-pause", HTMLButtonElement);
  #story;
  /** Since the beginning of the story, s. */
  #time = 0;
  /** How often the story has ended. */
  #rounds = 0;
  #paused = false;
  #inSight = false;
  /** When the last frame came, ms. */
  #last = 0;
  #frame = 0;

  /** @param {import("./recording.js").RecordedScene} scene */
  constructor(scene) {
    this.#story = new Story(scene);
    this.#pause.addEventListener("click", () => this.#setPaused(!this.#paused));
    reducedMotion.addEventListener("change", () => this.#obeyMotion());
    darkScheme.addEventListener("change", () => this.#draw());
    new ResizeObserver(() => this.#resize()).observe(this.#canvas);
    new IntersectionObserver(([{ isIntersecting }]) => {
      this.#inSight = isIntersecting;
      this.#schedule();
    }).observe(this.#canvas);
    this.#obeyMotion();
    this.#figure.classList.add("ready");
  }

  #obeyMotion() {
    if (reducedMotion.matches) this.#rest();
    else this.#setPaused(false);
  }

  #rest() {
    this.#time = this.#story.endOfRun;
    this.#rounds = 0;
    this.#setPaused(true);
  }

  /** @param {boolean} paused */
  #setPaused(paused) {
    this.#paused = paused;
    // From its rest it begins anew.
    if (!paused && this.#time === this.#story.endOfRun) this.#time = 0;
    setText(this.#pause, paused ? text.home.replay : text.home.pause);
    this.#last = 0;
    this.#draw();
    this.#schedule();
  }

  #resize() {
    const side = Math.round(this.#canvas.clientWidth * Math.min(devicePixelRatio, MAX_PIXEL_RATIO));
    if (side === 0 || side === this.#canvas.width) return;
    this.#canvas.width = this.#canvas.height = side;
    this.#draw();
  }

  #schedule() {
    cancelAnimationFrame(this.#frame);
    if (!this.#paused && this.#inSight) this.#frame = requestAnimationFrame((now) => this.#onFrame(now));
  }

  /** @param {number} now ms */
  #onFrame(now) {
    if (now - this.#last >= SHORTEST_FRAME) {
      if (this.#last) this.#time += Math.min(now - this.#last, LONGEST_FRAME) / 1000;
      this.#last = now;
      if (this.#time >= this.#story.duration) {
        this.#time = 0;
        this.#rounds += 1;
      }
      if (this.#rounds === ROUNDS) return this.#rest();
      this.#draw();
    }
    this.#schedule();
  }

  #draw() {
    const phase = this.#story.phaseAt(this.#time);
    if (this.#figure.dataset.phase !== phase) {
      this.#figure.dataset.phase = phase;
      setText(byId(document, "hero-caption"), this.#story.wordsOf(phase));
    }
    this.#story.draw(contextOf(this.#canvas), darkScheme.matches ? DARK_PALETTE : LIGHT_PALETTE, this.#time);
  }
}
