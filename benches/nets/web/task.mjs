// The task whose scene every contender is given.
export const TASK = "00007:008";
