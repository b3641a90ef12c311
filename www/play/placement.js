// The ball being placed, as it is moved by pointer, keys and numbers: rounded, kept inside the scene, undone and
// redone. Fires "change". Knows nothing of the document.

import { FIRST_RADIUS, MAX_RADIUS, MIN_RADIUS, SCENE_SIZE } from "../shell/constants.js";
import { UndoStack } from "./undo-stack.js";

/** @typedef {import("../pkg/pathlight.js").Ball} Ball */

const MIDDLE = SCENE_SIZE / 2;

export class Placement extends EventTarget {
  /** @type {Ball | null} */
  ball = null;
  /**
   * Why the ball may not be placed, or null.
   * @type {import("../pkg/pathlight.js").InvalidBall | null}
   */
  invalidReason = null;
  #game;
  /** @type {UndoStack<Ball | null>} */
  #balls = new UndoStack(/** @type {Ball | null} */ (null));

  /** @param {Pick<import("../pkg/pathlight.js").Game, "whyInvalid" | "nearestPlace">} game */
  constructor(game) {
    super();
    this.#game = game;
  }

  /**
   * Places the ball, in px; it is rounded and kept inside the scene. Placements of one `gesture` (a drag, say) are
   * undone together.
   * @param {Ball} ball
   * @param {unknown} [gesture]
   */
  place([x, y, r], gesture = null) {
    /** @type {(value: number, low: number, high: number) => number} */
    const clamped = (value, low, high) => Math.min(Math.max(Math.round(value), low), high);
    /** @type {Ball} */
    const ball = [clamped(x, 0, SCENE_SIZE - 1), clamped(y, 0, SCENE_SIZE - 1), clamped(r, MIN_RADIUS, MAX_RADIUS)];
    this.#balls.push(ball, gesture);
    this.#set(ball);
  }

  /**
   * Places the ball, or takes it away.
   * @param {Ball | null} ball
   */
  replace(ball) {
    if (ball) return this.place(ball);
    this.#balls.push(null);
    this.#set(null);
  }

  /**
   * Moves the ball and changes its radius, each by some px; a first ball appears in the middle.
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

  /**
   * Takes the ball of an attempt, which may be placed. Fires nothing.
   * @param {Ball} ball
   */
  take(ball) {
    this.#balls.push(ball);
    this.ball = ball;
    this.invalidReason = null;
  }

  /**
   * Moves a ball that may not lie where it is to the nearest place where it may, if that is not far away.
   * @param {unknown} gesture the one that has left it there
   */
  settle(gesture) {
    const place = this.ball && this.invalidReason !== null ? this.#game.nearestPlace(...this.ball) : null;
    if (place) this.place(place, gesture);
  }

  get canUndo() {
    return this.#balls.canUndo;
  }

  get canRedo() {
    return this.#balls.canRedo;
  }

  undo() {
    if (this.canUndo) this.#set(this.#balls.undo());
  }

  redo() {
    if (this.canRedo) this.#set(this.#balls.redo());
  }

  /** @param {Ball | null} ball */
  #set(ball) {
    this.ball = ball;
    this.invalidReason = (ball && this.#game.whyInvalid(...ball)) ?? null;
    this.dispatchEvent(new Event("change"));
  }
}
