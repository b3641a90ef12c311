// One puzzle being played: the ball being placed (placement.js), the attempts of player and model (attempts.js), and
// what is shown (display.js). The components ask it to do things and listen:
//
//   change      something to read has changed
//   draw        only the picture has changed
//   attempted   a new attempt of the player's has run to its end, or was left; `shown` holds it
//   wanted      what was asked for has to wait until the edited scene is the puzzle: a CustomEvent whose detail
//               is to be called with the session of that scene
//
// Knows nothing of the document. The page's only way to the Game.

import { Game } from "../pkg/pathlight.js";
import { ATTEMPT_LIMIT, GOAL_SECONDS } from "../shell/constants.js";
import { sceneName } from "../puzzles/puzzle-name.js";
import { templateOf } from "../puzzles/templates.js";
import { text } from "../text/text.js";
import { Attempts } from "./attempts.js";
import { Display } from "./display.js";
import { invalidWords } from "./invalid-words.js";
import { Placement } from "./placement.js";
import { attemptRun, overlaid } from "./shown.js";

/** @typedef {import("../pkg/pathlight.js").Ball} Ball */
/** @typedef {import("../pkg/pathlight.js").Author} Author */
/** @typedef {import("../pkg/pathlight.js").Attempt} Attempt */
/** @typedef {import("../pkg/pathlight.js").ListedAttempt} ListedAttempt */
/** @typedef {import("./shown.js").ShownAttempt} ShownAttempt */
/** @typedef {import("./shown.js").Ghost} Ghost */

export class Session extends Display {
  /** What the worker's calls are about. */
  puzzle;
  about;
  placement;
  attempts;
  /** Has the player drawn a prediction? */
  sketched = false;

