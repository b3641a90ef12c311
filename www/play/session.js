// One puzzle being played: the ball being placed (placement.js), the attempts of player and model (attempts.js), and
// the rollout being shown. Wraps the wasm's Puzzle and the clock; the components ask it to do things and listen:
// "change"     something to read has changed "draw"       only the picture has changed "attempted"  a new attempt of
// the player's has run to its end, or was left; `shown` holds it Knows nothing of the document. It is over 300 lines
// long for its JSDoc: one state machine, and the page's only way to the Puzzle.

import { Puzzle } from "../pkg/pathlight.js";
import { GOAL_SECONDS } from "../shell/constants.js";
import { sentence } from "../shell/sentence.js";
import { Attempts } from "./attempts.js";
import { Placement } from "./placement.js";
import { Playback } from "./playback.js";

/** @typedef {import("../pkg/pathlight.js").Ball} Ball */
/** @typedef {import("../pkg/pathlight.js").Contender} Contender */
/** @typedef {import("../pkg/pathlight.js").Attempt} Attempt */
/** @typedef {import("../pkg/pathlight.js").ListedAttempt} ListedAttempt */

/**
 * An attempt that is shown. `preview`: it is a proposal of the model's that is only looked at, and `tried` says whether
 * the model has tried it too; or, if `opened`, somebody's attempt from a file.
 * @typedef {ListedAttempt & { contender: Contender, preview?: boolean, tried?: boolean, opened?: boolean }}
 *   ShownAttempt
 */

/**
 * What stays in sight of a miss: its ball, and the path of the green object as in `ImaginedBall`.
 * @typedef {{ ball: Ball, object: Float32Array }} Ghost
 */

/** Codes of errors that refuse a ball; any other error is a defect. */
const REFUSALS = ["invalid_ball", "attempt_limit"];

export class Session extends EventTarget {
  /** What the worker's calls are about. */
  played;
  /** The wasm's Puzzle; freed by `close`. */
  puzzle;
  about;
  placement;
  attempts;
  playback = new Playback();
  /** @type {"placing" | "attempt" | "watch" | "compare"} */
  phase = "placing";
  /**
   * Only while phase is "attempt".
   * @type {ShownAttempt | null}
   */
  shown = null;
  /** True while a new attempt of the player's plays for the first time; its result stays hidden until then. */
  resultHidden = false;
  /**
   * The one or two attempts over each other, the player's first; only while phase is "compare".
   * @type {ShownAttempt[]}
   */
  pair = [];
  /**
   * Why the last request was refused, or null.
   * @type {string | null}
   */
  refusal = null;
  /** True once the shown rollout has played to its end. */
  finished = false;
  /**
   * When the shown attempt came nearest to its goal; only once it has ended as a miss that never touched.
   * @type {import("../pkg/pathlight.js").ClosestApproach | null}
   */
  approach = null;
  /**
   * The model's misses that are shown faintly while it plays its turn.
   * @type {Ghost[]}
   */
  ghosts = [];
  /** Is a miss of the model's turn shown? */
  ghosting = false;
  /** Changes whenever something else is shown or the ball is placed elsewhere. */
  revision = 0;
  /**
   * Makes the scene that is being bent the puzzle, and answers with its session, or with null if nothing may run; null
   * if the scene that is seen is this one.
   * @type {(() => Promise<Session | null>) | null}
   */
  settle = null;
  #drawing = false;
  #bending = false;
  #prefersReducedMotion;

  /**
   * @param {import("../pkg/pathlight.js").Played} played
   * @param {() => boolean} prefersReducedMotion asked before each run; if so, it goes straight to its end
   */
  constructor(played, prefersReducedMotion) {
    super();
    this.played = played;
    this.puzzle = new Puzzle(played);
    this.about = this.puzzle.about();
    this.placement = new Placement((ball) => this.puzzle.whyInvalid(...ball));
    this.attempts = new Attempts(this.puzzle);
    this.#prefersReducedMotion = prefersReducedMotion;
    this.placement.addEventListener("change", () => this.#onPlaced());
    this.playback.addEventListener("tick", () => this.#onTick());
  }

  /** What has to be reached, and for how long. */
  get goal() {
    return this.about.goal.replace(/\.$/, ` for ${GOAL_SECONDS} seconds.`);
  }

  get reducedMotion() {
    return this.#prefersReducedMotion();
  }

  get placing() {
    return this.phase === "placing";
  }

  /** The ball being placed, or null. */
  get ball() {
    return this.placement.ball;
  }

  /** Why that ball may not be placed, or null. */
  get invalidReason() {
    return this.placement.invalidReason;
  }

  #onPlaced() {
    this.refusal = null;
    this.revision += 1;
    if (this.placing) this.#emit("change");
    else this.reset();
  }

  /** What the run button does: runs the ball, pauses, or plays on. */
  run() {
    if (this.settle) {
      this.settle().then((session) => session?.run());
    } else if (!this.placing) {
      if (this.playback.playing) this.playback.pause();
      else this.playback.play();
      this.#emit("change");
    } else if (this.ball) {
      this.#attempt(this.ball);
    } else {
      this.refuse("Place the ball first: click or tap in the scene, or press an arrow key there.");
    }
  }

  /** @param {Ball} ball */
  #attempt(ball) {
    try {
      const before = this.attempts.standing("player").used;
      const attempt = this.puzzle.attempt(...ball);
      this.#show("attempt", { shown: { contender: "player", ...attempt }, resultHidden: attempt.number > before });
    } catch (caught) {
      const error = /** @type {import("../pkg/pathlight.js").CodedError} */ (caught);
      if (!REFUSALS.includes(error.code)) throw error;
      this.refuse(`${sentence(error.message)} That does not count as an attempt.`);
    }
  }

