// The clock of a rollout: play, pause, step, seek, speed. It counts steps, and fires "tick" when there is a new moment
// to draw; it knows nothing of what is drawn.

import { STEPS_PER_SECOND } from "../shell/constants.js";

/** A tab that slept goes on where it was: one frame advances the clock by no more than this, ms. */
const MAX_FRAME = 100;

export class Playback extends EventTarget {
  /** Steps since the start; between two of them while it plays. */
  step = 0;
  /** The last step. */
  last = 0;
  /** How many times faster than real time. */
  speed = 1;
  /**
   * How many times as fast a step is played as others, as long as the person has not chosen a speed.
   * @type {(step: number) => number}
   */
  pace = () => 1;
  playing = false;
  /** Steps per second while it plays, or null for real time by `speed`. */
  #rate = /** @type {number | null} */ (null);
  #lastFrame = 0;
  /** The frame that is awaited while it plays. */
  #frame = 0;

  /**
   * Loads a rollout by its number of steps, paused at a step.
   * @param {number} last
   * @param {number} [step]
   */
  load(last, step = 0) {
    this.stop();
    this.#rate = null;
    this.last = last;
    this.#moveTo(step);
  }

  get ended() {
    return this.step >= this.last;
  }

  get seconds() {
    return this.step / STEPS_PER_SECOND;
  }

  /**
   * Plays on, or from the start if it has ended.
   * @param {number} [duration] of the whole rollout, ms; else it plays in real time
   */
  play(duration) {
    if (this.playing || this.last === 0) return;
    this.#rate = duration ? (1000 * this.last) / duration : null;
    if (this.ended) this.step = 0;
    this.playing = true;
    this.#lastFrame = performance.now();
    this.#frame = requestAnimationFrame(this.#onFrame);
    this.#moveTo(this.step);
  }

  pause() {
    if (!this.playing) return;
    this.stop();
    this.#moveTo(Math.floor(this.step));
  }

  /**
   * Pauses at a step.
   * @param {number} step
   */
  seek(step) {
    this.stop();
    this.#moveTo(Math.round(step));
  }

  /**
   * Goes on from a later step.
   * @param {number} step
   */
  skipTo(step) {
    this.#moveTo(step);
  }

  /** Stops for good, without a tick. */
  stop() {
    this.playing = false;
    cancelAnimationFrame(this.#frame);
  }

  get #pacedSpeed() {
    return this.speed === 1 ? this.pace(this.step) : this.speed;
  }

  /** @param {number} now */
  #onFrame = (now) => {
    const elapsed = Math.min(now - this.#lastFrame, MAX_FRAME) / 1000;
    this.#lastFrame = now;
    const step = this.step + Math.max(elapsed, 0) * (this.#rate ?? STEPS_PER_SECOND * this.#pacedSpeed);
    if (step >= this.last) this.playing = false;
    else this.#frame = requestAnimationFrame(this.#onFrame);
    this.#moveTo(step);
  };

  /** @param {number} step */
  #moveTo(step) {
    this.step = Math.min(Math.max(step, 0), this.last);
    this.dispatchEvent(new Event("tick"));
  }
}
