// What a person does in the scene with mouse, touch, pen, wheel and keys: turns it into px of the scene and calls the
// session, or whatever pen is being used. Decides nothing itself.

import { FIRST_RADIUS, SCENE_SIZE } from "../shell/constants.js";
import { sameBall } from "../puzzles/ball.js";

/** @typedef {import("../pkg/pathlight.js").Ball} Ball */
/** @typedef {import("./canvas.js").Point} Point */

/**
 * Takes pointer and keys while the scene is drawn on.
 * @typedef {object} Pen
 * @property {(point: Point, reach: number) => void} begin the pointer goes down; it grabs what is within reach, px
 * @property {(point: Point) => void} draw the pointer moves
 * @property {(event: KeyboardEvent) => boolean} onKeydown returns whether the key was the pen's
 * @property {() => void} [end] the pointer goes up
 */

/** How near a pointer has to come to grab the knob, CSS px. */
const GRAB_DISTANCE = { mouse: 10, pen: 14, touch: 22 };
/** The smallest target for a finger, CSS px from the middle of the ball. */
const FINGER_RADIUS = 22;
/**
 * The arrow keys as directions, y upwards.
 * @type {Record<string, Point>}
 */
export const ARROW_KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
/**
 * The keys that change the radius.
 * @type {Record<string, number>}
 */
const RADIUS_KEYS = { "+": 1, "=": 1, "-": -1, "−": -1 };

/**
 * What the pointer does between down and up. A drag of the ball keeps the offset of its centre from the pointer, and
 * the ball as the drag left it.
 * @typedef {{ kind: "pen" } | { kind: "move", dx: number, dy: number, ball: Ball } | { kind: "resize", ball: Ball }}
 *   Drag
 */

