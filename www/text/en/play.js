// What `play/` says: the scene and its controls, attempts, the race, and the introduction.

import { counted, number, seconds } from "./format.js";
import { sentence } from "../sentence.js";
import { puzzles } from "./puzzles.js";

/** @typedef {import("../../pkg/pathlight.js").Author} Author */

/** @type {Record<Author, string>} */
const WHOSE = { player: "your", model: "the model’s" };

export const play = {
  run: { drop: "Drop it", run: "Run", pause: "Pause", replay: "Replay", goOn: "Go on" },
  skipQuiet: "Nothing moves: skip",
  time: (/** @type {number} */ time) => seconds(time),
  spokenTime: (/** @type {number} */ time) => `${number(time, 1)} seconds`,
  meter: (/** @type {number} */ time, /** @type {number} */ goal) => `${number(time, 1)} of ${goal} s`,
  spokenMeter: (/** @type {number} */ time, /** @type {number} */ goal) => `${number(time, 1)} of ${goal} seconds`,

  /** How an attempt ended, as a phrase. */
  ending: {
    solved: (/** @type {string} */ time) => `solved after ${time}`,
    never: "never touched",
    touching: (/** @type {string} */ time) => `touching for ${time} when time ran out`,
    lost: (/** @type {string} */ time) => `touched for ${time}, then lost`,
    moment: "a moment",
  },

  status: {
    watched: "That was the scene without a ball.",
    watching: "The scene without a ball.",
    tries: (/** @type {number} */ attempt) => `The model tries: attempt ${attempt}.`,
    /** @type {(author: Author | "file", attempt: number, preview: boolean) => string} */
    named: (author, attempt, preview) =>
      author === "file"
        ? "The opened attempt"
        : `${author === "player" ? "Your" : "The model’s"} ${preview ? "ball" : "attempt"} ${attempt}`,
    running: (/** @type {string} */ named) => `${named} is running.`,
    solved: (/** @type {string} */ named, /** @type {string} */ ending) => `Solved! ${named}: ${ending}.`,
    /** @type {(named: string, ending: string, still: boolean) => string} */
    missed: (named, ending, still) => `Not solved. ${named}: ${ending}${still ? "; everything lies still" : ""}.`,
    closest: (/** @type {number} */ gap, /** @type {number} */ time) =>
      time < 0.05 ? "never got closer" : `missed by ${number(gap, gap < 9.95 ? 1 : 0)} px, at ${seconds(time)}`,
    line: "Draw the path that the green object will take.",
    bodies: "Drag a body, or a knob of the selected one.",
    noBall: "Click or tap the scene to place the red ball.",
    notHere: (/** @type {string} */ why) => `Not here: ${why}.`,
    ready: "Ready. Drop it!",
  },

  /** Why a ball may not be placed, as a phrase. */
  invalid: {
    overlaps: (/** @type {import("./puzzles.js").NamedBody} */ body) => `the ball overlaps the ${puzzles.body(body)}`,
    outside: "too close to the edge",
    radius: "the radius of the ball must be between 2 and 32 px",
  },

  refusal: {
    invalid: (/** @type {string} */ why) => `${sentence(why)} That does not count as an attempt.`,
    limit: (/** @type {number} */ limit) =>
      `All ${limit} attempts are used: clear them to begin again. That does not count as an attempt.`,
    noPrediction: "Draw your prediction first: the path of the green object.",
    noBall: "Place the ball first: click or tap in the scene, or press an arrow key there.",
  },

  /** Attempts over each other. */
  pair: {
    solved: "Solved!",
    missed: "Not solved.",
    both: "Both solved it.",
    neither: "Neither solved it.",
    player: "You solved it, the model did not.",
    model: "The model solved it, you did not.",
    /** @type {(author: Author, attempt: number, dashed: boolean, ending: string) => string} */
    result: (author, attempt, dashed, ending) =>
      `${WHOSE[author]} attempt ${attempt}${dashed ? " (dashed)" : ""}: ${ending}`,
    /** @type {(first: [Author, number], second: [Author, number]) => string} */
    running: (first, second) =>
      `${WHOSE[first[0]]} attempt ${first[1]} and ${WHOSE[second[0]]} attempt ${second[1]}, over each other; the second is dashed`,
    /** @type {(author: Author, attempt: number) => string} */
    alone: (author, attempt) =>
      `${WHOSE[author]} attempt ${attempt}; ${author === "player" ? "the model has" : "you have"} made none`,
  },

  /** Player and model compared; the numbers are those of the attempts that solved, or how many were made. */
  verdict: {
    playerQuicker: (/** @type {number} */ you, /** @type {number} */ it) =>
      `You solved it on attempt ${you}, the model on attempt ${it}. You were quicker.`,
    modelQuicker: (/** @type {number} */ you, /** @type {number} */ it) =>
      `The model solved it on attempt ${it}, you on attempt ${you}. The model was quicker.`,
    draw: (/** @type {number} */ at) => `You and the model both solved it on attempt ${at}. A draw.`,
    modelNext: (/** @type {number} */ you) => `You solved it on attempt ${you}. The model has not had its turn.`,
    modelMissed: (/** @type {number} */ you, /** @type {number} */ made) =>
      `You solved it on attempt ${you}. The model has not, in ${counted(made, "attempt", "attempts")}.`,
    playerNext: (/** @type {number} */ it) => `The model solved it on attempt ${it}. Now you: you have not tried yet.`,
    playerMissed: (/** @type {number} */ it, /** @type {number} */ made) =>
      `The model solved it on attempt ${it}. You have not yet, in ${counted(made, "attempt", "attempts")}.`,
    nobody: "Nobody has tried yet.",
    neither: (/** @type {number} */ you, /** @type {number} */ it) =>
      `Not solved yet: ${counted(you, "attempt", "attempts")} by you, ${counted(it, "attempt", "attempts")} by the model.`,
  },

  attempts: {
    solved: (/** @type {number} */ at) => `solved on attempt ${at}`,
    missed: (/** @type {number} */ made, /** @type {number} */ limit) => `${made} of ${limit}, not solved`,
    replay: (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ r) =>
      `Replay: ball at x ${x}, y ${y}, radius ${r}`,
    compare: (/** @type {number} */ attempt) => `Compare attempt ${attempt}`,
    remove: (/** @type {number} */ attempt) => `Delete attempt ${attempt}`,
  },

  afterSolving: {
    title: (/** @type {number} */ at) => (at === 1 ? "Solved at the first attempt!" : `Solved in ${at} attempts!`),
    challenge: {
      asked: (/** @type {number} */ at) => `A challenge: somebody solved this puzzle ${within(at)}. Can you?`,
      beaten: (/** @type {number} */ at) => `You have beaten the challenge: it was solved ${within(at)}.`,
      equal: "You were as quick as the challenge.",
      missed: (/** @type {number} */ at) => `The challenge was solved ${within(at)}.`,
    },
  },

  guide: {
    watch: {
      words: (/** @type {number} */ time) =>
        `Get the green object to touch its striped goal for ${time} seconds. First watch what happens without help.`,
      button: "Watch",
    },
    watching: { words: () => "Nobody helps. Watch the green object.", button: null },
    guess: {
      words: () => "Alone, it never gets there. Add one red ball: where would it help? Click or tap there.",
      button: null,
    },
    blocked: { words: () => "The ball needs a free spot.", button: null },
    drop: {
      words: () =>
        "It fits there. The dotted line is the model’s guess for your ball. Move the ball until you like it, then drop it.",
      button: "Drop it",
    },
    dropped: { words: () => "Now nobody touches anything.", button: null },
    missed: {
      words: () =>
        "Not yet: most attempts end like this. Move the ball and drop it again, or see how the model does it.",
      button: "Race the model",
    },
    solved: { words: () => "Solved! Does the model need fewer attempts than you?", button: "Race the model" },
    race: {
      words: () => "The model tries its own balls on the same puzzle. Whoever needs fewer attempts wins.",
      button: "Done",
    },
  },
  guideCount: (/** @type {number} */ step, /** @type {number} */ steps) => `${step} of ${steps}`,

  panel: {
    next: "Next puzzle",
    share: "Share",
    nextBy: "Next:",
    similar: "similar",
    harder: "harder",
    easier: "easier",
    race: "You against the model",
    you: "You",
    model: "The model",
    skip: "Skip to the result",
    raceIt: "Race it",
    remembers: "The model remembers",
    forget: "Forget",
    score:
      "The fewer attempts, the more points: a puzzle solved on the first attempt gives 100, on the second 85, on the tenth 50; one not solved within 100 attempts gives none. The points are the mean over all puzzles that both of you have played. Balls that may not be placed do not count for either of you. This is the benchmark’s AUCCESS: the share of puzzles solved within k attempts, with each k from 1 to 100 weighted by ln(k + 1) − ln(k).",
    dotted: "What are the dotted lines?",
    dottedHow:
      "The model’s guess: where this ball and green would go, before anything moves. The wider the ribbon around a line, the less sure the model is. It is a guess, not a simulation, so it can be wrong: drop the ball and see how far off it was.",
    radius: "Radius",
    placements: "Placements",
    undo: "Undo",
    redo: "Redo",
    hint: `Tap or click the scene to place the ball; drag it to move it, drag its knob<span class="with-mouse"> or turn the wheel</span> for its size. <span class="with-mouse">With keys: arrows, <kbd>+</kbd> and <kbd>−</kbd>.</span>`,
    watch: "Watch without a ball",
    yourAttempts: "Your attempts",
    modelAttempts: "The model’s",
    luck: "Luck or plan?",
  },
};

/** @param {number} attempts */
function within(attempts) {
  return attempts === 1 ? "at the first attempt" : `in ${attempts} attempts`;
}