  /** Shows the scene without a ball. */
  watch() {
    if (this.settle) {
      this.settle().then((session) => session?.watch());
    } else {
      this.puzzle.watch();
      this.#show("watch");
    }
  }

  /**
   * Shows an attempt again; it does not count once more.
   * @param {Contender} contender
   * @param {number} number
   */
  replay(contender, number) {
    const attempt = this.puzzle.replay(contender, number);
    if (contender === "player") this.placement.take(attempt.ball);
    this.#show("attempt", { shown: { contender, ...attempt } });
  }

  /**
   * Shows an attempt of the model's within `duration` ms, and the ghosts of those before it. Returns whether it played
   * to its end; it does not if something else is shown meanwhile.
   * @param {number} number
   * @param {number} duration
   * @param {Ghost[]} ghosts
   */
  async flash(number, duration, ghosts) {
    const shown = { contender: /** @type {const} */ ("model"), ...this.puzzle.replay("model", number) };
    this.#show("attempt", { shown, ghosts, duration, ghosting: true });
    const { promise, resolve } = Promise.withResolvers();
    const check = () => (this.shown !== shown || this.finished) && resolve(null);
    this.addEventListener("change", check);
    check();
    await promise;
    this.removeEventListener("change", check);
    return this.shown === shown;
  }

  /** What stays in sight of the attempt that is shown. */
  get ghost() {
    const paths = this.puzzle.sampledPaths();
    return this.shown && paths ? { ball: this.shown.ball, object: paths.object } : null;
  }

  /** Has everything come to rest before the time of an attempt is over? Only once it has ended. */
  get still() {
    return (
      this.finished && this.shown !== null && !this.shown.ending.solved && this.playback.last < this.shown.ending.steps
    );
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
    const attempt = this.puzzle.preview(...ball);
    this.#show("attempt", { shown: { ...attempt, contender: "model", number, tried, preview: true }, play });
  }

