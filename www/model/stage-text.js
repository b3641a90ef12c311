// The stages in words: what each means and how its net makes it. Knows nothing of the document.

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
    how: "The fourth net sees the scene and the three paths. In the paper, balls that cover much of this map are tried first; a judge, where there is one, orders them otherwise.",
  },
  judge: {
    name: "Judge",
    meaning: "Where a ball is likely to solve the puzzle.",
    how: "A fifth net, which the paper does not have. It sees the scene alone, and has learned from balls that solved puzzles and balls that did not. It says of eight sizes of ball at every place how likely one solves; the map shows the best size. The likeliest ball is tried first, and balls like one that was tried wait.",
  },
};
