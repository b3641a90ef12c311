// The clock of a rollout: play, pause, step, scrub, speed. It counts steps, and says when there is a new
// moment to draw; it knows nothing of what is drawn.

const STEPS_PER_SECOND = 60;

export class Playback extends EventTarget {
  /** Steps since the start; between two of them while it plays. */
  step = 0;
  /** The last step. */
  last = 0;
  /** How many times faster than life. */
  speed = 1;
  playing = false;
  #then = 0;

  /** Puts a rollout of so many steps on, at its start or its end. */
  load(last, step = 0) {
    this.pause();
    this.last = last;
    this.#move(step);
  }

  get ended() {
    return this.step >= this.last;
  }

  get seconds() {
    return this.step / STEPS_PER_SECOND;
  }

  /** Plays on, or from the start when it is over. */
  play() {
    if (this.playing || this.last === 0) return;
    if (this.ended) this.step = 0;
    this.playing = true;
    this.#then = performance.now();
    requestAnimationFrame(this.#tick);
    this.#move(this.step);
  }

  pause() {
    if (!this.playing) return;
    this.playing = false;
    this.#move(Math.floor(this.step));
  }

  /** Stops at a step. */
  seek(step) {
    this.playing = false;
    this.#move(Math.round(step));
  }

  #tick = (now) => {
    if (!this.playing) return;
    // A tab that slept goes on where it was.
    const passed = Math.min(now - this.#then, 100) / 1000;
    this.#then = now;
    const step = this.step + Math.max(passed, 0) * STEPS_PER_SECOND * this.speed;
    if (step >= this.last) this.playing = false;
    else requestAnimationFrame(this.#tick);
    this.#move(step);
  };

  #move(step) {
    this.step = Math.min(Math.max(step, 0), this.last);
    this.dispatchEvent(new Event("moment"));
  }
}
