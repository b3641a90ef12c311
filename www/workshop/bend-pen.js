// The pointer and the keys of a scene that is being bent: dragging a body moves it, its knobs resize and turn it. Turns
// gestures into calls of the draft; decides nothing about the scene.

import { ARROW_KEYS } from "../play/gestures.js";
import { SCENE_SIZE } from "../shell/constants.js";
import { SIZES, bodyAt, directionTo, distanceTo, knobsOf, sizeOf, sizeTo } from "./body-geometry.js";
import { degreesOf } from "./body-words.js";

/** @typedef {import("../play/canvas.js").Point} Point */
/** @typedef {import("../play/gestures.js").Pen} Pen */

/**
 * What the pointer does between down and up. Moving keeps the offset of the body's origin from the pointer; turning the
 * one of the body's angle from the pointer's direction, degrees.
 * @typedef {{ kind: "move", dx: number, dy: number } | { kind: "resize" } | { kind: "turn", offset: number }} Drag
 */

/** How far an arrow key moves a body, px, and the keys of turning turn it, degrees; with Shift the larger. */
const KEY_DISTANCE = [1, 10];
const KEY_ANGLE = [1, 15];
/** @type {Record<string, number>} */
const SIZE_KEYS = { "+": 1, "=": 1, "-": -1, "−": -1 };
/**
 * Keys that turn, by direction; < and > are , and . with Shift on many keyboards.
 * @type {Record<string, number>}
 */
const TURN_KEYS = { ",": 1, "<": 1, ".": -1, ">": -1 };

/** @implements {Pen} */
export class BendPen {
  /** @type {Drag | null} */
  #drag = null;
  /**
   * The key press that is held: one gesture, undone in one step.
   * @type {object | null}
   */
  #keyGesture = null;
  #draftOf;
  #onBegin;
  #onEnd;

  /**
   * @param {() => import("./draft.js").Draft | null} draftOf
   * @param {() => void} onBegin called when the pointer comes down
   * @param {() => void} onEnd called when a drag has ended
   */
  constructor(draftOf, onBegin, onEnd) {
    this.#draftOf = draftOf;
    this.#onBegin = onBegin;
    this.#onEnd = onEnd;
  }

  /** Whether a body is being dragged. */
  get dragging() {
    return this.#drag !== null;
  }

  /**
   * @param {Point} point
   * @param {number} reach how near a pointer has to come to grab something, px
   */
  begin(point, reach) {
    const draft = this.#draftOf();
    if (!draft) return;
    this.#onBegin();
    this.#drag = draft.body ? knobDrag(draft.body, point, reach) : null;
    if (this.#drag) return;
    // The selected body stays grabbed where it is under another.
    const hit =
      draft.body && distanceTo(draft.body, point) <= 0 ? draft.selected : bodyAt(draft.scene.bodies, point, reach);
    draft.select(hit);
    const { body } = draft;
    if (body) this.#drag = { kind: "move", dx: body.x - point[0], dy: body.y - point[1] };
  }

  /** @param {Point} point */
  draw(point) {
    const draft = this.#draftOf();
    const drag = this.#drag;
    if (!draft?.body || !drag) return;
    const { body } = draft;
    if (drag.kind === "move") {
      // The origin stays in the scene, so that the body can be grabbed again.
      const [x, y] = [point[0] + drag.dx, point[1] + drag.dy].map((value) => Math.min(Math.max(value, 0), SCENE_SIZE));
      draft.moveTo(x, y, drag);
    } else if (drag.kind === "resize") {
      draft.resizeTo(SIZES[body.shape][0], sizeTo(body, point), drag);
    } else {
      draft.turnTo(directionTo(body, point) + drag.offset, drag);
    }
  }

  end() {
    if (!this.#drag) return;
    this.#drag = null;
    this.#onEnd();
  }

  /**
   * Arrows move, + and − resize, , and . turn, N and P select the next and the previous body, Delete removes, D
   * duplicates. Returns whether it was one of these.
   * @param {KeyboardEvent} event
   */
  onKeydown({ key, shiftKey, repeat }) {
    const draft = this.#draftOf();
    if (!draft) return false;
    if (!repeat) this.#keyGesture = {};
    const gesture = this.#keyGesture;
    const large = Number(shiftKey);
    const { body } = draft;
    if (/^[np]$/i.test(key)) {
      draft.selectNext(key.toLowerCase() === "n" ? 1 : -1);
    } else if (!body) {
      // The ball, which these keys move and resize in the other panels, stays.
      return key in ARROW_KEYS || key in SIZE_KEYS;
    } else if (ARROW_KEYS[key]) {
      const [dx, dy] = ARROW_KEYS[key].map((direction) => direction * KEY_DISTANCE[large]);
      draft.moveTo(body.x + dx, body.y + dy, gesture, true);
    } else if (SIZE_KEYS[key]) {
      const [size] = SIZES[body.shape];
      draft.resizeTo(size, sizeOf(body, size) + SIZE_KEYS[key], gesture, true);
    } else if (TURN_KEYS[key]) {
      draft.turnTo(degreesOf(body) + TURN_KEYS[key] * KEY_ANGLE[large], gesture, true);
    } else if (key === "Delete" || key === "Backspace") {
      draft.remove();
    } else if (key.toLowerCase() === "d") {
      draft.duplicate();
    } else if (key === "Escape") {
      draft.select(null);
    } else {
      return false;
    }
    return true;
  }
}

/**
 * The drag of a knob of a body, or null if no knob is within reach.
 * @param {import("../pkg/pathlight.js").OwnBody} body
 * @param {Point} point
 * @param {number} reach
 * @returns {Drag | null}
 */
function knobDrag(body, point, reach) {
  const { size, turn } = knobsOf(body, SCENE_SIZE);
  const [toSize, toTurn] = [size, turn].map((knob) =>
    knob ? Math.hypot(point[0] - knob[0], point[1] - knob[1]) : Infinity,
  );
  if (Math.min(toSize, toTurn) > reach) return null;
  if (toSize <= toTurn) return { kind: "resize" };
  return { kind: "turn", offset: degreesOf(body) - directionTo(body, point) };
}
