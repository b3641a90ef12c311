// Custom scenes as they are edited and kept: a puzzle as one, and a scene without anything else that its JSON may hold,
// with its keys in one order, so that equal scenes have equal JSON.

import { pathlight } from "../shell/page-api.js";
import { text } from "../text/text.js";
import { SIZES, sizeOf } from "./body-geometry.js";

/** @typedef {import("../pkg/pathlight.js").CustomScene} CustomScene */
/** @typedef {import("../pkg/pathlight.js").CustomBody} CustomBody */

/**
 * The scene of an open puzzle in the form in which it is edited.
 * @param {import("../play/session.js").Session} session
 * @returns {CustomScene}
 */
export function sceneOf({ puzzle, name }) {
  return typeof puzzle === "string" ? { ...pathlight.customScene(puzzle), name: text.puzzles.edited(name) } : puzzle;
}

/**
 * @param {CustomScene} scene one that may be played
 * @returns {CustomScene}
 */
export function plainScene({ version, name, body1, body2, bodies }) {
  return { version, ...(name ? { name } : {}), body1, body2, bodies: bodies.map(plainBody) };
}

/** @param {CustomBody} body */
function plainBody(body) {
  const { shape, x, y, angle, dynamic } = body;
  const sizes = Object.fromEntries(SIZES[shape].map((size) => [size, sizeOf(body, size)]));
  return /** @type {CustomBody} */ ({ shape, ...sizes, x, y, angle, dynamic });
}
