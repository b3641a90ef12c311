// Draws a scene on a canvas by plain calls: the recorded scene, which is shown before the wasm is loaded, the two
// scenes of “Watch it learn”, and small pictures. The wasm draws puzzles that are played. One unit is one px of the
// scene, y up.

import { SCENE_SIZE } from "../shell/constants.js";

/** @typedef {import("../pkg/pathlight.js").Palette} Palette */
/** @typedef {import("../pkg/pathlight.js").Role} Role */
/** @typedef {import("../pkg/pathlight.js").Shape} Shape */
/** @typedef {[x: number, y: number]} Point */

/**
 * How bodies are drawn, all px: the width of the line round each, the rim of a black one or else its own colour; the
 * distance between the lines of a goal's hatching, and their width.
 * @typedef {{ rim: number, outline: number, hatch: number, hatchWidth: number }} Strokes
 */

/** @type {Strokes} */
const FINE = { rim: 1, outline: 0, hatch: 4.5, hatchWidth: 1.2 };
/**
 * In a picture 72 to 160 CSS px wide, a bar is hardly more than a pixel thick, and fine hatching a grey veil.
 * @type {Strokes}
 */
export const BOLD = { rim: 2.6, outline: 2.6, hatch: 10, hatchWidth: 3 };
/** How many points a curve has between two of a path. */
const CURVE_POINTS = 5;

/**
 * The points of a path, on a smooth curve through them.
 * @param {number[]} path x, y, x, y, …
 * @returns {Point[]}
 */
export function curve(path) {
  /** @type {Point[]} */
  const points = [];
  for (let at = 0; at < path.length; at += 2) points.push([path[at], path[at + 1]]);
  const at = (/** @type {number} */ index) => points[Math.min(Math.max(index, 0), points.length - 1)];
  /** @type {Point[]} */
  const curve = [points[0]];
  for (let index = 0; index + 1 < points.length; index += 1) {
    const [before, from, to, after] = [at(index - 1), at(index), at(index + 1), at(index + 2)];
    for (let part = 1; part <= CURVE_POINTS; part += 1) {
      const t = part / CURVE_POINTS;
      const place = (/** @type {0 | 1} */ axis) => catmullRom(before[axis], from[axis], to[axis], after[axis], t);
      curve.push([place(0), place(1)]);
    }
  }
  return curve;
}

/**
 * The value at t, 0..1, between `from` and `to` of a Catmull-Rom spline.
 * @param {number} before
 * @param {number} from
 * @param {number} to
 * @param {number} after
 * @param {number} t
 */
function catmullRom(before, from, to, after, t) {
  const [start, end] = [(to - before) / 2, (after - from) / 2];
  return from + t * (start + t * (3 * (to - from) - 2 * start - end + t * (2 * (from - to) + start + end)));
}

export class ScenePainter {
  #context;
  #colours;
  #strokes;

  /**
   * Fills the canvas with the colour of the paper.
   * @param {CanvasRenderingContext2D} context of a square canvas
   * @param {Palette} colours
   * @param {Strokes} [strokes]
   */
  constructor(context, colours, strokes = FINE) {
    this.#context = context;
    this.#colours = colours;
    this.#strokes = strokes;
    const scale = context.canvas.width / SCENE_SIZE;
    context.setTransform(scale, 0, 0, -scale, 0, context.canvas.height);
    context.globalAlpha = 1;
    context.fillStyle = colours.paper;
    context.fillRect(0, 0, SCENE_SIZE, SCENE_SIZE);
    context.lineJoin = context.lineCap = "round";
  }

  /**
   * Draws a body, a goal hatched and the green object with a dot.
   * @param {{ role: Role, parts: Shape[] }} body
   * @param {number[]} pose
   * @param {boolean} [goal]
   */
  body({ role, parts }, [x, y, angle], goal = false) {
    const context = this.#context;
    const outline = outlineOf(parts);
    context.save();
    context.translate(x, y);
    context.rotate(angle);
    context.fillStyle = this.#colours[role];
    context.fill(outline);
    context.strokeStyle = this.#colours[role === "black" ? "rim" : role];
    const width = role === "black" ? this.#strokes.rim : this.#strokes.outline;
    context.lineWidth = width;
    // A width of 0 would be ignored.
    if (width > 0) context.stroke(outline);
    if (goal) this.#hatch(outline);
    if (role === "green") this.#dot(parts);
    context.restore();
  }

