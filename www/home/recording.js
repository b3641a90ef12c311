// What scripts/record-home.mjs has recorded of the first model, so that the home page shows what a model imagines
// before any weights are there: assets/home.json. Knows nothing of the document.

import { failure } from "../api/failure.js";
import { readFile } from "../api/files.js";

/** @typedef {import("../pkg/pathlight.js").Ball} Ball */
/** @typedef {import("../pkg/pathlight.js").Role} Role */
/** @typedef {import("../pkg/pathlight.js").Shape} Shape */

/**
 * A body at its start: x, y (px) and angle (radians).
 * @typedef {{ pose: number[], role: Role, parts: Shape[] }} RecordedBody
 */

/**
 * One task with its futures, the ball that the model picks, and what really becomes of it. Points are x, y, x, y, … in
 * px; a solved rollout ends when it is solved.
 * @typedef {object} RecordedScene
 * @property {string} task
 * @property {string} model
 * @property {number} simulator its version
 * @property {string} digest of the whole rollout, as in an attempt's line
 * @property {number} steps
 * @property {boolean} solved
 * @property {number} body1 the green object, as an index into `bodies`
 * @property {number} body2 its goal
 * @property {RecordedBody[]} bodies
 * @property {{ probability: number, path: number[] }[]} futures imagined paths of the green object, the likeliest first
 * @property {Ball} ball the one that the model picks
 * @property {{ steps: number[], object: number[], ball: number[], errors: number[], probability: number }} imagined for
 *   that ball: positions of the green object and of the ball after each of `steps`, and how far off the model expects
 *   those of the green object to be, then those of the ball
 * @property {{ bodies: number[], every: number, poses: number[][], touched: number }} real the poses of these bodies,
 *   one row for each `every` steps; `touched` is the step at which the last touch of object and goal begins
 * @property {number} miss mean distance of the green object from where it was imagined, px
 */

/**
 * `kinds`: by template, the path that the model imagines for the green object of its first task, from its start.
 * `paths`: the same, by task, for the easiest task of each template that is new to the model.
 * `unsolved`: by model, puzzles that it does not solve in a hundred attempts, the easiest first.
 * @typedef {{ scene: RecordedScene, kinds: Record<string, number[]>, paths: Record<string, number[]>,
 *   unsolved: Record<string, string[]> }} Recording
 */

const ADDRESS = new URL("../assets/home.json", import.meta.url);

/** @type {Promise<Recording> | null} */
let read = null;

/** Returns the recording. Nobody is told if it cannot be read: the page stands without it. */
export function readRecording() {
  read ??= readFile(ADDRESS, (reason) => failure("bad_data", `${reason}: ${ADDRESS}`))
    .then((bytes) => new Response(bytes).json())
    .catch((error) => {
      // The network may be back when it is asked for again.
      read = null;
      throw error;
    });
  return read;
}
