// The recorded scene as a story in four phases: the futures fan out, one is picked, the real ball falls along it, and
// the guess stands against reality. What is drawn depends on the time alone. Knows no elements but the canvas.

import { percent } from "../model/chance-words.js";
import { SCENE_SIZE, STEPS_PER_SECOND } from "../shell/constants.js";
import { text } from "../text/text.js";
import { ScenePainter, curve } from "../widgets/scene-painter.js";

/** @typedef {import("../pkg/pathlight.js").Palette} Palette */
/** @typedef {import("./recording.js").RecordedScene} RecordedScene */
/** @typedef {import("../widgets/scene-painter.js").Point} Point */
/** @typedef {"imagine" | "pick" | "real" | "result"} Phase */

/** How long the phases last whose time is not that of the rollout, s. */
const IMAGINE = 2.6;
const PICK = 1.8;
const RESULT = 3.5;
/** How much faster than real the green object waits on its goal. */
const WAITING_SPEED = 2.5;
/** Part of the first phase in which a single future grows; they begin one after another. */
const GROWING = 0.55;
/** Opacity of the least likely and of the likeliest future. */
const FAINT = 0.16;
const STRONG = 0.75;
/** px */
const RING_RADIUS = 17;

export class Story {
  #scene;
  /** The futures as curves with their opacity, the faintest first, so that the likeliest lie on top. */
  #futures;
  #guess;
  #guessErrors;
  #guessOfBall;
  #touchTime;
  #realTime;

