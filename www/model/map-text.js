// The steps of the story in words: what each map means and how its net makes it, and how a model that imagines balls
// chooses one. Knows nothing of the document.

/** @typedef {import("../pkg/pathlight.js").MapName} MapName */

/**
 * For each map its name, what it means, and how it is made.
 * @type {Record<MapName, { name: string, meaning: string, how: string }>}
 */
export const MAP_TEXT = {
  base: {
    name: "Base path",
    meaning: "Where the green object goes if nothing is done.",
    how: "Its net sees only the scene, as five pictures of 64 × 64 cells, one for each colour. For every cell it says how sure it is that the green object passes there.",
  },
  target: {
    name: "Target path",
    meaning: "Where it should go to reach its goal.",
    how: "Its net sees only the scene too. It has learned from solved puzzles which way the green object went there. It does not know the red ball yet.",
  },
  action: {
    name: "Action path",
    meaning: "Where the red ball should go to bring that about.",
    how: "Its net sees the scene, the base path and the target path: what would happen, and what should. The difference is what the red ball has to do.",
  },
  placement: {
    name: "Placement",
    meaning: "Where the red ball should start.",
    how: "Its net sees the scene, the target path and the action path. In the paper, balls that cover much of this map are tried first. A model with a net that scores balls tries the likeliest first.",
  },
  success: {
    name: "Success",
    meaning: "Where a ball is likely to solve the puzzle.",
    how: "The paper has no such map. For eight sizes of ball at every place it says how likely one solves the puzzle, and shows the best size.",
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
    how: "The dynamics net has learned from balls of all kinds what they lead to. Before it imagines any ball, it says for eight sizes at every place how likely one solves the puzzle. The most promising balls are candidates.",
  },
  imagined: {
    name: "Imagined",
    meaning: "What each of these balls would do.",
    how: "The same net imagines for each ball where the green object and the ball would go, and reads from that how likely the ball solves the puzzle. The chance that it gave the place before counts as much. Around the likeliest balls it also imagines those one px away, and keeps the likelier. Nothing is simulated.",
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
    intro: `Before anything moves, ${count} small nets imagine, one after the other${ballNet ? `, and ${ballNet.intro}` : ""}:`,
    about:
      `It has ${count} small neural nets. Each is a long list of numbers that turns pictures into a picture: the scene goes in, with what the nets before it have imagined, and out comes a map that says for every place how likely the ball is to pass there. ${ballNet?.about ?? ""}`.trim(),
    how: ballNet?.how ?? "",
  };
}

const NUMBERS = ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine"];
