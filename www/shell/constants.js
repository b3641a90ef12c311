// The constants that the page shares with the Rust code, and the few that are the page's own.

import { GOAL_STEPS, STEPS_PER_SECOND } from "../pkg/constants.js";

export * from "../pkg/constants.js";

/** How long the green object has to touch its goal, s. */
export const GOAL_SECONDS = GOAL_STEPS / STEPS_PER_SECOND;
/** Initial radius of a ball, px. */
export const FIRST_RADIUS = 12;