  /** @param {RecordedScene} scene */
  constructor(scene) {
    this.#scene = scene;
    const { bodies, body1, futures, imagined, ball, real, steps } = scene;
    const [x, y] = bodies[body1].pose;
    const most = Math.max(...futures.map(({ probability }) => probability), 0.01);
    this.#futures = futures
      .map(({ path, probability }) => ({
        points: curve([x, y, ...path]),
        opacity: FAINT + ((STRONG - FAINT) * probability) / most,
      }))
      .reverse();
    this.#guess = curve([x, y, ...imagined.object]);
    this.#guessOfBall = curve([ball[0], ball[1], ...imagined.ball]);
    this.#guessErrors = curve([
      0,
      0,
      ...imagined.errors.slice(0, imagined.steps.length).flatMap((error) => [error, 0]),
    ]).map(([error]) => Math.max(error, 0.5));
    this.#touchTime = (scene.solved ? real.touched : steps) / STEPS_PER_SECOND;
    this.#realTime = this.#touchTime + (steps / STEPS_PER_SECOND - this.#touchTime) / WAITING_SPEED;
  }

  /** How long all of it lasts, s. */
  get duration() {
    return this.endOfRun + RESULT;
  }

  /** When the real run is over, s. */
  get endOfRun() {
    return IMAGINE + PICK + this.#realTime;
  }

  /**
   * @param {number} time s
   * @returns {Phase}
   */
  phaseAt(time) {
    if (time < IMAGINE) return "imagine";
    if (time < IMAGINE + PICK) return "pick";
    return time < this.endOfRun ? "real" : "result";
  }

  /**
   * Says what is seen.
   * @param {Phase} phase
   */
  wordsOf(phase) {
    const { futures, imagined, miss, solved } = this.#scene;
    const words = text.home.story;
    switch (phase) {
      case "imagine":
        return words.imagine(futures.length);
      case "pick":
        return words.pick(percent(imagined.probability));
      case "real":
        return words.real;
      case "result":
        return (solved ? words.solved : words.missed)(percent(miss / SCENE_SIZE));
    }
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {Palette} colours
   * @param {number} time s
   */
  draw(context, colours, time) {
    const { bodies, body2, ball } = this.#scene;
    const phase = this.phaseAt(time);
    const picked = (time - IMAGINE) / PICK;
    const step = phase === "imagine" || phase === "pick" ? 0 : this.#stepAt(time);
    const poses = this.#posesAt(step);
    const painter = new ScenePainter(context, colours);
    this.#drawFutures(painter, colours, time);
    if (phase !== "imagine") this.#drawGuess(painter, colours, Math.min(picked * 1.6, 1));
    if (step > 0) this.#drawReal(painter, colours, step, poses);
    bodies.forEach((body, index) => painter.body(body, poses.get(index) ?? body.pose, index === body2));
    const red = poses.get(bodies.length);
    if (phase !== "imagine" && red) painter.ball(ball[2] * Math.min(picked * 4, 1), red);
    if (phase === "result" && this.#scene.solved) this.#drawRing(painter, poses);
  }

  /**
   * @param {ScenePainter} painter
   * @param {Palette} colours
   * @param {number} time
   */
  #drawFutures(painter, colours, time) {
    // They fade while one is picked.
    const fade = Math.min(Math.max(1 - (time - IMAGINE) / (PICK * 0.6), 0), 1);
    if (fade === 0) return;
    this.#futures.forEach(({ points, opacity }, index) => {
      const begin = (1 - GROWING) * (1 - (index + 1) / this.#futures.length);
      const grown = Math.min(Math.max((time / IMAGINE - begin) / GROWING, 0), 1);
      painter.line(partOf(points, grown), { colour: colours.green, width: 1.4, opacity: opacity * fade });
    });
  }

  /**
   * @param {ScenePainter} painter
   * @param {Palette} colours
   * @param {number} grown
   */
  #drawGuess(painter, colours, grown) {
    const points = partOf(this.#guess, grown);
    const radii = this.#guessErrors;
    painter.ribbon(points, radii, colours.green, 0.16);
    painter.ribbon(
      points,
      radii.map((radius) => radius / 2),
      colours.green,
      0.16,
    );
    painter.line(points, { colour: colours.green, width: 1.8, dotted: true });
    painter.line(partOf(this.#guessOfBall, grown), { colour: colours.red, width: 1.6, opacity: 0.8, dotted: true });
  }

  /**
   * The paths that were really taken.
   * @param {ScenePainter} painter
   * @param {Palette} colours
   * @param {number} step
   * @param {Map<number, number[]>} poses
   */
  #drawReal(painter, colours, step, poses) {
    const { bodies, body1, real } = this.#scene;
    for (const [body, colour] of /** @type {[number, string][]} */ ([
      [bodies.length, colours.red],
      [body1, colours.green],
    ])) {
      const column = real.bodies.indexOf(body) * 3;
      const passed = real.poses.slice(0, Math.ceil(step / real.every));
      /** @type {Point[]} */
      const points = passed.map((row) => [row[column], row[column + 1]]);
      const [x, y] = poses.get(body) ?? [];
      points.push([x, y]);
      // A rim in the colour of the paper keeps it apart from what was imagined.
      painter.line(points, { colour: colours.paper, width: 3.4, opacity: 0.7 });
      painter.line(points, { colour, width: 2 });
    }
  }

  /**
   * The ring that is full when the green object has touched its goal for long enough.
   * @param {ScenePainter} painter
   * @param {Map<number, number[]>} poses
   */
  #drawRing(painter, poses) {
    const [x, y] = poses.get(this.#scene.body1) ?? [];
    painter.ring([x, y], RING_RADIUS);
  }

  /** @param {number} time */
  #stepAt(time) {
    const running = Math.min(time, this.endOfRun) - IMAGINE - PICK;
    const waited = Math.max(running - this.#touchTime, 0) * WAITING_SPEED;
    return Math.min((Math.min(running, this.#touchTime) + waited) * STEPS_PER_SECOND, this.#scene.steps);
  }

  /**
   * The poses of the moving bodies after a number of steps, by body.
   * @param {number} step
   */
  #posesAt(step) {
    const { real, steps } = this.#scene;
    const index = Math.min(Math.floor(step / real.every), real.poses.length - 2);
    const [from, to] = [index * real.every, Math.min((index + 1) * real.every, steps)];
    const fraction = Math.min((step - from) / (to - from), 1);
    const [before, after] = [real.poses[index], real.poses[index + 1]];
    const at = (/** @type {number} */ place) => before[place] + fraction * (after[place] - before[place]);
    return new Map(real.bodies.map((body, column) => [body, [3 * column, 3 * column + 1, 3 * column + 2].map(at)]));
  }
}

/**
 * The beginning of a curve.
 * @param {Point[]} points
 * @param {number} fraction
 * @returns {Point[]}
 */
function partOf(points, fraction) {
  const end = fraction * (points.length - 1);
  const whole = Math.floor(end);
  const part = points.slice(0, whole + 1);
  if (whole === end) return part;
  const [[x, y], [u, v]] = [points[whole], points[whole + 1]];
  return [...part, [x + (end - whole) * (u - x), y + (end - whole) * (v - y)]];
}
