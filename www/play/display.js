// What one puzzle shows: the state (shown.js), the rollouts that the wasm's Game holds for it, and the clock. Tells
// when something changes, by the events "change", "draw" and "attempted" of session.js.

import { paceAt, quietEnd } from "./pace.js";
import { Playback } from "./playback.js";
import * as show from "./shown.js";

/** @typedef {import("./shown.js").Ghost} Ghost */

/** @type {import("../pkg/pathlight.js").Moments} */
const NO_MOMENTS = { quiet: [], contact: null, deciding: null };

export class Display extends EventTarget {
  /** The wasm's Game; freed by `close`. */
  game;
  playback = new Playback();
  /** Changes whenever something else is shown or the ball is placed elsewhere. */
  revision = 0;
  /** Moments of what is shown that playback treats in a special way. */
  moments = NO_MOMENTS;
  #state = show.START;
  #prefersReducedMotion;

  /**
   * @param {import("../pkg/pathlight.js").Game} game
   * @param {() => boolean} prefersReducedMotion asked before each run; if so, it goes straight to its end
   */
  constructor(game, prefersReducedMotion) {
    super();
    this.game = game;
    this.#prefersReducedMotion = prefersReducedMotion;
    this.playback.pace = (step) => paceAt(this.moments, step);
    this.playback.addEventListener("tick", () => this.#onTick());
  }

  get reducedMotion() {
    return this.#prefersReducedMotion();
  }

  /** What is shown, as one state. */
  get state() {
    return this.#state;
  }

  get phase() {
    return this.#state.kind;
  }

  get placing() {
    return this.#state.kind === "placing";
  }

  /** The attempt that is shown alone, or null. */
  get shown() {
    return this.#state.kind === "attempt" ? this.#state.attempt : null;
  }

  /** Has the shown rollout played to its end? */
  get finished() {
    return this.#state.kind !== "placing" && this.#state.ended;
  }

  /** Whose new attempt plays for the first time, and has its result hidden until it ends; null if none does. */
  get hiddenAuthor() {
    return show.hiddenAuthor(this.#state);
  }

  /** When the shown attempt came nearest to its goal, if it has ended as a miss that never touched; else null. */
  get approach() {
    return this.#state.kind === "attempt" ? this.#state.approach : null;
  }

  /**
   * The model's misses before the one that is shown in the show of its turn; null while none is shown so.
   * @type {Ghost[] | null}
   */
  get ghosts() {
    return this.#state.kind === "attempt" ? this.#state.ghosts : null;
  }

  /** Why the last request was refused, or null. */
  get refusal() {
    return this.#state.kind === "placing" ? this.#state.refusal : null;
  }

  /**
   * Takes up another tool, or says whether the scene is being edited and differs from the puzzle.
   * @param {Partial<import("./shown.js").Editing>} editing
   */
  edit(editing) {
    const { tool = this.#state.tool, edited = this.#state.edited } = editing;
    if (tool === this.#state.tool && edited === this.#state.edited) return;
    this.#state = show.editing(this.#state, { tool, edited });
    this.emit("change");
  }

  /** @param {number} step */
  seek(step) {
    this.playback.seek(step);
    this.emit("change");
  }

  /** The end of the stretch that plays and in which nothing moves; null if something does, or nothing plays. */
  get quietEnd() {
    return this.playback.playing && this.ghosts === null ? quietEnd(this.moments, this.playback.step) : null;
  }

  /** Skips the stretch in which nothing moves. */
  skipQuiet() {
    const { quietEnd: end } = this;
    if (end !== null) this.playback.skipTo(end);
  }

  /** Returns to placing, with the ball where it was. */
  reset() {
    this.revealResult();
    this.game.reset();
    this.revision += 1;
    this.moments = NO_MOMENTS;
    this.#state = show.placing(this.#state);
    this.playback.load(0);
    this.emit("change");
  }

  /** A new attempt has run to its end, or was left: its result may be shown. */
  revealResult() {
    const author = this.hiddenAuthor;
    if (author === null) return;
    this.#state = show.revealed(this.#state);
    this.emit(author === "player" ? "attempted" : "change");
  }

  /**
   * Says why what was asked for does not happen; null takes that back.
   * @param {string | null} words
   */
  refuse(words) {
    this.#state = show.refused(this.#state, words);
    this.emit("change");
  }

  /**
   * Stops the clock and frees the wasm's `Game`. `revealResult` comes before. The session must not be used afterwards.
   */
  close() {
    this.playback.stop();
    this.game.free();
  }

  /**
   * Shows the rollouts that the puzzle holds now.
   * @protected
   * @param {import("./shown.js").Run} run
   * @param {{ play?: boolean, duration?: number }} [how]
   */
  show(run, { play = true, duration } = {}) {
    this.revealResult();
    this.revision += 1;
    this.#state = show.running(this.#state, run);
    this.moments = this.game.moments();
    const last = this.game.steps();
    const atEnd = !play || this.reducedMotion;
    this.playback.load(last, atEnd ? last : 0);
    if (!atEnd) this.playback.play(duration);
    this.emit("change");
  }

  #onTick() {
    const { playing, ended } = this.playback;
    if (!this.placing && ended && !playing && !this.finished) {
      const approach = show.neverTouched(this.#state) ? this.game.closestApproach() : undefined;
      this.#state = show.ended(this.#state, approach ?? null);
      this.revealResult();
      this.emit("change");
    }
    this.emit("draw");
  }

  /**
   * @protected
   * @param {"change" | "draw" | "attempted"} event
   */
  emit(event) {
    this.dispatchEvent(new Event(event));
  }
}
