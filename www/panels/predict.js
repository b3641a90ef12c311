// Predict first: the person draws the path that they think the green object will take, runs, and is measured beside
// the net, both against the real path. Without a ball the net's word is its base path, with the ball its target
// path. The scene's canvas hands over pointer and keys while this panel is on.

import { Plate, percent } from "./overlap-card.js";
import { say } from "../shell/announce.js";

const at = (id) => document.getElementById(id);
const SIZE = 256;
/** The shortest piece of a line worth keeping, px; and the most points of one, which a whole day of drawing ends at. */
const PIECE = 2;
const MOST = 4000;
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

export class Predict extends EventTarget {
  /** The line, [[x, y], …] in px. */
  sketch = [];
  #wasm;
  #imagine;
  #session = null;
  /** Is this panel on? */
  #on = false;
  #dark = false;
  #plates;

  /** Fires "sketch" when the line has changed. */
  constructor(wasm, imagine) {
    super();
    this.#wasm = wasm;
    this.#imagine = imagine;
    this.#plates = [new Plate(wasm), new Plate(wasm)];
    at("predict-plates").append(...this.#plates.map(({ element }) => element));
    at("predict-watch").addEventListener("click", () => this.#session.watch());
    at("predict-run").addEventListener("click", () => {
      this.#session.reset();
      this.#session.run();
    });
    at("predict-wipe").addEventListener("click", () => this.#draw([]));
    imagine.addEventListener("imagined", () => this.#update());
  }

  show(session) {
    this.#session = session;
    session.addEventListener("change", () => this.#update());
    session.drawing = this.#on;
    this.#draw([]);
  }

  set({ panel }) {
    this.#on = panel === "predict";
    if (this.#session) this.#session.drawing = this.#on;
  }

  set dark(dark) {
    this.#dark = dark;
    if (this.#session) this.#update();
  }

  /** A pointer goes down: a new line begins. */
  begin(point) {
    this.#fresh();
    this.#draw([inside(point)]);
  }

  /** The pointer goes on. */
  draw(point) {
    const next = inside(point);
    const last = this.sketch.at(-1);
    if (Math.hypot(next[0] - last[0], next[1] - last[1]) >= PIECE && this.sketch.length < MOST) this.#draw([...this.sketch, next]);
  }

  /** A key in the scene: arrows go on from the end of the line, or from the green object. Says whether it was one. */
  key({ key, shiftKey }) {
    const by = ARROWS[key];
    if (by) {
      this.#fresh();
      const line = this.sketch.length ? this.sketch : [[...this.#session.puzzle.start()]];
      const far = shiftKey ? 24 : 6;
      this.#draw([...line, inside(line.at(-1).map((value, axis) => value + by[axis] * far))]);
    } else if (key === "Backspace") {
      this.#fresh();
      this.#draw(this.sketch.slice(0, -1));
    }
    return Boolean(by) || key === "Backspace";
  }

  /** What has been run is over: a prediction is about what comes. */
  #fresh() {
    if (!this.#session.placing) this.#session.reset();
  }

  #draw(line) {
    this.sketch = line;
    this.#update();
    this.dispatchEvent(new Event("sketch"));
  }

  #update() {
    const session = this.#session;
    if (!session) return;
    const none = this.sketch.length === 0;
    at("predict-watch").disabled = none;
    at("predict-run").disabled = none || !session.ball || Boolean(session.reason);
    at("predict-wipe").disabled = none;
    const own = session.phase === "watch" || session.shown?.agent === "player";
    const over = !none && session.finished && own && !session.placing;
    at("predict-result").hidden = !over;
    const words = over ? this.#score() : none ? "Nothing drawn yet." : `Your line ends at ${spoken(this.sketch.at(-1))}.`;
    if (at("predict-words").textContent === words) return;
    at("predict-words").textContent = words;
    if (this.#on) say(words);
  }

  /** Measures both against the real path and says who was closer. */
  #score() {
    const { puzzle, phase, about } = this.#session;
    const stage = phase === "watch" ? "base" : "target";
    const real = puzzle.paths()[0].object;
    const net = this.#imagine.values?.[stage];
    const [mine, its] = this.#plates;
    const shared = { task: about.id, stage, real, dark: this.#dark };
    const you = mine.draw({ ...shared, name: "You", values: puzzle.sketch(new Float64Array(this.sketch.flat())) });
    its.element.hidden = !net;
    if (!net) return `You were right by ${percent(you)}.`;
    const it = its.draw({ ...shared, name: "The net", values: net });
    const [first, second] = [percent(you), percent(it)];
    if (first === second) return `A draw: both were right by ${first}.`;
    return you > it ? `You were closer: ${first}, the net ${second}.` : `The net was closer: ${second}, you ${first}.`;
  }
}

function inside(point) {
  return point.map((value) => Math.min(Math.max(value, 0), SIZE));
}

function spoken(point) {
  const [x, y] = point.map(Math.round);
  return `x ${x}, y ${y}`;
}
