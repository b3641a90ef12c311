// The constants that the page shares with the Rust code.

/** Width and height of the scene, px. */
export const SCENE_SIZE = 256;
/** Cells of a map, across and up. */
export const GRID_SIDE = 64;
/** Width of a cell, px of the scene. */
export const CELL_SIZE = SCENE_SIZE / GRID_SIDE;
/** Attempts that each agent has on a puzzle. */
export const ATTEMPT_LIMIT = 100;
/** Smallest and largest radius of the red ball, px. */
export const MIN_RADIUS = 2;
export const MAX_RADIUS = 32;
/** Simulated steps per second. */
export const STEPS_PER_SECOND = 60;
/** How long the green object has to touch its goal, s. */
export const GOAL_SECONDS = 3;

/** The maps in the order in which the nets make them: the paper's four, then the judge's. */
export const STAGES = /** @type {const} */ (["base", "target", "action", "placement", "judge"]);
/** @typedef {typeof STAGES[number]} Stage */

/** Radius of a ball that nobody has sized yet, px. Ours alone: Rust does not need it. */
export const FIRST_RADIUS = 12;

/**
 * A ball in whole px: its centre, counted from the lower left corner, and its radius.
 * @typedef {[x: number, y: number, r: number]} Ball
 */
