// The sheet "About Pathlight".

export const about = {
  idea: [
    "Pathlight is a game against a small AI that plans by imagining. Before a ball drops, four little neural nets draw where the green object goes by itself, where it should go, what red must do for that, and where red should start. A fifth imagines what any ball would lead to.",
    "Nothing you see of the model is made up: it thinks in your browser while you play. Then the simulator shows what really happens, to the bit as in the benchmark that the puzzles come from. Whatever you play stays on this device.",
  ],
  paper: "The paper: Solving Physics Puzzles by Reasoning about Paths (Harter and others, 2020)",
  phyre: "The puzzles: PHYRE, a benchmark for physical reasoning (Bakhtin and others, 2019)",
  keys: "Keys",
  keyList: [
    ["← ↑ → ↓", "move the ball; with Shift, farther"],
    ["+ -", "change its size"],
    ["Enter", "drop it, then go on"],
    ["Space", "pause or play"],
    [", .", "one step back or forward"],
    ["R", "try again"],
    ["Ctrl+Z Ctrl+Y", "undo, redo"],
    ["1 … 5", "the panels"],
    ["[ ]", "the puzzle before, and after"],
  ] as [keys: string, does: string][],
  source: "Source code and citation",
  cite: "Pathlight is open source, under the Apache License 2.0. Whoever uses it in research can cite it, and the work that it builds on.",
  citation: "How to cite it",
  licences: "Licences of all that is inside",
};