  /**
   * @param {import("../pkg/pathlight.js").Puzzle} puzzle
   * @param {() => boolean} prefersReducedMotion asked before each run; if so, it goes straight to its end
   */
  constructor(puzzle, prefersReducedMotion) {
    super(new Game(puzzle), prefersReducedMotion);
    this.puzzle = puzzle;
    this.about = this.game.about();
    this.placement = new Placement(this.game);
    this.attempts = new Attempts(this.game);
    this.placement.addEventListener("change", () => this.#onPlaced());
    this.attempts.addEventListener("change", () => this.emit("change"));
  }

  /** What has to be reached, and for how long. */
  get goal() {
    const { bodies, body1, body2 } = this.about.scene;
    return text.puzzles.goal(bodies[body1], bodies[body2], GOAL_SECONDS);
  }

  /** What the puzzle is called. */
  get name() {
    return (this.about.id && templateOf(this.about.id)?.name) ?? sceneName(this.about);
  }

  /** What happens in the puzzle. */
  get story() {
    return (this.about.id && templateOf(this.about.id)?.story) ?? text.puzzles.customStory;
  }

  /** The scene for people who cannot see it: every body with its position, object and goal first. */
  get description() {
    const { bodies, body1, body2 } = this.about.scene;
    const others = bodies.filter((_, index) => index !== body1 && index !== body2);
    return text.puzzles.description(bodies[body1], bodies[body2], others);
  }

  /** The ball being placed, or null. */
  get ball() {
    return this.placement.ball;
  }

  /** Why that ball may not be placed, or null. */
  get invalidReason() {
    return this.placement.invalidReason;
  }

  /** What the run button does: runs the ball, pauses, or plays on. */
  run() {
    if (this.#waitsForEditor((session) => session.run())) return;
    if (!this.placing) {
      if (this.playback.playing) this.playback.pause();
      else this.playback.play();
      this.emit("change");
    } else if (this.ball) {
      this.#attempt(this.ball);
    } else if (this.state.tool === "line" && this.sketched) {
      // A prediction needs no ball.
      this.watch();
    } else if (this.state.tool === "line") {
      this.refuse(text.play.refusal.noPrediction);
    } else {
      this.refuse(text.play.refusal.noBall);
    }
  }

  /** @param {Ball} ball */
  #attempt(ball) {
    if (this.invalidReason)
      return this.refuse(text.play.refusal.invalid(invalidWords(this.invalidReason, this.about.scene)));
    try {
      const before = this.attempts.standing("player").used;
      const attempt = this.game.attempt(...ball);
      this.show(attemptRun({ author: "player", ...attempt }, { hidden: attempt.number > before ? "player" : null }));
    } catch (caught) {
      const error = /** @type {import("../pkg/pathlight.js").CodedError} */ (caught);
      // Any other error is a defect.
      if (error.code !== "attempt_limit") throw error;
      this.refuse(text.play.refusal.limit(ATTEMPT_LIMIT));
    }
  }

  /** Shows the scene without a ball. */
  watch() {
    if (this.#waitsForEditor((session) => session.watch())) return;
    this.game.watch();
    this.show({ kind: "watch" });
  }

  /**
   * Steps forward or back; while placing, it first runs the ball.
   * @param {number} by
   */
  step(by) {
    if (this.#waitsForEditor((session) => session.step(by))) return;
    if (this.placing) {
      this.run();
      if (this.placing) return;
      this.playback.seek(0);
    }
    this.seek(Math.floor(this.playback.step) + by);
  }

  /**
   * Shows an attempt again; it does not count once more.
   * @param {Author} author
   * @param {number} number
   * @param {boolean} [fresh] is it new, so that its result is not told before its end?
   */
  replay(author, number, fresh = false) {
    const attempt = this.game.replay(author, number);
    if (author === "player") this.placement.take(attempt.ball);
    this.show(attemptRun({ author, ...attempt }, { hidden: fresh ? author : null }));
  }

  /**
   * Shows a miss of the model's turn within `duration` ms, and those before it as ghosts.
   * @param {number} number
   * @param {number} duration
   * @param {Ghost[]} ghosts
   */
  flash(number, duration, ghosts) {
    const attempt = this.game.replay("model", number);
    this.show(attemptRun({ author: "model", ...attempt }, { ghosts }), { duration });
  }

  /**
   * Shows how a proposal of the model's does, at its end or played from the start; it does not count. `tried`: has it
   * been an attempt?
   * @param {number} number
   * @param {Ball} ball
   * @param {boolean} tried
   * @param {boolean} [play]
   */
  preview(number, ball, tried, play = false) {
    const attempt = this.game.preview(...ball);
    this.show(attemptRun({ ...attempt, author: "model", number, tried, preview: true }), { play });
  }

  /**
   * Plays somebody's attempt from a file; it does not count, and the ball being placed stays.
   * @param {Ball} ball
   */
  playOpened(ball) {
    const attempt = this.game.preview(...ball);
    this.show(attemptRun({ ...attempt, author: "model", preview: true, opened: true }));
  }

  /**
   * Shows the best attempts of both over each other: played from the start, or at their end.
   * @param {boolean} play
   * @param {boolean} [fresh] is the model's new, so that its result is not told before its end?
   */
  compare(play, fresh = false) {
    const [player, model] = this.game.compare();
    /** @type {ShownAttempt[]} */
    const pair = [];
    if (player) pair.push({ author: "player", ...player });
    if (model) pair.push({ author: "model", ...model });
    if (pair.length === 0) this.reset();
    else this.show({ kind: "compare", pair, hidden: fresh ? "model" : null }, { play });
  }

  /**
   * Shows an attempt over another; see `overlaid`.
   * @param {Author} author
   * @param {number} number
   */
  overlay(author, number) {
    const used = { player: this.attempts.standing("player").used, model: this.attempts.standing("model").used };
    const [first, second] = overlaid({ author, number }, this.state, used);
    if (!second) return this.replay(author, number);
    const [below, above] = this.game.overlay(first.author, first.number, second.author, second.number);
    const pair = [
      { author: first.author, ...below },
      { author: second.author, ...above },
    ];
    this.show({ kind: "compare", pair, hidden: null });
  }

  /**
   * Deletes an attempt; those after it move up by one.
   * @param {Author} author
   * @param {number} number
   */
  remove(author, number) {
    this.revealResult();
    this.attempts.remove(author, number);
    // The shown attempt may be the deleted one, or have another number now.
    if (!this.placing) this.reset();
  }

  /** Forgets the model's attempts, and stops showing them. */
  clearModelAttempts() {
    const state = this.state;
    const attempts = state.kind === "compare" ? state.pair : [this.shown];
    this.attempts.clear("model");
    if (attempts.some((attempt) => attempt?.author === "model")) this.reset();
  }

  /** Forgets the attempts of both. */
  clearAllAttempts() {
    this.revealResult();
    this.attempts.clear("player");
    this.attempts.clear("model");
    this.reset();
  }

  /**
   * Returns whether the scene that is seen is being edited, and not this puzzle; whoever edits it is then asked to act.
   * @param {(session: Session) => void} act
   */
  #waitsForEditor(act) {
    const { edited } = this.state;
    if (edited) this.dispatchEvent(new CustomEvent("wanted", { detail: act }));
    return edited;
  }

  #onPlaced() {
    this.revision += 1;
    if (!this.placing) return this.reset();
    this.refuse(null);
  }
}
