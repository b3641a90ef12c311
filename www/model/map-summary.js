// Reads any map of the scene: its value at a point, and its peak and spread in numbers. Knows nothing of the document;
// place-words.js says in words of the scene what a map shows.

import { CELL_SIZE, GRID_SIDE } from "../shell/constants.js";
import { text } from "../text/text.js";

/** @typedef {import("../pkg/pathlight.js").GridMap} GridMap */

/**
 * The value of a map at a point of the scene, px.
 * @param {GridMap} map
 * @param {readonly number[]} point
 */
export function valueAt(map, [x, y]) {
  /** @param {number} coordinate */
  const cell = (coordinate) => Math.min(Math.max(Math.floor(coordinate / CELL_SIZE), 0), GRID_SIDE - 1);
  return map[cell(y) * GRID_SIDE + cell(x)];
}

/**
 * A map in numbers: where its peak is, and how it is spread left and right.
 * @param {GridMap} map
 */
export function summary(map) {
  const peak = map.reduce((best, value, cell) => (value > map[best] ? cell : best), 0);
  const [x, y] = [peak % GRID_SIDE, Math.floor(peak / GRID_SIDE)].map((cell) => cell * CELL_SIZE + CELL_SIZE / 2);
  return text.model.map.strongest(x, y, sides(map));
}

/**
 * How much of a map lies left and right, in words.
 * @param {GridMap} map
 */
export function sides(map) {
  const total = map.reduce((sum, value) => sum + value, 0);
  const left = map.reduce((sum, value, cell) => sum + (cell % GRID_SIDE < GRID_SIDE / 2 ? value : 0), 0);
  const percent = total ? Math.round((100 * left) / total) : 50;
  return text.model.map.sides(percent, 100 - percent);
}
