// Asks the worker what the model imagines for a ball that may change all the time: the newest ball counts, and those that come
// while the worker is at work are left out, except for the last. Knows nothing of the document.

/** @typedef {import("./messages.js").Ball} Ball */
/** @typedef {import("./messages.js").ImaginedBall} ImaginedBall */
/** @typedef {import("./messages.js").Played} Played */

export class BallImaginer extends EventTarget {
  /**
   * The newest answer, and the ball that it is for.
   * @type {{ of: Ball, imagined: ImaginedBall } | null}
   */
  answer = null;
  /**
   * Why there is no answer, or null.
   * @type {string | null}
   */
  failure = null;
  #client;
  /** @type {Ball | null} */
  #wanted = null;
  /**
   * Runs while the worker is asked.
   * @type {AbortController | null}
   */
  #call = null;

  /**
   * Fires "answer" when there is another answer, or none any more.
   * @param {import("./shared-client.js").SharedClient} client
   */
  constructor(client) {
    super();
    this.#client = client;
    client.addEventListener("change", () => client.status !== "ready" && this.forget());
  }

  /** Has the loaded model learned to imagine balls? */
  get able() {
    return this.#client.loaded?.card.dynamics !== undefined;
  }

  /** The answer in the form in which it is drawn over the scene. */
  get paths() {
    if (!this.answer) return null;
    const { of, imagined: { object, ball, errors } } = this.answer;
    return { of, object, ball, errors };
  }

  /**
   * Asks for a ball, unless there is an answer for it; null asks for none.
   * @param {Played} played
   * @param {Ball | null} ball
   */
  async imagine(played, ball) {
    this.#wanted = ball;
    if (this.#call || !this.able) return;
    const call = (this.#call = new AbortController());
    try {
      for (let of = this.#unanswered; of; of = this.#unanswered) {
        const imagined = await this.#client.imagineBall(played, of, call.signal);
        if (call.signal.aborted) return;
        this.#set(imagined && { of, imagined });
        if (!imagined) break;
      }
    } catch (error) {
      if (!call.signal.aborted) this.#set(null, /** @type {Error} */ (error).message);
    } finally {
      if (this.#call === call) this.#call = null;
    }
  }

  /** The ball that is wanted, if the answer is not for it. */
  get #unanswered() {
    return String(this.#wanted) === String(this.answer?.of ?? null) ? null : this.#wanted;
  }

  /** Forgets the answer: it is another puzzle's or another model's. */
  forget() {
    this.#call?.abort();
    this.#call = null;
    this.#wanted = null;
    this.#set(null);
  }

  /**
   * @param {BallImaginer["answer"]} answer
   * @param {string | null} failure
   */
  #set(answer, failure = null) {
    this.answer = answer;
    this.failure = failure;
    this.dispatchEvent(new Event("answer"));
  }
}