  /**
   * Draws the red ball.
   * @param {number} radius
   * @param {number[]} pose
   */
  ball(radius, [x, y, angle]) {
    const context = this.#context;
    context.save();
    context.translate(x, y);
    context.rotate(angle);
    this.#disc(0, 0, radius, this.#colours.red);
    context.beginPath();
    context.moveTo(radius * 0.35, 0);
    context.lineTo(radius * 0.75, 0);
    context.strokeStyle = this.#colours.paper;
    context.lineWidth = Math.max(radius * 0.12, 0.8);
    context.stroke();
    context.restore();
  }

  /**
   * Draws a line through points.
   * @param {Point[]} points
   * @param {{ colour: string, width: number, opacity?: number, dotted?: boolean }} style
   */
  line(points, { colour, width, opacity = 1, dotted = false }) {
    if (points.length < 2) return;
    const context = this.#context;
    context.beginPath();
    for (const [x, y] of points) context.lineTo(x, y);
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.globalAlpha = opacity;
    // The round caps make a dot of each dash.
    context.setLineDash(dotted ? [0.1, width * 2] : []);
    context.stroke();
    context.setLineDash([]);
    context.globalAlpha = 1;
  }

  /**
   * Draws a band round points, at each as wide as its radius says.
   * @param {Point[]} points
   * @param {number[]} radii px
   * @param {string} colour
   * @param {number} opacity
   */
  ribbon(points, radii, colour, opacity) {
    const context = this.#context;
    // One path, so that it is equally strong where its discs overlap.
    context.beginPath();
    points.forEach(([x, y], index) => {
      context.moveTo(x + radii[index], y);
      context.arc(x, y, radii[index], 0, 2 * Math.PI);
    });
    context.globalAlpha = opacity;
    context.fillStyle = colour;
    context.fill();
    context.globalAlpha = 1;
  }

  /**
   * Draws a full ring.
   * @param {Point} place
   * @param {number} radius
   */
  ring([x, y], radius) {
    const context = this.#context;
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    for (const [colour, width] of /** @type {[string, number][]} */ ([
      [this.#colours.ink, 5],
      [this.#colours.ring, 3.4],
    ])) {
      context.strokeStyle = colour;
      context.lineWidth = width;
      context.stroke();
    }
  }

  /** @param {Path2D} outline */
  #hatch(outline) {
    const context = this.#context;
    context.clip(outline);
    context.beginPath();
    for (let offset = -2 * SCENE_SIZE; offset < 2 * SCENE_SIZE; offset += this.#strokes.hatch) {
      context.moveTo(offset - SCENE_SIZE, -SCENE_SIZE);
      context.lineTo(offset + SCENE_SIZE, SCENE_SIZE);
    }
    context.globalAlpha = 0.55;
    context.strokeStyle = this.#colours.paper;
    context.lineWidth = this.#strokes.hatchWidth;
    context.stroke();
    context.globalAlpha = 1;
  }

  /**
   * The dot of the green object; off the centre of a ball, so that it shows how the ball rolls.
   * @param {Shape[]} parts
   */
  #dot([first]) {
    if ("circle" in first) this.#disc(0.4 * first.circle, 0, Math.max(0.26 * first.circle, 1.6), this.#colours.paper);
    else this.#disc(0, 0, 1.7, this.#colours.paper);
  }

  /**
   * @param {number} x
   * @param {number} y
   * @param {number} radius
   * @param {string} colour
   */
  #disc(x, y, radius, colour) {
    this.#context.beginPath();
    this.#context.arc(x, y, radius, 0, 2 * Math.PI);
    this.#context.fillStyle = colour;
    this.#context.fill();
  }
}

/**
 * All shapes of a body, in its own coordinates.
 * @param {import("../pkg/pathlight.js").Shape[]} parts
 */
function outlineOf(parts) {
  const outline = new Path2D();
  for (const part of parts) {
    if ("circle" in part) {
      outline.moveTo(part.circle, 0);
      outline.arc(0, 0, part.circle, 0, 2 * Math.PI);
    } else part.polygon.forEach(([x, y], index) => (index === 0 ? outline.moveTo(x, y) : outline.lineTo(x, y)));
    outline.closePath();
  }
  return outline;
}
