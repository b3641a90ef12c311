// The steps of the story in words: what each stage means and how its net makes it, and how a model that imagines balls
// chooses one. Knows nothing of the document.

/** @typedef {import("../pkg/pathlight.js").Stage} Stage */

/**
 * For each stage its name, what it means, and how it is made.
 * @type {Record<Stage, { name: string, meaning: string, how: string }>}
 */
export const STAGE_TEXT = {
  base: {
    name: "Base path",
    meaning: "Where the green object goes if nothing is done.",
    how: "The first net sees only the scene, as five pictures of 64 × 64 cells, one for each colour. For every cell it says how sure it is that the green object passes there.",
  },
  target: {
    name: "Target path",
    meaning: "Where it should go to reach its goal.",
    how: "The second net sees the scene too. It has learned from solved puzzles which way the green object went there. It does not know the red ball yet.",
  },
  action: {
    name: "Action path",
    meaning: "Where the red ball should go to bring that about.",
    how: "The third net sees the scene, the base path and the target path: what would happen, and what should. The difference is what the red ball has to do.",
  },
  placement: {
    name: "Placement",
    meaning: "Where the red ball should start.",
    how: "The fourth net sees the scene and the three paths. In the paper, balls that cover much of this map are tried first; the later nets, where there are any, order them otherwise.",
  },
  judge: {
    name: "Judge",
    meaning: "Where a ball is likely to solve the puzzle.",
    how: "A fifth net, which the paper does not have. It sees the scene alone, and has learned from balls that solved puzzles and balls that did not. It says of eight sizes of ball at every place how likely one solves; the map shows the best size. If no other net imagines what balls do, the likeliest ball is tried first, and balls like one that was tried wait.",
  },
};

/**
 * The same for the steps by which a model that imagines balls chooses one, and sees what comes of it.
 * @type {Record<import("../state/url-state.js").ChoiceStep, { name: string, meaning: string, how: string }>}
 */
export const CHOICE_TEXT = {
  candidates: {
    name: "Candidates",
    meaning: "Which balls are worth thinking about.",
    how: "The fifth net has learned from balls of all kinds what they led to. Before it imagines any ball, it says for eight sizes at every place how likely one solves the puzzle. That picks the most promising balls.",
  },
  imagined: {
    name: "Imagined",
    meaning: "What each of these balls would do.",
    how: "The same net imagines for each ball where the green object and the ball would go, and reads from that how likely the ball solves the puzzle. What it said of the place before counts as much. Around the likeliest it also imagines balls one px away, and keeps the likelier. Nothing is simulated.",
  },
  chosen: {
    name: "Chosen",
    meaning: "The likeliest ball is tried first.",
    how: "If it fails, the model has seen how things really went. Balls that start much like it, and those for which it had imagined much the same, become less likely; the others stay, and the likeliest of those left is next.",
  },
  run: {
    name: "Run",
    meaning: "Now the ball really runs.",
    how: "It runs in the same simulator as your balls. The dotted lines were imagined before anything moved; the solid ones are what happens.",
  },
  real: {
    name: "Imagined and real",
    meaning: "What was imagined, over what really happened.",
    how: "Dotted: the paths that the model imagined for this ball. Solid: its real path and that of the green object. The wider the ribbon around a dotted line, the less sure the model was of it.",
  },
};
