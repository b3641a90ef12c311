// The bodies of a custom scene in words and numbers, as a person reads them.

import { SIZES, sizeOf } from "./body-geometry.js";

/** @typedef {import("../pkg/pathlight.js").CustomScene} CustomScene */
/** @typedef {import("../pkg/pathlight.js").CustomBody} CustomBody */

/** Numbers that are typed are rounded to hundredths. */
const PLACES = 100;

/** @type {Record<CustomBody["shape"], string>} */
const SHAPE_NAMES = { ball: "ball", bar: "bar", jar: "jar", standing_sticks: "standing sticks" };

/**
 * A body in words: its colour and shape, with its index where several are alike, as the checks name it.
 * @param {CustomScene} scene
 * @param {number} index
 */
export function nameOf(scene, index) {
  const name = plainName(scene, index);
  const alike = scene.bodies.filter((_, at) => plainName(scene, at) === name).length;
  return alike > 1 ? `${name} (body ${index})` : name;
}

/**
 * A body with its numbers, in words.
 * @param {CustomScene} scene
 * @param {number | null} index null: no body
 */
export function wordsOf(scene, index) {
  if (index === null) return "Nothing is selected.";
  const body = scene.bodies[index];
  const name = nameOf(scene, index);
  const sizes = SIZES[body.shape].map((size) => `${size} ${rounded(sizeOf(body, size))}`);
  const numbers = [`x ${rounded(body.x)}`, `y ${rounded(body.y)}`, `turned by ${degreesOf(body)} degrees`, ...sizes];
  return `${name[0].toUpperCase()}${name.slice(1)}: ${numbers.join(", ")}, ${body.dynamic ? "moves" : "is fixed"}.`;
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

/**
 * @param {CustomScene} scene
 * @param {number} index
 */
function plainName({ body1, body2, bodies }, index) {
  const { shape, dynamic } = bodies[index];
  const colour =
    index === body1 ? "green" : index === body2 ? (dynamic ? "blue" : "purple") : dynamic ? "gray" : "black";
  return `${colour} ${SHAPE_NAMES[shape]}`;
}
