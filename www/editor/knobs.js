// Draws over a scene that is being edited: the path of the green object alone, the outline and the knobs of the
// selected body, and marks on bodies that are in each other's way. In px of the scene, y up, as body-geometry.js.

import { SCENE_SIZE } from "../shell/constants.js";
import { extentOf, knobsOf } from "./body-geometry.js";

/** @typedef {import("../pkg/pathlight.js").CustomBody} CustomBody */

/** Radius of a knob, CSS px. */
const KNOB_RADIUS = 7;
/** How far the ring round the selected body is from it, px. */
const RING_GAP = 3;
/** Points on the path of the scene alone between two dots. */
const DOT_DISTANCE = 15;

/**
 * @typedef {object} Decoration
 * @property {CustomBody | null} selected
 * @property {CustomBody[]} troubled bodies that may not stay as they are
 * @property {Float32Array | null} path of the green object in the scene alone: x, y, x, y, …
 * @property {import("../pkg/pathlight.js").Palette} colours
 */

/**
 * @param {CanvasRenderingContext2D} context of a square canvas that shows the scene
 * @param {Decoration} decoration
 */
export function drawDecoration(context, { selected, troubled, path, colours }) {
  const scale = context.canvas.width / SCENE_SIZE;
  context.save();
  context.setTransform(scale, 0, 0, -scale, 0, context.canvas.height);
  context.globalAlpha = 1;
  /** A CSS px, in px of the scene. */
  const css = devicePixelRatio / scale;
  if (path) drawPath(context, path, colours, css);
  for (const body of troubled) drawRing(context, body, colours.red, [], 2 * css);
  if (selected) {
    drawRing(context, selected, colours.ink, [4 * css, 3 * css], 1.5 * css);
    const { size, turn } = knobsOf(selected, SCENE_SIZE);
    drawKnob(context, size, colours, css, false);
    if (turn) drawKnob(context, turn, colours, css, true);
  }
  context.restore();
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Float32Array} path
 * @param {import("../pkg/pathlight.js").Palette} colours
 * @param {number} css
 */
function drawPath(context, path, colours, css) {
  context.setLineDash([]);
  context.lineJoin = "round";
  for (const [colour, width] of /** @type {[string, number][]} */ ([
    [colours.paper, 4],
    [colours.green, 2],
  ])) {
    context.beginPath();
    for (let at = 0; at < path.length; at += 2) context.lineTo(path[at], path[at + 1]);
    context.strokeStyle = colour;
    context.lineWidth = width * css;
    context.stroke();
  }
  context.fillStyle = colours.green;
  for (let at = 0; at < path.length; at += 2 * DOT_DISTANCE) dot(context, path[at], path[at + 1], 2.4 * css);
  dot(context, path[path.length - 2], path[path.length - 1], 4 * css);
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {number} x
 * @param {number} y
 * @param {number} radius
 */
function dot(context, x, y, radius) {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
}

/**
 * A ring round a ball, a box round what is long.
 * @param {CanvasRenderingContext2D} context
 * @param {CustomBody} body
 * @param {string} colour
 * @param {number[]} dashes
 * @param {number} width
 */
function drawRing(context, body, colour, dashes, width) {
  context.beginPath();
  if (body.shape === "bar") {
    const [w, h] = [body.length / 2 + RING_GAP, body.thickness / 2 + RING_GAP];
    context.save();
    context.translate(body.x, body.y);
    context.rotate(body.angle);
    context.rect(-w, -h, 2 * w, 2 * h);
    context.restore();
  } else {
    const [sin, cos] = [Math.sin(body.angle), Math.cos(body.angle)];
    // The origin of a jar is the middle of its base.
    const up = body.shape === "jar" ? body.height / 2 : 0;
    const radius =
      (body.shape === "jar" ? extentOf({ ...body, height: body.height / 2 }) + body.height / 5 : extentOf(body)) +
      RING_GAP;
    context.arc(body.x - up * sin, body.y + up * cos, radius, 0, 2 * Math.PI);
  }
  context.setLineDash(dashes);
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.stroke();
  context.setLineDash([]);
}

/**
 * A round knob turns, a square one resizes.
 * @param {CanvasRenderingContext2D} context
 * @param {[x: number, y: number]} place
 * @param {import("../pkg/pathlight.js").Palette} colours
 * @param {number} css
 * @param {boolean} round
 */
function drawKnob(context, [x, y], colours, css, round) {
  const radius = KNOB_RADIUS * css;
  context.beginPath();
  if (round) context.arc(x, y, radius, 0, 2 * Math.PI);
  else context.rect(x - 0.85 * radius, y - 0.85 * radius, 1.7 * radius, 1.7 * radius);
  context.fillStyle = colours.paper;
  context.fill();
  context.strokeStyle = colours.ink;
  context.lineWidth = 1.5 * css;
  context.stroke();
}
