// The attempts of player and model at one puzzle, and which model made its own. Fires "change". Knows nothing of what
// is shown, nor of the document.

/** @typedef {import("../pkg/pathlight.js").Ball} Ball */
/** @typedef {import("../pkg/pathlight.js").Contender} Contender */
/** @typedef {import("../pkg/pathlight.js").Attempt} Attempt */

export class Attempts extends EventTarget {
  /**
   * The name of the model that made the model's attempts, or null while there are none.
   * @type {string | null}
   */
  modelName = null;
  #puzzle;

  /** @param {import("../pkg/pathlight.js").Puzzle} puzzle */
  constructor(puzzle) {
    super();
    this.#puzzle = puzzle;
  }

  /** @param {Contender} contender */
  of(contender) {
    return this.#puzzle.attempts(contender);
  }

  /** @param {Contender} contender */
  standing(contender) {
    return this.#puzzle.standing(contender);
  }

  /**
   * Makes attempts of the player's again that were made before; nothing of them is shown.
   * @param {Ball[]} balls
   */
  restore(balls) {
    if (balls.length === 0) return;
    for (const ball of balls) {
      // A ball of another version may not fit any more.
      if (this.#puzzle.whyInvalid(...ball) === undefined) this.#puzzle.attempt(...ball);
    }
    this.#puzzle.reset();
    this.#changed();
  }

  /**
   * Adds attempts that a model has made before.
   * @param {Attempt[]} attempts
   * @param {string} modelName
   */
  restoreModel(attempts, modelName) {
    if (attempts.length === 0) return;
    for (const attempt of attempts) {
      if (this.#puzzle.whyInvalid(...attempt.ball) === undefined) this.#add(attempt, modelName);
    }
    this.#changed();
  }

  /**
   * Adds an attempt that has been simulated for a model; one with the same ball is not added again. Returns its number.
   * @param {Attempt} attempt
   * @param {string} modelName
   */
  add(attempt, modelName) {
    const number = this.#add(attempt, modelName);
    this.#changed();
    return number;
  }

  /**
   * @param {Attempt} attempt
   * @param {string} modelName
   */
  #add(attempt, modelName) {
    const { number } = this.#puzzle.addModelAttempt(attempt);
    this.modelName = modelName;
    return number;
  }

  /**
   * Deletes an attempt; those after it move up by one.
   * @param {Contender} contender
   * @param {number} number
   */
  remove(contender, number) {
    this.#puzzle.remove(contender, number);
    this.#changed();
  }

  /** @param {Contender} contender */
  clear(contender) {
    this.#puzzle.clear(contender);
    if (contender === "model") this.modelName = null;
    this.#changed();
  }

  #changed() {
    this.dispatchEvent(new Event("change"));
  }
}
