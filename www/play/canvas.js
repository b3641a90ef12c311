// The scene on its canvas: drawn by the wasm at the screen's own resolution, and played with mouse, touch, pen,
// wheel and keys. Turns gestures into px of the scene and asks the session; decides nothing itself.

/** How near a pointer has to come to grab the knob, CSS px. */
const REACH = { mouse: 10, pen: 14, touch: 22 };
/** The smallest thing that a finger can drag, CSS px from the middle of the ball. */
const FINGER = 22;
const FIRST_RADIUS = 12;
/** Radius of the knob, CSS px. */
const KNOB = 6;
const SIZE = 256;

export class SceneCanvas {
  #canvas;
  #context;
  #session = null;
  #waiting = false;
  /** What the pointer holds: { kind: "ball", dx, dy } or { kind: "radius" }, or null. Each is a gesture of its own. */
  #held = null;
  /** The gesture of the key that was pressed last. */
  #press = null;
  /** Maps to lay over the scene, canvases of 64 x 64. */
  maps = [];
  opacity = 0.8;
  /** Balls to mark, [{ ball, from, chosen }, …]: `from` is the place that one comes from, or null. */
  marks = [];
  /** A line that the person has drawn, [[x, y], …]. */
  sketch = [];
  /** Who takes pointer and keys while the scene is drawn on, { begin(point), draw(point), key(event) }; null while
   * the ball is placed. */
  pen = null;
  dark = false;

  constructor(canvas) {
    this.#canvas = canvas;
    this.#context = canvas.getContext("2d");
    new ResizeObserver(([entry]) => this.#resize(entry)).observe(canvas);
    canvas.addEventListener("pointerdown", (event) => this.#down(event));
    canvas.addEventListener("pointermove", (event) => this.#move(event));
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => (this.#held = null));
    canvas.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
    canvas.addEventListener("keydown", (event) => this.key(event));
  }

  /** Shows another session, or none. */
  show(session) {
    this.#session = session;
    this.#held = null;
    for (const what of ["change", "draw"]) session?.addEventListener(what, () => this.draw());
    this.draw();
  }

  /** Draws before the next frame of the screen, once however often it is asked. */
  draw() {
    if (this.#waiting) return;
    this.#waiting = true;
    requestAnimationFrame(() => {
      this.#waiting = false;
      this.#paint();
    });
  }

  #paint() {
    const session = this.#session;
    if (!session || this.#canvas.width < 2) return;
    const view = {
      step: session.playback.step,
      ball: session.ball,
      knob: KNOB / this.#scale,
      whole: session.phase === "compare",
      opacity: this.opacity,
      marks: this.marks,
      sketch: this.sketch,
      dark: this.dark,
    };
    session.puzzle.paint(this.#context, view, this.maps);
  }

  #resize(entry) {
    const near = entry.contentRect.width * devicePixelRatio;
    const exact = entry.devicePixelContentBoxSize?.[0].inlineSize;
    // The exact size spares a blur where the ratio is no whole number; an emulated screen tells it wrong.
    const side = Math.max(1, Math.round(Math.abs(exact - near) < 2 ? exact : near));
    if (side === this.#canvas.width) return;
    this.#canvas.width = side;
    this.#canvas.height = side;
    // At once: a canvas that has been resized is empty until it is drawn.
    this.#paint();
  }

  /** CSS px in one px of the scene. */
  get #scale() {
    return this.#canvas.clientWidth / SIZE;
  }

  #point(event) {
    const box = this.#canvas.getBoundingClientRect();
    return [((event.clientX - box.left) / box.width) * SIZE, ((box.bottom - event.clientY) / box.height) * SIZE];
  }

  #down(event) {
    if (!this.#session || event.button !== 0 || !event.isPrimary) return;
    event.preventDefault();
    this.#canvas.focus({ preventScroll: true });
    this.#canvas.setPointerCapture(event.pointerId);
    if (this.pen) {
      this.#held = { kind: "pen" };
      return this.pen.begin(this.#point(event));
    }
    const session = this.#session;
    const [x, y] = this.#point(event);
    const [ballX, ballY, r] = session.ball ?? [Infinity, Infinity, FIRST_RADIUS];
    const fromMiddle = Math.hypot(x - ballX, y - ballY);
    const fromKnob = Math.hypot(x - ballX - r, y - ballY);
    const reach = (REACH[event.pointerType] ?? REACH.mouse) / this.#scale;
    const grip = event.pointerType === "touch" ? Math.max(r, FINGER / this.#scale) : r;
    if (!session.placing) session.reset();
    if (fromKnob < reach && fromKnob < fromMiddle) {
      this.#held = { kind: "radius" };
    } else if (fromMiddle <= grip) {
      this.#held = { kind: "ball", dx: ballX - x, dy: ballY - y };
    } else {
      this.#held = { kind: "ball", dx: 0, dy: 0 };
      session.place([x, y, r], this.#held);
    }
  }

  #move(event) {
    const held = this.#held;
    if (!held || !event.isPrimary) return;
    // A pen that has been taken away in the middle of a line ends it.
    if (held.kind === "pen") return this.pen?.draw(this.#point(event));
    const [x, y] = this.#point(event);
    const [ballX, ballY, r] = this.#session.ball;
    if (held.kind === "radius") this.#session.place([ballX, ballY, Math.hypot(x - ballX, y - ballY)], held);
    else this.#session.place([x + held.dx, y + held.dy, r], held);
  }

  #wheel(event) {
    const session = this.#session;
    if (!session?.placing || !session.ball || event.ctrlKey || event.deltaY === 0) return;
    event.preventDefault();
    session.nudge(0, 0, event.deltaY < 0 ? 1 : -1, "wheel");
  }

  /** Arrows, + and −, Enter. */
  key(event) {
    if (!this.#session || event.ctrlKey || event.metaKey || event.altKey) return;
    if (this.pen?.key(event)) return event.preventDefault();
    const far = event.shiftKey ? 10 : 1;
    const nudges = {
      ArrowLeft: [-far, 0, 0],
      ArrowRight: [far, 0, 0],
      ArrowUp: [0, far, 0],
      ArrowDown: [0, -far, 0],
      "+": [0, 0, 1],
      "=": [0, 0, 1],
      "-": [0, 0, -1],
      "−": [0, 0, -1],
    };
    if (Object.hasOwn(nudges, event.key)) {
      // A key that is held down is one gesture, undone at once.
      if (!event.repeat) this.#press = {};
      this.#session.nudge(...nudges[event.key], this.#press);
      event.preventDefault();
    } else if (event.key === "Enter") {
      this.#session.run();
      event.preventDefault();
    }
  }
}
