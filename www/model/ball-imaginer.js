// Asks the worker what the model imagines for a ball that may change all the time. Knows nothing of the document.

import { sameBall } from "../puzzles/ball.js";
import { LatestCall } from "./latest-call.js";

/** @typedef {import("../pkg/pathlight.js").Ball} Ball */
/** @typedef {import("../pkg/pathlight.js").ImaginedBall} ImaginedBall */
/** @typedef {import("../pkg/pathlight.js").Played} Played */

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
  /** @type {LatestCall<{ played: Played, ball: Ball }, BallImaginer["answer"]>} */
  #asking;

  /**
   * Fires "answer" when there is another answer, or none any more.
   * @param {import("./shared-client.js").SharedClient} client
   */
  constructor(client) {
    super();
    this.#client = client;
    this.#asking = new LatestCall(
      ({ played, ball }, signal) => this.#answerFor(played, ball, signal),
      (answer) => answer !== this.answer && this.#set(answer),
      (message) => this.#set(null, message),
    );
    client.addEventListener("change", () => client.status !== "ready" && this.forget());
  }

  /** Has the loaded model learned to imagine balls? */
  get able() {
    return this.#client.loaded?.card.dynamics !== undefined;
  }

  /** The answer in the form in which it is drawn over the scene. */
  get paths() {
    if (!this.answer) return null;
    const {
      of,
      imagined: { object, ball, errors },
    } = this.answer;
    return { of, object, ball, errors };
  }

  /**
   * Asks for a ball, unless there is an answer for it.
   * @param {Played} played
   * @param {Ball} ball
   */
  imagine(played, ball) {
    if (this.able) this.#asking.ask({ played, ball });
  }

  /**
   * @param {Played} played
   * @param {Ball} ball
   * @param {AbortSignal} signal
   */
  async #answerFor(played, ball, signal) {
    if (sameBall(ball, this.answer?.of)) return this.answer;
    const imagined = await this.#client.call("imagineBall", [played, ball], signal);
    return imagined && { of: ball, imagined };
  }

  /** Forgets the answer: it is another puzzle's or another model's. */
  forget() {
    this.#asking.stop();
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
