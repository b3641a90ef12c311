// What is said of the model: what it and its nets do, what it imagines, and what goes wrong with it.

import { counted, number, percent } from "./format.js";
import { upper } from "../sentence.js";

/** @typedef {keyof typeof CHANCES} Chance */
/** @typedef {"dynamics" | "success"} BallNet a net that scores balls */
/** @typedef {import("../../pkg/pathlight.js").ModelCard} Card */
/** @typedef {Exclude<keyof Card, "tasks">} CardEntry */

const CHANCES = {
  none: "almost surely won’t work",
  little: "probably won’t work",
  less: "may not work",
  even: "could go either way",
  more: "may work",
  good: "probably works",
  full: "almost surely works",
};

const NUMBERS = ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine"];

/** @type {Record<BallNet, string>} */
const BALL_NETS = {
  dynamics:
    "The last one, the dynamics net, imagines where the green object and the ball would go, and how likely the ball is to solve the puzzle.",
  success: "The last one, the success net, says for every place how likely a ball there is to solve the puzzle.",
};

export const model = {
  /** How likely a ball solves the puzzle; the share is in words. */
  chance: (/** @type {Chance} */ chance, /** @type {string} */ share) => `${CHANCES[chance]} (chance ${share})`,
  hardlyAny: () => `under ${percent(0.01)}`,
  nearlyAll: () => `over ${percent(0.99)}`,
  off: (/** @type {number} */ distance) => `Its path for green was ${number(distance)} px off, on average.`,

  map: {
    /** @type {(x: number, y: number, sides: string) => string} */
    strongest: (x, y, sides) => `strongest at x ${x}, y ${y}; ${sides}`,
    sides: (/** @type {number} */ left, /** @type {number} */ right) =>
      `${left} percent on the left, ${right} on the right`,
  },

  /** The steps of the story: those of the maps, then how a model that imagines balls chooses one. */
  steps: {
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
      how: "The paper has no such map. It says for eight sizes of ball at every place how likely such a ball solves the puzzle, and shows the best size.",
    },
    imagined: {
      name: "Forty futures",
      meaning:
        "Each line is a possible path of green, each with a different ball. The stronger the line, the better the odds.",
      how: "The dynamics net learned from balls of all kinds what happens after they drop. It says for eight sizes of ball at every place how likely such a ball solves the puzzle, and the most promising become candidates. For each candidate it imagines where green and the ball would go, and how likely that solves the puzzle. The forty likeliest are drawn. Nothing is simulated.",
    },
    run: {
      name: "Run and compare",
      meaning: "The model drops its favourite ball. Was its guess right?",
      how: "The ball runs in the same simulator as yours. The wider the ribbon around a dotted line, the less sure the model was of it. If the ball fails, the model learns from it: balls that start much like it, or for which it had imagined much the same, become less likely, and the likeliest of the rest is next.",
    },
  },

  /** Weights may have no net that scores balls; then its parts are left out. */
  nets: {
    /** @type {(paperNets: number, ballNet: BallNet | null) => string} */
    intro: (paperNets, ballNet) =>
      `Before anything moves, ${inWords(paperNets + (ballNet ? 1 : 0))} small nets imagine, one after the other${ballNet ? `: ${inWords(paperNets)} make maps, and the ${ballNet} net scores balls` : ""}.`,
    /** @type {(paperNets: number, ballNet: BallNet | null) => string} */
    about: (paperNets, ballNet) =>
      `It has ${inWords(paperNets + (ballNet ? 1 : 0))} small neural nets, each a long list of numbers. ${ballNet ? `${upper(inWords(paperNets))} of them` : "They"} turn pictures into maps: the scene goes in, with what the earlier nets have imagined, and a map comes out that says for every place how likely green or red is to be there.${ballNet ? ` ${BALL_NETS[ballNet]}` : ""}`,
    /** How they make the map that scores balls. */
    how: {
      dynamics:
        "The dynamics net makes it before it imagines single balls. It learned from balls of all kinds what happens after they drop.",
      success:
        "The success net makes it from the scene alone. It has learned from balls that solved puzzles and balls that did not. The likeliest ball is tried first, and balls much like one already tried come later.",
    },
  },

  /** What agents are called where their results stand. */
  agents: {
    online: "the model as it plays here: it learns from its attempts",
    dynamics: "the same without learning from its attempts",
    success: "the success net alone",
    paper: "the paper’s four nets alone",
    random: "random balls",
  },

  /** What kind of puzzles a model knows. */
  knows: { within: "knows all 25 kinds of puzzles", cross: "knows 20 of the 25 kinds of puzzles" },
  /** The same as a short name of the model. */
  kinds: { within: "Knows all 25 kinds", cross: "Knows 20 of 25 kinds" },
  /** Whether it was trained on a puzzle. */
  seen: "practised this one",
  /** If only the nets that make maps were. */
  seenByMaps: "only its maps practised this one",
  unseen: "new to the model",

  /**
   * How it was trained, as its card says.
   * @type {Record<CardEntry, { term: string, words: (value: any, card: Card) => string }>}
   */
  card: {
    samples: {
      term: "Learned from",
      words: (samples, { tasks }) => `${number(samples)} solutions of ${number(tasks)} puzzles`,
    },
    epochs: { term: "Looked at each", words: (epochs) => `${number(epochs)} times` },
    setup: {
      term: "Kinds of puzzles",
      words: (setup) =>
        setup === "within"
          ? "the same kinds that it is tested on, but other puzzles (“within”)"
          : "other kinds than those that it is tested on (“cross”)",
    },
    fold: {
      term: "Fold",
      words: (fold) => `${fold}, one of ten ways to split the puzzles into those to learn from and those to test on`,
    },
    batch: { term: "Batch size", words: (batch) => number(batch) },
    learning_rate: { term: "Learning rate (Adam)", words: (rate) => number(rate, 0, { maximumSignificantDigits: 6 }) },
    decay_epochs: { term: "Learning rate decays to zero over the last", words: (epochs) => `${number(epochs)} epochs` },
    without_dev: {
      term: "Dev tasks",
      words: (without) =>
        without ? "left out, to choose settings by them" : "learned from, like the other training puzzles",
    },
    mirror: { term: "Mirrored", words: (mirror) => (mirror ? "half of the time, left to right" : "never") },
    success: {
      term: "The success net learned from",
      words: ({ balls, epochs }) => `${number(balls)} balls with their outcome, ${number(epochs)} times over`,
    },
    dynamics: {
      term: "The dynamics net learned from",
      words: ({ balls, epochs, unlisted, random_scenes: random, random_scenes_alone: alone, from }) =>
        `${number(balls)} balls with their paths, in ${number(epochs)} passes over ${alone ? `${number(random)} random puzzles and no others` : "the puzzles"}${unlisted ? `, ${number(unlisted)} of them extra ones of the same kinds` : ""}${random && !alone ? `, ${number(random)} of them random` : ""}${from ? ", after an earlier training" : ""}`,
    },
    simulator: { term: "Version of the simulator", words: String },
    seed: { term: "Random seed", words: String },
  },

  outcomes: {
    first: "Its first idea works.",
    /** @type {(balls: number, solved: number, touched: number, missed: number) => string} */
    counted: (balls, solved, touched, missed) =>
      `Of ${counted(balls, "ball", "balls")}, ${counted(solved, "solves", "solve")} the puzzle, ${counted(touched, "gets", "get")} green to touch its goal for a while, and ${counted(missed, "never does", "never do")}.`,
  },

  results: {
    notLoaded: (/** @type {string} */ why, /** @type {string} */ address) =>
      `The results could not be loaded: ${why} for ${address}. Check the connection and try again.`,
    damaged: (/** @type {string} */ address) =>
      `The results are damaged: what ${address} holds is not JSON. Write it again by “pathlight-lab publish results”.`,
  },

  searchEnded: (/** @type {string} */ why) => `The search ended: ${why} Press the button to search again.`,

  worker: {
    startedAgain: "The model was started again.",
    notStarted: "The model has not been started.",
    other: "Another model was started.",
    stopped: (/** @type {string} */ why) => `The model has stopped${why ? ` (${why})` : ""}.`,
    /** @type {(framed: boolean) => string} */
    notLoaded: (framed) =>
      `The model’s worker could not be loaded. If Pathlight has been updated meanwhile, load the page again. ${
        framed
          ? "A frame with the attribute sandbox has to allow its own origin (allow-same-origin)."
          : "A page with a Content Security Policy has to allow workers (worker-src)."
      }`,
    /** @type {(code: string, message: string) => string} what the API says in English */
    failed: (code, message) => message,
  },
};

/** @param {number} count */
function inWords(count) {
  return NUMBERS[count] ?? number(count);
}