  /**
   * Plays somebody's attempt from a file; it does not count, and the ball being placed stays.
   * @param {Ball} ball
   */
  playOpened(ball) {
    this.#show("attempt", {
      shown: { ...this.puzzle.preview(...ball), contender: "model", preview: true, opened: true },
    });
  }

  /** Is the scene drawn on, instead of a ball placed in it? */
  get drawing() {
    return this.#drawing;
  }

  set drawing(drawing) {
    if (drawing === this.#drawing) return;
    this.#drawing = drawing;
    this.#emit("change");
  }

  /** Is the scene being bent, instead of a ball placed in it? */
  get bending() {
    return this.#bending;
  }

  set bending(bending) {
    if (bending === this.#bending) return;
    this.#bending = bending;
    this.#emit("change");
  }

  /**
   * Shows the best attempts of both over each other: played from the start, or at their end.
   * @param {boolean} play
   */
  compare(play) {
    const [player, model] = this.puzzle.compare();
    /** @type {ShownAttempt[]} */
    const pair = [];
    if (player) pair.push({ contender: "player", ...player });
    if (model) pair.push({ contender: "model", ...model });
    if (pair.length === 0) this.reset();
    else this.#show("compare", { pair, play });
  }

  /**
   * Shows an attempt over another: over the one that is shown, else over the other contender's last, else its
   * neighbour.
   * @param {Contender} contender
   * @param {number} number
   */
  overlay(contender, number) {
    const chosen = { contender, number };
    const other = this.#overlayPartner(chosen);
    if (!other) return this.replay(contender, number);
    const [first, second] = contender === "model" && other.contender === "player" ? [other, chosen] : [chosen, other];
    const attempts = this.puzzle.overlay(first.contender, first.number, second.contender, second.number);
    this.#show("compare", {
      pair: attempts.map((attempt, index) => ({ contender: [first, second][index].contender, ...attempt })),
    });
  }

  /**
   * @param {{ contender: Contender, number: number }} chosen
   * @returns {{ contender: Contender, number: number } | null}
   */
  #overlayPartner({ contender, number }) {
    const [only, ...others] = this.visibleAttempts;
    if (only && others.length === 0 && (only.contender !== contender || only.number !== number)) return only;
    const opponent = contender === "player" ? "model" : "player";
    const { used } = this.attempts.standing(opponent);
    if (used > 0) return { contender: opponent, number: used };
    const neighbour = number > 1 ? number - 1 : 2;
    return neighbour <= this.attempts.standing(contender).used ? { contender, number: neighbour } : null;
  }

  /** The attempts that are being shown. */
  get visibleAttempts() {
    if (this.phase === "compare") return this.pair;
    return this.shown && !this.shown.preview ? [this.shown] : [];
  }

  /**
   * Deletes an attempt; those after it move up by one.
   * @param {Contender} contender
   * @param {number} number
   */
  remove(contender, number) {
    this.revealResult();
    this.attempts.remove(contender, number);
    // The shown attempt may be the deleted one, or have another number now.
    if (this.placing) this.#emit("change");
    else this.reset();
  }

  /** Returns to placing, with the ball where it was. */
  reset() {
    this.revealResult();
    this.puzzle.reset();
    this.revision += 1;
    this.phase = "placing";
    this.shown = null;
    this.pair = [];
    this.approach = null;
    this.ghosts = [];
    this.ghosting = false;
    this.playback.load(0);
    this.#emit("change");
  }

  /**
   * Steps forward or back; while placing, it first runs the ball.
   * @param {number} by
   */
  step(by) {
    if (this.settle) {
      this.settle().then((session) => session?.step(by));
      return;
    }
    if (this.placing) {
      this.run();
      if (this.placing) return;
      this.playback.seek(0);
    }
    this.playback.seek(Math.floor(this.playback.step) + by);
    this.#emit("change");
  }

  /** @param {number} step */
  seek(step) {
    this.playback.seek(step);
    this.#emit("change");
  }

  /**
   * Makes attempts of the player's again that were made before; nothing of them is shown.
   * @param {Ball[]} balls
   */
  restore(balls) {
    if (balls.length === 0) return;
    this.attempts.restore(balls);
    this.#emit("change");
  }

  /**
   * Adds attempts that a model has made before.
   * @param {Attempt[]} attempts
   * @param {string} modelName
   */
  restoreModel(attempts, modelName) {
    if (attempts.length === 0) return;
    this.attempts.restoreModel(attempts, modelName);
    this.#emit("change");
  }

  /**
   * Adds an attempt that the worker has simulated for a model. Returns its number.
   * @param {Attempt} attempt
   * @param {string} modelName
   */
  recordModelAttempt(attempt, modelName) {
    const number = this.attempts.add(attempt, modelName);
    this.#emit("change");
    return number;
  }

  /** Forgets the model's attempts, and stops showing them. */
  clearModelAttempts() {
    const visible = this.shown?.contender === "model" || this.pair.some(({ contender }) => contender === "model");
    this.attempts.clear("model");
    if (visible) this.reset();
    else this.#emit("change");
  }

  /** Forgets the attempts of both. */
  clearAllAttempts() {
    this.attempts.clear("player");
    this.attempts.clear("model");
    this.reset();
  }

  /** The player's new attempt has run to its end, or the player has left it: its result may be shown. */
  revealResult() {
    if (!this.resultHidden) return;
    this.resultHidden = false;
    this.#emit("attempted");
  }

  /**
   * Stops the clock and frees the wasm's memory. `revealResult` comes before. The session must not be used afterwards.
   */
  close() {
    this.playback.stop();
    this.puzzle.free();
  }

  /**
   * Shows the rollouts that the puzzle has been told to show.
   * @param {"attempt" | "watch" | "compare"} phase
   * @param {{ shown?: ShownAttempt | null, pair?: ShownAttempt[], play?: boolean, resultHidden?: boolean, ghosts?:
   *   Ghost[], ghosting?: boolean, duration?: number }} [what]
   */
  #show(
    phase,
    { shown = null, pair = [], play = true, resultHidden = false, ghosts = [], ghosting = false, duration } = {},
  ) {
    this.revealResult();
    this.revision += 1;
    Object.assign(this, {
      phase,
      shown,
      pair,
      resultHidden,
      ghosts,
      ghosting,
      approach: null,
      refusal: null,
      finished: false,
    });
    const last = this.puzzle.steps();
    const atEnd = !play || this.#prefersReducedMotion();
    this.playback.load(last, atEnd ? last : 0);
    if (!atEnd) this.playback.play(duration);
    this.#emit("change");
  }

  #onTick() {
    const { playing, ended } = this.playback;
    if (!this.placing && ended && !playing && !this.finished) {
      this.finished = true;
      const { ending } = this.shown ?? {};
      if (ending && !ending.solved && ending.longest_touch === 0 && !this.ghosting)
        this.approach = this.puzzle.closestApproach() ?? null;
      this.revealResult();
      this.#emit("change");
    }
    this.#emit("draw");
  }

  /**
   * Says why what was asked for does not happen; null takes that back.
   * @param {string | null} words
   */
  refuse(words) {
    this.refusal = words;
    this.#emit("change");
  }

  /** @param {"change" | "draw" | "attempted"} event */
  #emit(event) {
    this.dispatchEvent(new Event(event));
  }
}
