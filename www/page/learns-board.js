// One of the two scenes of "It learns while you watch": shows the tries at a puzzle in short, one after the other. What
// is drawn depends on the time alone.

import { DARK_PALETTE, LIGHT_PALETTE } from "../pkg/constants.js";
import { ScenePainter } from "../widgets/scene-painter.js";
import { ATTEMPT_LIMIT } from "../shell/constants.js";
import { pathlight } from "../shell/page-api.js";
import { text } from "../text/text.js";
import { contextOf, find, setText } from "../widgets/dom.js";
import { shownTries } from "./learns-words.js";

/** @typedef {import("../pkg/pathlight.js").TriedProposal} TriedProposal */
/** @typedef {import("./learns-words.js").ShownTry} ShownTry */
/**
 * A try that is shown: the steps of its run that are, and where the green object was at each.
 * @typedef {ShownTry & { rollout: import("../pkg/pathlight.js").Rollout, steps: number, path: [number, number][] }} Run
 */

const darkScheme = matchMedia("(prefers-color-scheme: dark)");
/** More device pixels per CSS px than this are not worth their time. */
const MAX_PIXEL_RATIO = 2;
/** Most steps that are shown of a try before the last. */
const MOST_STEPS = 420;
/** Steps of a solution that are left out at its end, where nothing moves. */
const WAITING = 150;

export class LearnsBoard {
  #canvas;
  #caption;
  /** @type {import("../pkg/pathlight.js").Scene | null} */
  #scene = null;
  #task = "";
  /** @type {TriedProposal[]} */
  #tries = [];
  /** @type {ShownTry[]} */
  #shown = [];
  /**
   * By the number of the try.
   * @type {Map<number, Run>}
   */
  #runs = new Map();
  #time = Infinity;

  /** @param {HTMLElement} figure */
  constructor(figure) {
    this.#canvas = find(figure, "canvas", HTMLCanvasElement);
    this.#caption = find(figure, ".tries");
    darkScheme.addEventListener("change", () => this.#draw());
    new ResizeObserver(() => this.#resize()).observe(this.#canvas);
  }

  /**
   * Shows a scene before anything was tried.
   * @param {string} task
   */
  clear(task) {
    this.show(task, []);
    setText(this.#caption, "");
  }

  /**
   * Takes the tries at a puzzle. Returns how long they are shown, s.
   * @param {string} task
   * @param {TriedProposal[]} tries
   */
  show(task, tries) {
    this.#task = task;
    this.#scene = pathlight.scene(task);
    this.#tries = tries;
    this.#shown = tries.length ? shownTries(tries.length) : [];
    this.#runs.clear();
    this.setTime(0);
    return this.#shown.at(-1)?.end ?? 0;
  }

  /** @param {number} time since the first try began, s; infinite for the end of the last */
  setTime(time) {
    this.#time = time;
    this.#draw();
  }

  #resize() {
    const side = Math.round(this.#canvas.clientWidth * Math.min(devicePixelRatio, MAX_PIXEL_RATIO));
    if (side === 0 || side === this.#canvas.width) return;
    this.#canvas.width = this.#canvas.height = side;
    this.#draw();
  }

  #draw() {
    const scene = this.#scene;
    if (!scene) return;
    const colours = darkScheme.matches ? DARK_PALETTE : LIGHT_PALETTE;
    const painter = new ScenePainter(contextOf(this.#canvas), colours);
    const shown = this.#shown.find(({ end }) => this.#time < end) ?? this.#shown.at(-1);
    const run = shown && this.#runOf(shown);
    const step = run ? Math.round(run.steps * Math.min((this.#time - run.start) / (run.end - run.start), 1)) : 0;
    const pose = (/** @type {number} */ column) => {
      const at = run ? (step * run.rollout.bodies.length + column) * 3 : 0;
      return run ? Array.from(run.rollout.poses.subarray(at, at + 3)) : [];
    };
    scene.bodies.forEach((body, index) => {
      const column = run?.rollout.bodies.indexOf(index) ?? -1;
      painter.body(body, column < 0 ? [body.x, body.y, body.angle] : pose(column), index === scene.body2);
    });
    if (!run || !shown) return;
    const before = this.#tries.slice(0, shown.number - 1).map(({ ball }) => ball);
    painter.ribbon(
      before.map(([x, y]) => [x, y]),
      before.map(([, , radius]) => radius),
      colours.red,
      0.14,
    );
    painter.line(run.path.slice(0, step + 1), { colour: colours.green, width: 2.5, opacity: 0.7 });
    painter.ball(this.#tries[shown.number - 1].ball[2], pose(run.rollout.bodies.length - 1));
    setText(this.#caption, this.#words(shown));
  }

  /** @param {ShownTry} shown */
  #words({ number, end }) {
    const isOver = number === this.#tries.length && this.#time >= end;
    if (!isOver) return text.learns.try(number);
    const { solved, missed } = text.learns;
    return this.#tries[number - 1].ending.solved ? solved(number, ATTEMPT_LIMIT) : missed(number);
  }

  /**
   * @param {ShownTry} shown
   * @returns {Run}
   */
  #runOf(shown) {
    const known = this.#runs.get(shown.number);
    if (known) return known;
    const rollout = pathlight.simulate(this.#task, this.#tries[shown.number - 1].ball);
    const isLast = shown.number === this.#tries.length;
    const steps = isLast ? rollout.steps - (rollout.solved ? WAITING : 0) : Math.min(rollout.steps, MOST_STEPS);
    const { bodies, poses } = rollout;
    const object = bodies.indexOf(/** @type {import("../pkg/pathlight.js").Scene} */ (this.#scene).body1);
    const path = Array.from({ length: steps + 1 }, (_, step) => {
      const at = (step * bodies.length + object) * 3;
      return /** @type {[number, number]} */ ([poses[at], poses[at + 1]]);
    });
    const run = { ...shown, rollout, steps, path };
    this.#runs.set(shown.number, run);
    return run;
  }
}
