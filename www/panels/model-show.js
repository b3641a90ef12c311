// The model's turn as a show: its misses run one after the other, fast and ever faster, and stay in sight as ghosts;
// then whoever made the show goes on with the result. The worker is faster than the show, so attempts wait here until
// it is their turn, and are recorded then.

/** @typedef {import("../play/session.js").Session} Session */
/** @typedef {import("../pkg/pathlight.js").Attempt} Attempt */

/** How long the first miss is shown, ms; each further one is shorter by a factor, down to the shortest. */
const FIRST = 700;
const FASTER = 0.88;
const SHORTEST = 70;

export class ModelShow {
  #session;
  #record;
  /** @type {Attempt[]} */
  #waiting = [];
  /**
   * The attempt that solves, once it has come. Whoever made the show records it when it is shown.
   * @type {Attempt | null}
   */
  solution = null;
  /** Will more attempts come? */
  #ended = false;
  /** Are attempts recorded without being shown? */
  #skipping;
  #stopped = false;
  /** The session's revision after what this has shown last. */
  #revision;
  /**
   * Wakes the show when something has come.
   * @type {() => void}
   */
  #wake = () => {};

  /**
   * @param {Session} session
   * @param {(attempt: Attempt) => number} record adds an attempt to the session, unless it is there already; returns
   *   its number
   */
  constructor(session, record) {
    this.#session = session;
    this.#record = record;
    this.#revision = session.revision;
    // What is being watched is not interrupted; with reduced motion only the result is shown.
    this.#skipping = session.reducedMotion || session.playback.playing || session.shown?.preview === true;
  }

  /** Has the person placed or shown something since? Nothing is shown in its place. */
  get interrupted() {
    return this.#session.revision !== this.#revision;
  }

  /** @param {Attempt} attempt */
  add(attempt) {
    this.#waiting.push(attempt);
    if (this.#skipping) this.#recordAll();
    this.#wake();
  }

  /** No more attempts will come. */
  end() {
    this.#ended = true;
    this.#wake();
  }

  /** Goes to the result. */
  skip() {
    this.#skipping = true;
    this.#recordAll();
    this.#clear();
    this.#wake();
  }

  /** Ends the show; attempts that have not been shown are dropped. */
  stop() {
    this.#stopped = true;
    this.#waiting = [];
    this.#clear();
    this.#wake();
  }

  /** Shows the misses. Resolves when all that came is recorded and the misses are shown, or when it is stopped. */
  async run() {
    /** @type {import("../play/shown.js").Ghost[]} */
    const ghosts = [];
    for (let duration = FIRST; ; duration = Math.max(SHORTEST, duration * FASTER)) {
      while (this.#waiting.length === 0 && !this.#ended && !this.#stopped)
        await new Promise((resolve) => (this.#wake = () => resolve(null)));
      const attempt = this.#waiting.shift();
      if (this.#stopped || !attempt) break;
      const { used } = this.#session.attempts.standing("model");
      const number = this.#take(attempt);
      // A turn that was stopped goes on after what has been shown of it.
      if (this.#skipping || this.interrupted || number === null || number <= used) continue;
      this.#session.flash(number, duration, ghosts.slice());
      this.#revision = this.#session.revision;
      await this.#playedToEnd();
      if (this.#stopped) return;
      const paths = this.#session.game.sampledPaths();
      if (!this.interrupted && paths) ghosts.push({ ball: attempt.ball, object: paths.object });
    }
    this.#clear();
  }

  /** Resolves once the miss that is shown has played to its end, or something else is shown. */
  async #playedToEnd() {
    const { promise, resolve } = Promise.withResolvers();
    const check = () => (this.interrupted || this.#session.finished) && resolve(null);
    this.#session.addEventListener("change", check);
    check();
    await promise;
    this.#session.removeEventListener("change", check);
  }

  /** Takes the miss that is shown away. */
  #clear() {
    if (!this.#session.ghosts) return;
    this.#session.reset();
    this.#revision = this.#session.revision;
  }

  #recordAll() {
    for (const attempt of this.#waiting.splice(0)) this.#take(attempt);
  }

  /**
   * Records a miss and returns its number; keeps the solution, and returns null.
   * @param {Attempt} attempt
   */
  #take(attempt) {
    if (!attempt.ending.solved) return this.#record(attempt);
    this.solution = attempt;
    return null;
  }
}
