// The puzzles of the home page. tests/page/home-recording.test.mjs holds what is said of them here.

/**
 * The puzzle of the moving scene, and of the links beside it. It is new to the first model, which imagines it well and
 * misses it all the same: whoever plays it can win, and has not seen the answer.
 */
export const SCENE_TASK = "00013:193";
/** The puzzle of the introduction: easy, and new to every model that Pathlight comes with. */
export const FIRST_TASK = "00014:603";
/**
 * A puzzle of the kind at which memory helps most, of those that are new to the model that learns while a person
 * watches.
 */
export const LEARNT_TASK = "00015:014";
/** The puzzle that a person who makes one begins with. */
export const MADE_FROM = "00000:000";
