// The constants that the page shares with the Rust code, which exports them, and the few that are the page's own. The
// wasm has to be loaded before this module: page/main.js imports the rest only then.

import { constants } from "../pkg/pathlight.js";

const shared = constants();

/** Width and height of the scene, px. */
export const SCENE_SIZE = shared.scene_size;
/** Cells of a map, across and up. */
export const GRID_SIDE = shared.grid_side;
/** Width of a cell, px of the scene. */
export const CELL_SIZE = shared.cell_size;
/** Attempts that each contender has on a puzzle. */
export const ATTEMPT_LIMIT = shared.attempt_limit;
/** Smallest and largest radius of the red ball, px. */
export const MIN_RADIUS = shared.min_radius;
export const MAX_RADIUS = shared.max_radius;
/** Simulated steps per second. */
export const STEPS_PER_SECOND = shared.steps_per_second;
/** How long the green object has to touch its goal, s. */
export const GOAL_SECONDS = shared.goal_steps / shared.steps_per_second;
/** The maps in the order in which the nets make them. */
export const STAGES = shared.stages;
/** Those that the paper's nets make; every model has them. */
export const PAPER_STAGES = shared.paper_stages;

/** The version of the simulator; those of other versions may end otherwise. */
export const SIMULATOR_VERSION = shared.simulator_version;
/** The version of the agents; the same model proposes other balls with another. */
export const AGENTS_VERSION = shared.agents_version;

/** Initial radius of a ball, px. */
export const FIRST_RADIUS = 12;
