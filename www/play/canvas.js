// The scene on its canvas: drawn by the wasm at the screen's own resolution, and played with mouse, touch, pen, wheel
// and keys. Turns gestures into px of the scene and calls the session; decides nothing itself.

import { Component } from "../widgets/component.js";
import { FIRST_RADIUS, SCENE_SIZE } from "../shell/constants.js";
import { contextOf } from "../widgets/dom.js";

/** @typedef {import("../pkg/pathlight.js").Ball} Ball */
/** @typedef {[x: number, y: number]} Point px of the scene, from its lower left corner */

/**
 * Takes pointer and keys while the scene is drawn on.
 * @typedef {object} Pen
 * @property {(point: Point, reach: number) => void} begin the pointer goes down; it grabs what is within reach, px
 * @property {(point: Point) => void} draw the pointer moves
 * @property {(event: KeyboardEvent) => boolean} onKeydown returns whether the key was the pen's
 * @property {() => void} [end] the pointer goes up
 */

/**
 * What lies over the scene.
 * @typedef {object} Overlay
 * @property {HTMLCanvasElement[]} maps
 * @property {number} opacity of the maps, 0..1
 * @property {import("../pkg/pathlight.js").Mark[]} marks
 * @property {Point[]} sketch a line that the person has drawn
 * @property {import("../pkg/pathlight.js").ImaginedPaths | null} imagined what the model imagines for a ball
 * @property {NonNullable<import("../pkg/pathlight.js").View["hints"]>} hints paths that are only hinted at
 * @property {Painter | null} painter draws in the place of the session's puzzle
 */

/**
 * @typedef {(context: CanvasRenderingContext2D, view: import("../pkg/pathlight.js").View, maps: HTMLCanvasElement[]) =>
 *   void} Painter
 */

/** How near a pointer has to come to grab the knob, CSS px. */
const GRAB_DISTANCE = { mouse: 10, pen: 14, touch: 22 };
/** The smallest target for a finger, CSS px from the middle of the ball. */
const FINGER_RADIUS = 22;
/** Radius of the knob, CSS px. */
const KNOB_RADIUS = 6;

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

export class SceneCanvas extends Component {
  #canvas = this.byId("scene", HTMLCanvasElement);
  #context = contextOf(this.#canvas);
  /** CSS px per px of the scene, as last observed: to ask for it while painting would force a layout. */
  #scale = 1;
  #drawScheduled = false;
  /** @type {Drag | null} */
  #drag = null;
  /**
   * The key press that is held: one gesture, undone in one step.
   * @type {object | null}
   */
  #keyGesture = null;
  /** @type {Overlay} */
  #overlay = { maps: [], opacity: 1, marks: [], sketch: [], imagined: null, hints: [], painter: null };
  /** @type {Pen | null} */
  #pen = null;

  /** @param {import("../widgets/dom.js").Root} root */
  constructor(root) {
    super(root);
    const canvas = this.#canvas;
    new ResizeObserver(([entry]) => this.#onResize(entry)).observe(canvas);
    canvas.addEventListener("pointerdown", (event) => this.#onPointerDown(event));
    canvas.addEventListener("pointermove", (event) => this.#onPointerMove(event));
    for (const end of ["pointerup", "pointercancel"])
      canvas.addEventListener(end, (event) => this.#onPointerEnd(/** @type {PointerEvent} */ (event)));
    canvas.addEventListener("wheel", (event) => this.#onWheel(event), { passive: false });
    canvas.addEventListener("keydown", (event) => this.onKeydown(event));
    // Browsers take the memory of a canvas away from a tab that is not seen.
    canvas.addEventListener("contextrestored", () => this.draw());
  }

  /** @param {import("./session.js").Session} session */
  open(session) {
    super.open(session);
    this.listen("change", () => this.draw());
    this.listen("draw", () => this.draw());
    this.draw();
  }

  close() {
    super.close();
    this.#endDrag(this.#pen);
  }

  /** @param {boolean} dark */
  setTheme(dark) {
    super.setTheme(dark);
    this.draw();
  }

  /**
   * Sets what lies over the scene, and who takes pointer and keys (null: the ball is placed).
   * @param {Overlay} overlay
   * @param {Pen | null} pen
   */
  setOverlay(overlay, pen) {
    this.#overlay = overlay;
    const before = this.#pen;
    this.#pen = pen;
    // What a pen has begun ends with it.
    if (pen !== before && this.#drag?.kind === "pen") this.#endDrag(before);
    this.draw();
  }

  /** Draws before the next frame of the screen, once however often it is called. */
  draw() {
    if (this.#drawScheduled) return;
    this.#drawScheduled = true;
    requestAnimationFrame(() => {
      this.#drawScheduled = false;
      this.#paint();
    });
  }

  #paint() {
    const session = this.session;
    if (!session || this.#canvas.width < 2) return;
    const { maps, painter, ...overlay } = this.#overlay;
    const view = {
      step: session.playback.step,
      ball: session.ball,
      knob: KNOB_RADIUS / this.#scale,
      whole: session.phase === "compare",
      approach: session.approach,
      ...overlay,
      dark: this.dark,
    };
    if (painter) painter(this.#context, view, maps);
    else session.puzzle.paint(this.#context, view, maps);
  }

  /** @param {ResizeObserverEntry} entry */
  #onResize(entry) {
    this.#scale = entry.contentRect.width / SCENE_SIZE;
    const rounded = entry.contentRect.width * devicePixelRatio;
    const exact = entry.devicePixelContentBoxSize?.[0].inlineSize;
    // The exact size avoids a blur where the ratio is no integer; emulated screens report it wrongly.
    const side = Math.max(1, Math.round(Math.abs(exact - rounded) < 2 ? exact : rounded));
    if (side === this.#canvas.width) return;
    this.#canvas.width = side;
    this.#canvas.height = side;
    // At once: a canvas that has been resized is empty until it is drawn.
    this.#paint();
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
    const session = this.session;
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
          : GRAB_DISTANCE.mouse) / this.#scale
    );
  }

  /** @param {PointerEvent} event */
  #onPointerEnd({ isPrimary }) {
    // A second finger does not end the drag of the first.
    if (isPrimary) this.#endDrag(this.#pen);
  }

  /** @param {Pen | null} pen */
  #endDrag(pen) {
    const drag = this.#drag;
    this.#drag = null;
    if (drag?.kind === "pen") pen?.end?.();
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
      if (centreDistance <= (isTouch ? Math.max(r, FINGER_RADIUS / this.#scale) : r)) {
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
    const session = this.session;
    if (!drag || !session || !event.isPrimary) return;
    const [x, y] = this.#pointOf(event);
    if (drag.kind === "pen") {
      // A pen that was taken away in the middle of a line ends it.
      this.#pen?.draw([x, y]);
      return;
    }
    // Undo, redo, keys and fields take the ball out of the drag.
    if (String(session.ball) !== String(drag.ball)) {
      this.#drag = null;
      return;
    }
    const [ballX, ballY, r] = drag.ball;
    if (drag.kind === "resize") session.placement.place([ballX, ballY, Math.hypot(x - ballX, y - ballY)], drag);
    else session.placement.place([x + drag.dx, y + drag.dy, r], drag);
    drag.ball = session.ball ?? drag.ball;
  }

  /** @param {WheelEvent} event */
  #onWheel(event) {
    const session = this.session;
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
    const session = this.session;
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
      session.run();
      event.preventDefault();
    }
  }
}
