// Places in a scene, in words of the scene: "just above the left slope". For people who hear a map instead of seeing
// it, and for whoever wants to say where a map points. Knows nothing of the document.

import { CELL_SIZE, GRID_SIDE, SCENE_SIZE } from "../shell/constants.js";
import { text } from "../text/text.js";

/** @typedef {import("../pkg/pathlight.js").Scene} Scene */
/** @typedef {import("../pkg/pathlight.js").Body} Body */
/** @typedef {import("../pkg/pathlight.js").GridMap} GridMap */
/** @typedef {[x: number, y: number]} Point px of the scene */
/** @typedef {import("../text/en/places.js").Named} Named */

/** Distance from a body within which a place is "just" beside it, px. */
const JUST = 8;
/** Farther from every body than this, the place is told by its part of the scene, px. */
const NEAR = 36;
/** A cell is strong from this fraction of the peak on. */
const STRONG = 0.6;
/** Least distance from the peak at which another strong place is worth telling, px. */
const APART = 64;
/** Bars that are less tilted than this lie, those that are less than this from upright stand, radians. */
const LYING = 0.12;

/**
 * A map in words: where the model is most sure, and another place where it is sure too.
 * @param {GridMap} map
 * @param {Scene} scene
 */
export function mapWords(map, scene) {
  const names = bodyNames(scene);
  const peak = map.reduce((best, value, cell) => (value > map[best] ? cell : best), 0);
  const at = centreOf(peak);
  const distance = (/** @type {number} */ cell) => Math.hypot(centreOf(cell)[0] - at[0], centreOf(cell)[1] - at[1]);
  let far = peak;
  map.forEach((value, cell) => {
    if (value >= STRONG * map[peak] && distance(cell) > distance(far)) far = cell;
  });
  const [first, second] = [at, centreOf(far)].map((point) => placeWords(point, scene, names));
  return text.places.map(first, distance(far) >= APART && first !== second ? second : null);
}

/**
 * A place in words: beside which body it is, or in which part of the scene.
 * @param {Point} point
 * @param {Scene} scene
 * @param {Named[]} [names] of the bodies
 */
export function placeWords([x, y], scene, names = bodyNames(scene)) {
  let nearest = { distance: Infinity, dx: 0, dy: 0, index: -1 };
  scene.bodies.forEach((body, index) => {
    const found = awayFrom(body, [x, y]);
    if (found.distance < nearest.distance) nearest = { ...found, index };
  });
  const { distance, dx, dy, index } = nearest;
  if (distance <= 0) return text.places.beside("on", false, names[index]);
  if (distance < NEAR) {
    const side = Math.abs(dy) >= Math.abs(dx) ? (dy > 0 ? "above" : "below") : dx > 0 ? "right" : "left";
    return text.places.beside(side, distance < JUST, names[index]);
  }
  const third = (/** @type {number} */ coordinate) =>
    /** @type {0 | 1 | 2} */ (Math.min(Math.floor((3 * coordinate) / SCENE_SIZE), 2));
  return text.places.part(third(x), third(y));
}

/**
 * What tells each body from the others: its kind and colour, and where it is among those alike. "green ball", "left
 * slope", "upper bar".
 * @param {Scene} scene
 * @returns {Named[]}
 */
export function bodyNames({ bodies, body1, body2 }) {
  const names = bodies.map((body, index) => ({
    kind: kindOf(body),
    role: index === body1 || index === body2 || body.dynamic ? body.role : null,
  }));
  return names.map(({ kind, role }, index) => {
    const alike = bodies.filter((_, other) => names[other].kind === kind && names[other].role === role);
    return { kind, role, among: alike.length > 1 ? placeAmong(bodies[index], alike) : null };
  });
}

/**
 * @param {Body} body
 * @returns {import("../text/en/places.js").Kind}
 */
function kindOf({ shape, angle, dynamic }) {
  if (shape === "standing_sticks") return "sticks";
  if (shape !== "bar") return shape;
  const tilt = Math.abs(Math.atan(Math.tan(angle)));
  if (tilt > Math.PI / 2 - LYING) return "upright";
  return tilt > LYING && !dynamic ? "slope" : "bar";
}

/**
 * Where a body is among others, along the axis along which they are spread.
 * @param {Body} body
 * @param {Body[]} alike
 */
function placeAmong(body, alike) {
  /** @type {(axis: "x" | "y") => number} */
  const spread = (axis) => Math.max(...alike.map((one) => one[axis])) - Math.min(...alike.map((one) => one[axis]));
  const axis = spread("x") >= spread("y") ? "x" : "y";
  const place = alike.toSorted((one, other) => one[axis] - other[axis]).indexOf(body);
  return /** @type {const} */ ({ axis, place, count: alike.length });
}

/**
 * The distance of a point from a body's outline, px, negative inside; and the way from the outline to the point.
 * @param {Body} body
 * @param {Point} point
 */
function awayFrom(body, [x, y]) {
  const [cos, sin] = [Math.cos(body.angle), Math.sin(body.angle)];
  const local = /** @type {Point} */ ([
    cos * (x - body.x) + sin * (y - body.y),
    cos * (y - body.y) - sin * (x - body.x),
  ]);
  const found = body.parts.map((part) =>
    "circle" in part ? fromCircle(local, part.circle) : fromPolygon(local, part.polygon),
  );
  const {
    distance,
    away: [u, v],
  } = found.reduce((best, one) => (one.distance < best.distance ? one : best));
  return { distance, dx: cos * u - sin * v, dy: sin * u + cos * v };
}

/**
 * @param {Point} point
 * @param {number} radius
 */
function fromCircle(point, radius) {
  return { distance: Math.hypot(...point) - radius, away: point };
}

/**
 * @param {Point} point
 * @param {Point[]} corners counter-clockwise
 */
function fromPolygon([x, y], corners) {
  let nearest = { distance: Infinity, away: /** @type {Point} */ ([0, 0]) };
  let inside = true;
  corners.forEach(([x1, y1], index) => {
    const [x2, y2] = corners[(index + 1) % corners.length];
    const [ex, ey] = [x2 - x1, y2 - y1];
    if (ex * (y - y1) - ey * (x - x1) < 0) inside = false;
    const along = Math.min(Math.max(((x - x1) * ex + (y - y1) * ey) / (ex * ex + ey * ey), 0), 1);
    const away = /** @type {Point} */ ([x - x1 - along * ex, y - y1 - along * ey]);
    const distance = Math.hypot(...away);
    if (distance < nearest.distance) nearest = { distance, away };
  });
  return inside ? { ...nearest, distance: -nearest.distance } : nearest;
}

/**
 * The middle of a cell, px.
 * @param {number} cell
 * @returns {Point}
 */
function centreOf(cell) {
  return [((cell % GRID_SIDE) + 0.5) * CELL_SIZE, (Math.floor(cell / GRID_SIDE) + 0.5) * CELL_SIZE];
}
