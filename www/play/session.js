// One puzzle being played: the ball being placed, the rollout being shown, the attempts of player and model. Wraps the
// wasm's Puzzle and the clock; the components ask it to do things and listen:
//   "change"     something to read has changed
//   "draw"       only the picture has changed
//   "attempted"  a new attempt of the player's has run to its end, or was left; `shown` holds it
// Knows nothing of the document. It is over 300 lines long for its JSDoc: one state machine, and the page's only way to
// the Puzzle.

import { Puzzle } from "../pkg/pathlight.js";
import { FIRST_RADIUS, MAX_RADIUS, MIN_RADIUS, SCENE_SIZE } from "../shell/constants.js";
import { Playback } from "./playback.js";
import { UndoStack } from "./undo-stack.js";

/** @typedef {import("../pkg/pathlight.js").Ball} Ball */
/** @typedef {import("../pkg/pathlight.js").Contender} Contender */
/** @typedef {import("../pkg/pathlight.js").Attempt} Attempt */
/** @typedef {import("../pkg/pathlight.js").ListedAttempt} ListedAttempt */

/**
 * An attempt that is shown. `preview`: it is a proposal of the model's that is only looked at, and `tried` says whether the
 * model has tried it too; or, if `opened`, somebody's attempt from a file.
 * @typedef {ListedAttempt & { contender: Contender, preview?: boolean, tried?: boolean, opened?: boolean }} ShownAttempt
 */

/**
 * What stays in sight of a miss: its ball, and the path of the green object as in `ImaginedBall`.
 * @typedef {{ ball: Ball, object: Float32Array }} Ghost
 */

/** Codes of errors that refuse a ball; any other error is a defect. */
const REFUSALS = ["invalid_ball", "attempt_limit"];
const MIDDLE = SCENE_SIZE / 2;

export class Session extends EventTarget {
  /** What the worker's calls are about. */
  played;
  /** The wasm's Puzzle; freed by `close`. */
  puzzle;
  about;
  playback = new Playback();
  /** @type {Ball | null} */
  ball = null;
  /**
   * Why the ball may not be placed, or null.
   * @type {string | null}
   */
  invalidReason = null;
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
  /**
   * The name of the model that made the model's attempts, or null while there are none.
   * @type {string | null}
   */
  modelName = null;
  #drawing = false;
  #bending = false;
  #prefersReducedMotion;
  /** @type {UndoStack<Ball | null>} */
  #placements = new UndoStack(/** @type {Ball | null} */ (null));

  /**
   * @param {import("../model/messages.js").Played} played
   * @param {() => boolean} prefersReducedMotion asked before each run; if so, it goes straight to its end
   */
  constructor(played, prefersReducedMotion) {
    super();
    this.played = played;
    this.puzzle = new Puzzle(played);
    this.about = this.puzzle.about();
    this.#prefersReducedMotion = prefersReducedMotion;
    this.playback.addEventListener("tick", () => this.#onTick());
  }

  get reducedMotion() {
    return this.#prefersReducedMotion();
  }

  get placing() {
    return this.phase === "placing";
  }

  /**
   * Places the ball, in px; it is rounded and kept inside the scene. Placements of one `gesture` (a drag, say) are undone
   * together.
   * @param {Ball} ball
   * @param {unknown} [gesture]
   */
  place([x, y, r], gesture = null) {
    /** @type {(value: number, low: number, high: number) => number} */
    const clamped = (value, low, high) => Math.min(Math.max(Math.round(value), low), high);
    /** @type {Ball} */
    const ball = [clamped(x, 0, SCENE_SIZE - 1), clamped(y, 0, SCENE_SIZE - 1), clamped(r, MIN_RADIUS, MAX_RADIUS)];
    this.#placements.push(ball, gesture);
    this.#setBall(ball);
  }

  /**
   * Places the ball, or takes it away.
   * @param {Ball | null} ball
   */
  replaceBall(ball) {
    if (ball) return this.place(ball);
    this.#placements.push(null);
    this.#setBall(null);
  }

  /**
   * Moves the ball and changes its radius by so many px; a first ball appears in the middle.
   * @param {number} dx
   * @param {number} dy
   * @param {number} dr
   * @param {unknown} [gesture]
   */
  nudge(dx, dy, dr, gesture = null) {
    const [x, y, r] = this.ball ?? [MIDDLE - dx, MIDDLE - dy, FIRST_RADIUS - dr];
    this.place([x + dx, y + dy, r + dr], gesture);
  }

  /**
   * Changes the radius; a first ball appears in the middle.
   * @param {number} r
   * @param {unknown} [gesture]
   */
  resize(r, gesture = null) {
    const [x, y] = this.ball ?? [MIDDLE, MIDDLE];
    this.place([x, y, r], gesture);
  }

  get canUndo() {
    return this.#placements.canUndo;
  }

  get canRedo() {
    return this.#placements.canRedo;
  }

  undo() {
    if (this.canUndo) this.#setBall(this.#placements.undo());
  }

  redo() {
    if (this.canRedo) this.#setBall(this.#placements.redo());
  }

  /** @param {Ball | null} ball */
  #setBall(ball) {
    this.ball = ball;
    this.invalidReason = (ball && this.puzzle.whyInvalid(...ball)) ?? null;
    this.refusal = null;
    if (this.placing) this.#emit("change");
    else this.reset();
  }

