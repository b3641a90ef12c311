// The stages in words: what each means, how its net comes to it, and what a map of it says to someone who
// does not see it. Knows nothing of the document.

/** Cells of a map, across and up. */
export const SIDE = 64;
/** px of the scene in a cell. */
export const CELL = 256 / SIDE;

/** For each stage its name, what it means, and how it is made. */
export const WORDS = {
  base: {
    name: "Base path",
    means: "Where the green object goes if nothing is done.",
    how: "The first net sees only the scene, as five pictures of 64 × 64 cells, one for each colour. For every cell it says how sure it is that the green object passes there.",
  },
  target: {
    name: "Target path",
    means: "Where it should go to reach its goal.",
    how: "The second net sees the scene too. It has learned from solved puzzles which way the green object went there. It does not know the red ball yet.",
  },
  action: {
    name: "Action path",
    means: "Where the red ball should go to bring that about.",
    how: "The third net sees the scene, the base path and the target path: what would happen, and what should. The difference is what the red ball has to do.",
  },
  placement: {
    name: "Placement",
    means: "Where the red ball should start.",
    how: "The fourth net sees the scene and the three paths. In the paper, balls that cover much of this map are tried first; a judge, where there is one, orders them otherwise.",
  },
  judge: {
    name: "Judge",
    means: "Where a ball is likely to solve the puzzle.",
    how: "A fifth net, which the paper does not have. It sees the scene alone, and has learned from balls that solved puzzles and balls that did not. It says of eight sizes of ball at every place how likely one solves; the map shows the best size. The likeliest ball is tried first, and balls like one that was tried wait.",
  },
};

/** The value of a map at a point of the scene, px. */
export function valueAt(map, [x, y]) {
  const cell = (coordinate) => Math.min(Math.max(Math.floor(coordinate / CELL), 0), SIDE - 1);
  return map[cell(y) * SIDE + cell(x)];
}

/** A map in words: where it is strongest, and how it lies left and right. */
export function summary(map) {
  const peak = map.reduce((best, value, cell) => (value > map[best] ? cell : best), 0);
  const [x, y] = [peak % SIDE, Math.floor(peak / SIDE)].map((cell) => cell * CELL + CELL / 2);
  return `strongest at x ${x}, y ${y}; ${sides(map)}`;
}

/** How much of a map lies left and right, in words. */
export function sides(map) {
  const all = map.reduce((sum, value) => sum + value, 0);
  const left = map.reduce((sum, value, cell) => sum + (cell % SIDE < SIDE / 2 ? value : 0), 0);
  const share = all ? Math.round((100 * left) / all) : 50;
  return `${share} percent on the left, ${100 - share} on the right`;
}
