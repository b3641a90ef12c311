// Time that passes in frames, and can be paused and skipped.

export class PausableClock {
  paused = false;
  #skipped = false;

  /** Goes on at the end of the time that passes now. */
  skip() {
    this.#skipped = true;
    this.paused = false;
  }

  /**
   * Lets time pass. Rejects when the signal aborts.
   * @param {number} seconds
   * @param {AbortSignal} signal
   * @param {(time: number) => void} [onTime] called in each frame with the time that has passed, s
   * @returns {Promise<void>}
   */
  run(seconds, signal, onTime = () => {}) {
    this.#skipped = false;
    return new Promise((resolve, reject) => {
      let [time, last] = [0, performance.now()];
      const onFrame = (/** @type {number} */ now) => {
        if (signal.aborted) return reject(signal.reason);
        if (!this.paused) time += Math.max(now - last, 0) / 1000;
        last = now;
        if (this.#skipped || (time >= seconds && !this.paused)) return resolve();
        onTime(time);
        requestAnimationFrame(onFrame);
      };
      requestAnimationFrame(onFrame);
    });
  }
}
