// Places in a scene, in words of the scene: "just above the left slope". For people who hear a map instead of seeing
// it, and for whoever wants to say where a map points. Knows nothing of the document.

import { CELL_SIZE, GRID_SIDE, SCENE_SIZE } from "../shell/constants.js";

/** @typedef {import("../pkg/pathlight.js").Scene} Scene */
/** @typedef {import("../pkg/pathlight.js").Body} Body */
/** @typedef {import("../pkg/pathlight.js").GridMap} GridMap */
/** @typedef {[x: number, y: number]} Point px of the scene */

/** So near a body a place is "just" beside it, px. */
const JUST = 8;
/** Farther from every body than this, the place is told by its part of the scene, px. */
const NEAR = 36;
/** A cell is strong from this fraction of the peak on. */
const STRONG = 0.6;
/** Another strong place is worth telling so far from the peak, px. */
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
  return distance(far) >= APART && first !== second ? `most sure ${first}, also sure ${second}` : `most sure ${first}`;
}

/**
 * A place in words: beside which body it is, or in which part of the scene.
 * @param {Point} point
 * @param {Scene} scene
 * @param {string[]} [names] of the bodies
 */
export function placeWords([x, y], scene, names = bodyNames(scene)) {
  let nearest = { distance: Infinity, dx: 0, dy: 0, index: -1 };
  scene.bodies.forEach((body, index) => {
    const found = awayFrom(body, [x, y]);
    if (found.distance < nearest.distance) nearest = { ...found, index };
  });
  const { distance, dx, dy, index } = nearest;
  if (distance <= 0) return `on the ${names[index]}`;
  if (distance < NEAR) {
    const direction = Math.abs(dy) >= Math.abs(dx) ? (dy > 0 ? "above" : "below") : dx > 0 ? "right of" : "left of";
    return `${distance < JUST ? "just " : ""}${direction} the ${names[index]}`;
  }
  const [across, up] = [x, y].map((coordinate) => Math.min(Math.floor((3 * coordinate) / SCENE_SIZE), 2));
  const height = ["low", "half way up", "high up"][up];
  return across === 1
    ? up === 1
      ? "in the middle"
      : `${height} in the middle`
    : `${height} on the ${across ? "right" : "left"}`;
}

/**
 * A name for each body, which tells those of one kind apart by where they are: "green ball", "left slope", "upper bar".
 * @param {Scene} scene
 */
export function bodyNames({ bodies, body1, body2 }) {
  const kinds = bodies.map((body, index) =>
    index === body1 || index === body2 || body.dynamic ? `${body.role} ${kindOf(body)}` : kindOf(body),
  );
  return kinds.map((kind, index) => {
    const alike = bodies.filter((_, other) => kinds[other] === kind);
    return alike.length > 1 ? distinct(kind, bodies[index], alike) : kind;
  });
}

/** @param {Body} body */
function kindOf({ shape, angle, dynamic }) {
  if (shape === "standing_sticks") return "sticks";
  if (shape !== "bar") return shape;
  const tilt = Math.abs(Math.atan(Math.tan(angle)));
  if (tilt > Math.PI / 2 - LYING) return "upright bar";
  return tilt > LYING && !dynamic ? "slope" : "bar";
}

/**
 * The name of a body that tells it from others of its kind.
 * @param {string} kind
 * @param {Body} body
 * @param {Body[]} alike
 */
function distinct(kind, body, alike) {
  /** @type {(axis: "x" | "y") => number} */
  const spread = (axis) => Math.max(...alike.map((one) => one[axis])) - Math.min(...alike.map((one) => one[axis]));
  const axis = spread("x") >= spread("y") ? "x" : "y";
  const place = alike.toSorted((one, other) => one[axis] - other[axis]).indexOf(body);
  const [first, middle, last] = axis === "x" ? ["left", "middle", "right"] : ["lower", "middle", "upper"];
  if (alike.length === 2) return `${place ? last : first} ${kind}`;
  if (alike.length === 3) return `${[first, middle, last][place]} ${kind}`;
  return `${ordinal(place + 1)} ${kind} from ${axis === "x" ? "the left" : "below"}`;
}

/** @param {number} number from 1 */
function ordinal(number) {
  const suffix = number % 100 > 10 && number % 100 < 14 ? "th" : (["th", "st", "nd", "rd"][number % 10] ?? "th");
  return `${number}${suffix}`;
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
