// An own scene without anything else that its JSON may hold, with its keys in one order, so that equal scenes have
// equal JSON.

import { SIZES, sizeOf } from "./body-geometry.js";

/** @typedef {import("../pkg/pathlight.js").OwnScene} OwnScene */
/** @typedef {import("../pkg/pathlight.js").OwnBody} OwnBody */

/**
 * @param {OwnScene} scene one that may be played
 * @returns {OwnScene}
 */
export function plainScene({ version, name, body1, body2, bodies }) {
  return { version, ...(name ? { name } : {}), body1, body2, bodies: bodies.map(plainBody) };
}

/** @param {OwnBody} body */
function plainBody(body) {
  const { shape, x, y, angle, dynamic } = body;
  const sizes = Object.fromEntries(SIZES[shape].map((size) => [size, sizeOf(body, size)]));
  return /** @type {OwnBody} */ ({ shape, ...sizes, x, y, angle, dynamic });
}
