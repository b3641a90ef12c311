// The scene on its canvas, drawn by the wasm at the screen's own resolution. gestures.js has what pointer, wheel and
// keys do there.

import { Component } from "../widgets/component.js";
import { SCENE_SIZE } from "../shell/constants.js";
import { contextOf } from "../widgets/dom.js";
import { Gestures } from "./gestures.js";
import { Loupe } from "./loupe.js";
import { isModels, namesOf } from "./ball-names.js";

/** @typedef {[x: number, y: number]} Point px of the scene, from its lower left corner */

/**
 * What lies over the scene.
 * @typedef {object} Overlay
 * @property {HTMLCanvasElement[]} maps
 * @property {number} opacity of the maps, 0..1
 * @property {import("../pkg/pathlight.js").Mark[]} marks
 * @property {Point[]} sketch a line that the person has drawn
 * @property {import("../pkg/pathlight.js").ImaginedPaths | null} imagined what the model imagines for a ball
 * @property {NonNullable<import("../pkg/pathlight.js").View["hints"]>} hints paths that are only hinted at
 * @property {Painter | null} painter draws instead of the session's puzzle
 * @property {import("./gestures.js").Pen | null} pen takes pointer and keys; null: the ball is placed
 */

/**
 * @typedef {(context: CanvasRenderingContext2D, view: import("../pkg/pathlight.js").View, maps: HTMLCanvasElement[]) =>
 *   void} Painter
 */

/** @type {Overlay} */
const NO_OVERLAY = { maps: [], opacity: 1, marks: [], sketch: [], imagined: null, hints: [], painter: null, pen: null };
/** Radius of the knob, CSS px. */
const KNOB_RADIUS = 6;

export class SceneCanvas extends Component {
  #canvas = this.byId("scene", HTMLCanvasElement);
  #context = contextOf(this.#canvas);
  /** CSS px per px of the scene, as last observed: to ask for it while painting would force a layout. */
  #scale = 1;
  #resizes = new ResizeObserver(([entry]) => this.#onResize(entry));
  #drawScheduled = false;
  #loupe = new Loupe(this.byId("loupe", HTMLCanvasElement), this.#canvas);
  #gestures = new Gestures(
    this.#canvas,
    () => this.session,
    () => this.#scale,
    (point) => this.#loupe.show(point),
  );
  /** @type {Overlay} */
  #overlay = NO_OVERLAY;

  /** @param {import("../widgets/dom.js").Root} root */
  constructor(root) {
    super(root);
    // Browsers take the memory of a canvas away from a tab that is not seen.
    this.#canvas.addEventListener("contextrestored", () => this.draw());
  }

  /** @param {import("./session.js").Session} session */
  open(session) {
    super.open(session);
    this.listen("change", () => {
      // The style sheet tints the frame of the model's run.
      this.#canvas.parentElement?.classList.toggle("models", isModels(session));
      this.draw();
    });
    this.listen("draw", () => this.draw());
    this.#measure();
    this.draw();
  }

  close() {
    super.close();
    this.#canvas.parentElement?.classList.remove("models");
    this.#gestures.endDrag();
  }

  /** @param {boolean} dark */
  setTheme(dark) {
    super.setTheme(dark);
    this.draw();
  }

  /**
   * Sets what lies over the scene.
   * @param {Partial<Overlay>} overlay
   */
  setOverlay(overlay) {
    this.#overlay = { ...NO_OVERLAY, ...overlay };
    this.#gestures.setPen(this.#overlay.pen);
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
    const { maps, painter, opacity, marks, sketch, imagined, hints } = this.#overlay;
    const view = {
      step: session.playback.step,
      ball: session.ball,
      valid: session.invalidReason === null,
      knob: KNOB_RADIUS / this.#scale,
      // The paths of a race are not told before it is run.
      whole: session.phase === "compare" && session.finished,
      approach: session.approach,
      names: namesOf(session),
      spark: session.reducedMotion ? null : session.moments.contact,
      ...{ opacity, marks, sketch, imagined, hints },
      dark: this.dark,
    };
    if (painter) painter(this.#context, view, maps);
    else session.game.paint(this.#context, view, maps);
    this.#loupe.draw();
  }

  /**
   * Asks for the size of the canvas: now, whenever it changes, and when the page goes to a screen with another pixel
   * ratio, which leaves the size in CSS px as it was.
   */
  #measure() {
    this.#resizes.unobserve(this.#canvas);
    this.#resizes.observe(this.#canvas);
    this.listenTo(matchMedia(`(resolution: ${devicePixelRatio}dppx)`), "change", ({ target }) => {
      if (!(/** @type {MediaQueryList} */ (target).matches)) this.#measure();
    });
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
   * Acts on a key of the scene that was pressed elsewhere.
   * @param {KeyboardEvent} event
   */
  onKeydown(event) {
    this.#gestures.onKeydown(event);
  }
}