export class Gestures {
  #canvas;
  #session;
  #scale;
  #onTouch;
  /** @type {Drag | null} */
  #drag = null;
  /**
   * The key press that is held: one gesture, undone in one step.
   * @type {object | null}
   */
  #keyGesture = null;
  /** @type {Pen | null} */
  #pen = null;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {() => import("./session.js").Session | null} session
   * @param {() => number} scale CSS px per px of the scene
   * @param {(point: Point | null) => void} onTouch a finger drags the ball at a point; null: no longer
   */
  constructor(canvas, session, scale, onTouch) {
    this.#canvas = canvas;
    this.#session = session;
    this.#scale = scale;
    this.#onTouch = onTouch;
    canvas.addEventListener("pointerdown", (event) => this.#onPointerDown(event));
    canvas.addEventListener("pointermove", (event) => this.#onPointerMove(event));
    for (const end of ["pointerup", "pointercancel"])
      canvas.addEventListener(end, (event) => this.#onPointerEnd(/** @type {PointerEvent} */ (event)));
    canvas.addEventListener("wheel", (event) => this.#onWheel(event), { passive: false });
    canvas.addEventListener("keydown", (event) => this.onKeydown(event));
  }

  /**
   * Sets who takes pointer and keys; null: the ball is placed.
   * @param {Pen | null} pen
   */
  setPen(pen) {
    // What a pen has begun ends with it.
    if (pen !== this.#pen && this.#drag?.kind === "pen") this.endDrag();
    this.#pen = pen;
  }

  /**
   * @param {MouseEvent} event
   * @returns {Point}
   */
  #pointOf({ clientX, clientY }) {
    const box = this.#canvas.getBoundingClientRect();
    return [((clientX - box.left) / box.width) * SCENE_SIZE, ((box.bottom - clientY) / box.height) * SCENE_SIZE];
  }

  /** @param {PointerEvent} event */
  #onPointerDown(event) {
    const session = this.#session();
    if (!session || event.button !== 0 || !event.isPrimary) return;
    event.preventDefault();
    this.#canvas.focus({ preventScroll: true });
    this.#canvas.setPointerCapture(event.pointerId);
    const point = this.#pointOf(event);
    if (this.#pen) {
      this.#drag = { kind: "pen" };
      this.#pen.begin(point, this.#reachOf(event.pointerType));
    } else {
      this.#beginDrag(session, point, event.pointerType);
    }
  }

  /**
   * How near a pointer has to come to grab something, px.
   * @param {string} pointerType
   */
  #reachOf(pointerType) {
    return (
      (pointerType === "touch"
        ? GRAB_DISTANCE.touch
        : pointerType === "pen"
          ? GRAB_DISTANCE.pen
          : GRAB_DISTANCE.mouse) / this.#scale()
    );
  }

  /** @param {PointerEvent} event */
  #onPointerEnd({ isPrimary }) {
    // A second finger does not end the drag of the first.
    if (isPrimary) this.endDrag();
  }

  /** The pointer lets go, or what it did is over. */
  endDrag() {
    const drag = this.#drag;
    this.#drag = null;
    this.#onTouch(null);
    if (drag?.kind === "pen") this.#pen?.end?.();
    // The person may have taken the ball elsewhere meanwhile.
    else if (drag && sameBall(this.#session()?.ball, drag.ball)) this.#session()?.placement.settle(drag);
  }

  /**
   * Grabs the knob or the ball, or places the ball under the pointer and grabs it there.
   * @param {import("./session.js").Session} session
   * @param {Point} point
   * @param {string} pointerType
   */
  #beginDrag(session, [x, y], pointerType) {
    if (!session.placing) session.reset();
    const { ball } = session;
    if (ball) {
      const [ballX, ballY, r] = ball;
      const centreDistance = Math.hypot(x - ballX, y - ballY);
      const knobDistance = Math.hypot(x - ballX - r, y - ballY);
      const isTouch = pointerType === "touch";
      if (knobDistance < this.#reachOf(pointerType) && knobDistance < centreDistance) {
        this.#drag = { kind: "resize", ball };
        return;
      }
      if (centreDistance <= (isTouch ? Math.max(r, FINGER_RADIUS / this.#scale()) : r)) {
        this.#drag = { kind: "move", dx: ballX - x, dy: ballY - y, ball };
        return;
      }
    }
    /** @type {Drag} */
    const drag = { kind: "move", dx: 0, dy: 0, ball: [x, y, ball?.[2] ?? FIRST_RADIUS] };
    session.placement.place(drag.ball, drag);
    drag.ball = session.ball ?? drag.ball;
    this.#drag = drag;
  }

  /** @param {PointerEvent} event */
  #onPointerMove(event) {
    const drag = this.#drag;
    const session = this.#session();
    if (!drag || !session || !event.isPrimary) return;
    const [x, y] = this.#pointOf(event);
    if (drag.kind === "pen") {
      // A pen that was taken away in the middle of a line ends it.
      this.#pen?.draw([x, y]);
      return;
    }
    // Undo, redo, keys and fields take the ball out of the drag.
    if (!sameBall(session.ball, drag.ball)) {
      this.#drag = null;
      this.#onTouch(null);
      return;
    }
    const [ballX, ballY, r] = drag.ball;
    if (drag.kind === "resize") session.placement.place([ballX, ballY, Math.hypot(x - ballX, y - ballY)], drag);
    else session.placement.place([x + drag.dx, y + drag.dy, r], drag);
    drag.ball = session.ball ?? drag.ball;
    if (event.pointerType === "touch") this.#onTouch([x, y]);
  }

  /** @param {WheelEvent} event */
  #onWheel(event) {
    const session = this.#session();
    if (!session?.placing || !session.ball || event.ctrlKey || event.deltaY === 0) return;
    event.preventDefault();
    session.placement.nudge(0, 0, event.deltaY < 0 ? 1 : -1, "wheel");
    // A drag goes on with the ball of another size.
    if (this.#drag && this.#drag.kind !== "pen") this.#drag.ball = session.ball;
  }

  /**
   * Arrows, + and −, Enter; the pen's own keys while the scene is drawn on.
   * @param {KeyboardEvent} event
   */
  onKeydown(event) {
    const session = this.#session();
    if (!session || event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    if (this.#pen?.onKeydown(event)) {
      event.preventDefault();
      return;
    }
    const distance = event.shiftKey ? 10 : 1;
    const [dx, dy] = ARROW_KEYS[event.key] ?? [0, 0];
    const dr = RADIUS_KEYS[event.key] ?? 0;
    if (dx || dy || dr) {
      // A key that is held down is one gesture.
      if (!event.repeat) this.#keyGesture = {};
      session.placement.nudge(dx * distance, dy * distance, dr, this.#keyGesture);
      event.preventDefault();
    } else if (event.key === "Enter") {
      if (!event.repeat) session.run();
      event.preventDefault();
    }
  }
}
