// The steps of the story in words: what each map means and how its net makes it, and how a model that imagines balls
// chooses one. Knows nothing of the document.

/** @typedef {import("../pkg/pathlight.js").MapName} MapName */

/**
 * For each map its name, what it means, and how it is made.
 * @type {Record<MapName, { name: string, meaning: string, how: string }>}
 */
export const MAP_TEXT = {
  base: {
    name: "If you do nothing",
    meaning: "Where green goes by itself.",
    how: "The base path. Its net sees only the scene, as five pictures of 64 × 64 cells, one for each colour. For every cell it says how sure it is that green passes there.",
  },
  target: {
    name: "Where green should go",
    meaning: "A path for green that ends at its goal.",
    how: "The target path. Its net sees only the scene too. It learned from solved puzzles which way green went there. It does not know the red ball yet.",
  },
  action: {
    name: "What red must do",
    meaning: "A path for the red ball that makes green go there.",
    how: "The action path. Its net sees the scene, the base path and the target path: what would happen, and what should. The difference is what the red ball has to do.",
  },
  placement: {
    name: "Where to start",
    meaning: "Where the red ball should start.",
    how: "The placement. Its net sees the scene, the target path and the action path. In the paper, balls that cover much of this map are tried first. A model with a net that scores balls tries the likeliest first.",
  },
  success: {
    name: "Where it would work",
    meaning: "Where a red ball is likely to solve the puzzle.",
    how: "The paper has no such map. For eight sizes of ball at every place it says how likely one solves the puzzle, and shows the best size.",
  },
};

/**
 * The same for the steps of the story: those of the maps, then how a model that imagines balls chooses one.
 * @type {Record<import("../state/url-state.js").Step, { name: string, meaning: string, how: string }>}
 */
export const STEP_TEXT = {
  ...MAP_TEXT,
  imagined: {
    name: "Forty futures",
    meaning: "Each line is a future for green with another ball. The stronger the line, the better the odds.",
    how: "The dynamics net learned from balls of all kinds what they lead to. It says for eight sizes at every place how likely a ball solves the puzzle, and the most promising become ideas. For each idea it imagines where green and the ball would go, and how likely that is a solution. The forty likeliest are drawn. Nothing is simulated.",
  },
  run: {
    name: "Run and compare",
    meaning: "The model drops its favourite ball. Was its guess right?",
    how: "The ball runs in the same simulator as yours. The wider the ribbon around a dotted line, the less sure the model was of it. If the ball fails, the model has learned from it: balls that start much like it, or that it had imagined much the same, become less likely, and the likeliest of the others is next.",
  },
};

/**
 * The nets that score balls, by the entry of the model's card: what the panel Imagine and the sheet “About Pathlight”
 * say of them, and how they make their map.
 */
const BALL_NETS = /** @type {const} */ ({
  dynamics: {
    intro: "the dynamics net scores balls",
    about:
      "Another net, the dynamics net, imagines where the green object and the ball would go, and how likely the ball is to solve the puzzle.",
    how: "The dynamics net makes it before it imagines single balls. It has learned from balls of all kinds what they lead to.",
  },
  success: {
    intro: "the success net scores balls",
    about: "Another net, the success net, says for every place how likely a ball there is to solve the puzzle.",
    how: "The success net makes it from the scene alone. It has learned from balls that solved puzzles and balls that did not. The likeliest ball is tried first, and balls like one that was tried wait.",
  },
});

/**
 * What is said of the nets of a model: in the panel Imagine, in the sheet “About Pathlight”, and of how they make the
 * map that scores balls. Weights may have no net that scores balls; then its parts are left out.
 * @param {{ dynamics?: object, success?: object } | undefined} card of the loaded model
 * @param {number} paperNets the number of the paper's nets
 */
export function netWords(card, paperNets) {
  const ballNet = card?.dynamics ? BALL_NETS.dynamics : card?.success ? BALL_NETS.success : null;
  const count = NUMBERS[paperNets] ?? String(paperNets);
  return {
    intro: `Before anything moves, ${count} small nets imagine, one after the other${ballNet ? `, and ${ballNet.intro}` : ""}.`,
    about:
      `It has ${count} small neural nets. Each is a long list of numbers that turns pictures into a picture: the scene goes in, with what the nets before it have imagined, and out comes a map that says for every place how likely the ball is to pass there. ${ballNet?.about ?? ""}`.trim(),
    how: ballNet?.how ?? "",
  };
}

const NUMBERS = ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine"];
