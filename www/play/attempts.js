// The attempts of player and model at one puzzle, and which model made its own. Fires "change". Knows nothing of what
// is shown, nor of the document.

/** @typedef {import("../pkg/pathlight.js").Ball} Ball */
/** @typedef {import("../pkg/pathlight.js").Author} Author */
/** @typedef {import("../pkg/pathlight.js").Attempt} Attempt */
/** @typedef {import("../pkg/pathlight.js").Standing} Standing */

export class Attempts extends EventTarget {
  /**
   * The name of the model that made the model's attempts; null while there are none, and if it played with a memory:
   * the model of that name would do it otherwise.
   * @type {string | null}
   */
  modelName = null;
  /**
   * What is known of the player's attempts beside those that are here; null for nothing.
   * @type {() => { attempts: number, solved: number | null } | null}
   */
  counted = () => null;
  #game;

  /** @param {import("../pkg/pathlight.js").Game} game */
  constructor(game) {
    super();
    this.#game = game;
  }

  /** @param {Author} author */
  of(author) {
    return this.#game.attempts(author);
  }

  /**
   * How an author is doing, as the attempts that are here are numbered.
   * @param {Author} author
   */
  standing(author) {
    return this.#game.standing(author);
  }

  /**
   * How the player is doing. A solution has the number that it had before misses were deleted.
   * @returns {Standing}
   */
  get playerTotal() {
    const standing = this.standing("player");
    const counted = this.counted();
    if (standing.solved_at === null || !counted) return standing;
    return { used: Math.max(standing.used, counted.attempts), solved_at: counted.solved ?? standing.solved_at };
  }

  /**
   * Makes attempts of the player's again that were made before; nothing of them is shown.
   * @param {Ball[]} balls
   */
  restore(balls) {
    if (balls.length === 0) return;
    for (const ball of balls) {
      // A ball of another version may not fit any more.
      if (this.#game.whyInvalid(...ball) === undefined) this.#game.attempt(...ball);
    }
    this.#game.reset();
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
      if (this.#game.whyInvalid(...attempt.ball) === undefined) this.#add(attempt, modelName);
    }
    this.#changed();
  }

  /**
   * Adds an attempt that has been simulated for a model; one with the same ball is not added again. Returns its number.
   * @param {Attempt} attempt
   * @param {string | null} modelName null if it played with a memory
   * @param {boolean} [silent] is nothing told of it? Then it has to be shown at once
   */
  add(attempt, modelName, silent = false) {
    const number = this.#add(attempt, modelName);
    if (!silent) this.#changed();
    return number;
  }

  /**
   * @param {Attempt} attempt
   * @param {string | null} modelName
   */
  #add(attempt, modelName) {
    const { number } = this.#game.addModelAttempt(attempt);
    this.modelName = modelName;
    return number;
  }

  /**
   * Deletes an attempt; those after it move up by one.
   * @param {Author} author
   * @param {number} number
   */
  remove(author, number) {
    this.#game.remove(author, number);
    this.#changed();
  }

  /** @param {Author} author */
  clear(author) {
    this.#game.clear(author);
    if (author === "model") this.modelName = null;
    this.#changed();
  }

  #changed() {
    this.dispatchEvent(new Event("change"));
  }
}
