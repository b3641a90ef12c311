// The task whose scene every implementation is given.
export const TASK = "00007:008";

/** Balls are proposed for both in turns: what was imagined for a scene is kept until the next. */
export const OTHER_TASK = "00002:017";
