// The bodies of a custom scene in words and numbers, as a person reads them.

import { text } from "../text/text.js";
import { SIZES, sizeOf } from "./body-geometry.js";

/** @typedef {import("../pkg/pathlight.js").CustomScene} CustomScene */
/** @typedef {import("../pkg/pathlight.js").CustomBody} CustomBody */
/** @typedef {import("../pkg/pathlight.js").Body["role"]} Role */

/** Numbers that are typed are rounded to hundredths. */
const PLACES = 100;

/**
 * A body in words: its colour and shape, with its index where several are alike, as the checks name it.
 * @param {CustomScene} scene
 * @param {number} index
 */
export function nameOf(scene, index) {
  const role = roleOf(scene, index);
  const { shape } = scene.bodies[index];
  const alike = scene.bodies.filter((body, at) => body.shape === shape && roleOf(scene, at) === role);
  return text.editor.bodies.name({ role, shape }, alike.length > 1 ? index : null);
}

/**
 * A body with its numbers, in words.
 * @param {CustomScene} scene
 * @param {number | null} index null: no body
 */
export function wordsOf(scene, index) {
  const { none, described } = text.editor.bodies;
  if (index === null) return none;
  const body = scene.bodies[index];
  const place = { x: rounded(body.x), y: rounded(body.y), degrees: degreesOf(body) };
  /** @type {[import("./body-geometry.js").Size, number][]} */
  const sizes = SIZES[body.shape].map((size) => [size, rounded(sizeOf(body, size))]);
  return described(nameOf(scene, index), place, sizes, body.dynamic);
}

/**
 * The colour of a body, which says what it is there for.
 * @param {CustomScene} scene
 * @param {number} index
 * @returns {Role}
 */
export function roleOf({ body1, body2, bodies }, index) {
  const { dynamic } = bodies[index];
  if (index === body1) return "green";
  if (index === body2) return dynamic ? "blue" : "purple";
  return dynamic ? "gray" : "black";
}

/**
 * The angle of a body in degrees, 0 up to 360.
 * @param {CustomBody} body
 */
export function degreesOf({ angle }) {
  return wrapped(rounded((angle / Math.PI) * 180));
}

/** @param {number} degrees */
export function wrapped(degrees) {
  return ((degrees % 360) + 360) % 360;
}

/** @param {number} value */
export function rounded(value) {
  return Math.round(value * PLACES) / PLACES;
}
