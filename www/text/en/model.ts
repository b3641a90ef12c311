// Which model plays, and whether it was trained on the puzzle.

import type { Setup } from "../../pkg/page/pathlight.js";

export const model = {
  choose: "Model",
  names: {
    within: "Model A: knows all 25 kinds of puzzles",
    cross: "Model B: knows 20 of the 25 kinds",
  } satisfies Record<Setup, string>,
  short: { within: "Model A", cross: "Model B" } satisfies Record<Setup, string>,
  practised: "Careful: it trained on this very puzzle.",
  /** What is new to the model; the kind of a custom puzzle is unknown. */
  unseen: {
    within: "It has practised this kind, not this puzzle.",
    cross: "It has never seen this kind of puzzle.",
    custom: "It has never seen this puzzle.",
  },
};