  /** What the run button does: runs the ball, pauses, or plays on. */
  run() {
    if (!this.placing) {
      if (this.playback.playing) this.playback.pause();
      else this.playback.play();
      this.#emit("change");
    } else if (this.ball) {
      this.#attempt(this.ball);
    } else {
      this.#refuse("Place the ball first: click or tap in the scene, or press an arrow key there.");
    }
  }

  /** @param {Ball} ball */
  #attempt(ball) {
    try {
      const before = this.standing("player").used;
      const attempt = this.puzzle.attempt(...ball);
      this.#show("attempt", { shown: { contender: "player", ...attempt }, resultHidden: attempt.number > before });
    } catch (caught) {
      const error = /** @type {import("../pkg/pathlight.js").CodedError} */ (caught);
      if (!REFUSALS.includes(error.code)) throw error;
      this.#refuse(`${sentence(error.message)} That does not count as an attempt.`);
    }
  }

  /** Shows the scene without a ball. */
  watch() {
    this.puzzle.watch();
    this.#show("watch");
  }

  /**
   * Shows an attempt again; it does not count once more.
   * @param {Contender} contender
   * @param {number} number
   */
  replay(contender, number) {
    const attempt = this.puzzle.replay(contender, number);
    if (contender === "player") {
      this.ball = attempt.ball;
      this.invalidReason = null;
      this.#placements.push(attempt.ball);
    }
    this.#show("attempt", { shown: { contender, ...attempt } });
  }

  /**
   * Shows an attempt of the model's within `duration` ms, and the ghosts of those before it. Returns whether it played to its
   * end; it does not if something else is shown meanwhile.
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
    return this.finished && this.shown !== null && !this.shown.ending.solved && this.playback.last < this.shown.ending.steps;
  }

  /**
   * Shows how a proposal of the model's does, at its end or played from the start; it does not count. `tried`: has it been
   * an attempt?
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
    this.#show("attempt", { shown: { ...this.puzzle.preview(...ball), contender: "model", preview: true, opened: true } });
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
   * Shows an attempt over another: over the one that is shown, else over the other contender's last, else its neighbour.
   * @param {Contender} contender
   * @param {number} number
   */
  overlay(contender, number) {
    const chosen = { contender, number };
    const other = this.#overlayPartner(chosen);
    if (!other) return this.replay(contender, number);
    const [first, second] = contender === "model" && other.contender === "player" ? [other, chosen] : [chosen, other];
    const attempts = this.puzzle.overlay(first.contender, first.number, second.contender, second.number);
    this.#show("compare", { pair: attempts.map((attempt, index) => ({ contender: [first, second][index].contender, ...attempt })) });
  }

  /**
   * @param {{ contender: Contender, number: number }} chosen
   * @returns {{ contender: Contender, number: number } | null}
   */
  #overlayPartner({ contender, number }) {
    const [only, ...others] = this.visibleAttempts;
    if (only && others.length === 0 && (only.contender !== contender || only.number !== number)) return only;
    const opponent = contender === "player" ? "model" : "player";
    const { used } = this.standing(opponent);
    if (used > 0) return { contender: opponent, number: used };
    const neighbour = number > 1 ? number - 1 : 2;
    return neighbour <= this.standing(contender).used ? { contender, number: neighbour } : null;
  }

  /** The attempts that are being shown. */
  get visibleAttempts() {
    if (this.phase === "compare") return this.pair;
    return this.shown && !this.shown.preview ? [this.shown] : [];
  }

  /** @param {Contender} contender */
  standing(contender) {
    return this.puzzle.standing(contender);
  }

  /** @param {Contender} contender */
  attempts(contender) {
    return this.puzzle.attempts(contender);
  }

  /**
   * Deletes an attempt; those after it move up by one.
   * @param {Contender} contender
   * @param {number} number
   */
  remove(contender, number) {
    this.revealResult();
    this.puzzle.remove(contender, number);
    // The shown attempt may be the deleted one, or have another number now.
    if (this.placing) this.#emit("change");
    else this.reset();
  }

  /** Returns to placing, with the ball where it was. */
  reset() {
    this.revealResult();
    this.puzzle.reset();
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
    for (const ball of balls) {
      // A ball of another version may not fit any more.
      if (this.puzzle.whyInvalid(...ball) === undefined) this.puzzle.attempt(...ball);
    }
    this.puzzle.reset();
    this.#emit("change");
  }

  /**
   * Adds attempts that a model has made before.
   * @param {Attempt[]} attempts
   * @param {string} modelName
   */
  restoreModel(attempts, modelName) {
    if (attempts.length === 0) return;
    for (const attempt of attempts) {
      if (this.puzzle.whyInvalid(...attempt.ball) === undefined) this.puzzle.addModelAttempt(attempt);
    }
    this.modelName = modelName;
    this.#emit("change");
  }

  /**
   * Adds an attempt that the worker has simulated for a model; one with the same ball is not added again. Returns its number.
   * @param {Attempt} attempt
   * @param {string} modelName
   */
  recordModelAttempt(attempt, modelName) {
    const { number } = this.puzzle.addModelAttempt(attempt);
    this.modelName = modelName;
    this.#emit("change");
    return number;
  }

  /** Forgets the model's attempts, and stops showing them. */
  clearModelAttempts() {
    const visible = this.shown?.contender === "model" || this.pair.some(({ contender }) => contender === "model");
    this.puzzle.clear("model");
    this.modelName = null;
    if (visible) this.reset();
    else this.#emit("change");
  }

  /** Forgets the attempts of both. */
  clearAllAttempts() {
    this.puzzle.clear("player");
    this.puzzle.clear("model");
    this.modelName = null;
    this.reset();
  }

  /** The player's new attempt has run to its end, or the player has left it: its result may be shown. */
  revealResult() {
    if (!this.resultHidden) return;
    this.resultHidden = false;
    this.#emit("attempted");
  }

  /** Stops the clock and frees the wasm's memory. `revealResult` comes before. The session must not be used afterwards. */
  close() {
    this.playback.stop();
    this.puzzle.free();
  }

  /**
   * Shows the rollouts that the puzzle has been told to show.
   * @param {"attempt" | "watch" | "compare"} phase
   * @param {{ shown?: ShownAttempt | null, pair?: ShownAttempt[], play?: boolean, resultHidden?: boolean, ghosts?: Ghost[], ghosting?: boolean, duration?: number }} [what]
   */
  #show(phase, { shown = null, pair = [], play = true, resultHidden = false, ghosts = [], ghosting = false, duration } = {}) {
    this.revealResult();
    Object.assign(this, { phase, shown, pair, resultHidden, ghosts, ghosting, approach: null, refusal: null, finished: false });
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
      if (ending && !ending.solved && ending.longest_touch === 0 && !this.ghosting) this.approach = this.puzzle.closestApproach() ?? null;
      this.revealResult();
      this.#emit("change");
    }
    this.#emit("draw");
  }

  /** @param {string} words */
  #refuse(words) {
    this.refusal = words;
    this.#emit("change");
  }

  /** @param {"change" | "draw" | "attempted"} event */
  #emit(event) {
    this.dispatchEvent(new Event(event));
  }
}

/**
 * Words as a sentence: "the ball …" becomes "The ball ….".
 * @param {string} words
 */
export function sentence(words) {
  return words[0].toUpperCase() + words.slice(1) + (/[.!?]$/.test(words) ? "" : ".");
}
