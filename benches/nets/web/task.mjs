// The task whose scene every implementation is given.
export const TASK = "00007:008";
