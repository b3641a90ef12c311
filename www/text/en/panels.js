// What `panels/` says: the panels Imagine, Predict and “Check the answer”, the race, and the model's balls one by one.

import { counted, number, percent } from "./format.js";

/** @typedef {import("../../pkg/pathlight.js").Author} Author */

/** @param {number} value */
const decimal = (value) => number(value, 2, { minimumFractionDigits: 0 });

export const panels = {
  about: (/** @type {string} */ name) => `The model “${name}”:`,

  choice: {
    none: "The model finds no ball to try.",
    choosing: "The model is choosing.",
    /** @type {(ideas: number, likely: number) => string} */
    ideas: (ideas, likely) =>
      `It considered ${counted(ideas, "ball", "balls")}, and gives ${likely ? number(likely) : "none"} of them a chance above 50%.`,
    running: "Dotted: what the model imagined. Dashed: what really happens.",
    /** @type {(solved: boolean, words: string) => string} */
    ended: (solved, words) => (solved ? words : `It did not work. ${words}`),
  },

  compare: {
    play: "Let the model play",
    stop: "Stop the model",
    played: "The model has played",
    trying: "trying …",
    notYet: "not yet",
    first: "You first: drop a ball.",
    stopRace: "Stop",
    again: "Watch it again",
    solved: (/** @type {number} */ at) => `✓ on attempt ${at}`,
    missed: (/** @type {number} */ used) => `not yet, ${counted(used, "attempt", "attempts")}`,
  },

  forecast: {
    loading: "The model is still loading.",
    guessing: "The model is guessing.",
    guess: (/** @type {string} */ chance) => `The model’s guess: ${chance}.`,
    /** @type {(chance: string, ...sentences: string[]) => string} */
    guessWas: (chance, ...sentences) => [`The model’s guess was: ${chance}.`, ...sentences].join(" "),
  },

  imagine: {
    loading: "Loading the model",
    play: "Play",
    pause: "Pause",
    all: "All",
    back: "Back",
    next: "Next",
    how: "How?",
    outlines: "Two maps are shaded over the scene; the others show only their outlines.",
    real: "Imagined and real",
    empty: `Drop a ball<span data-hideable="compare">, let the model play</span> or watch without a ball: then you see here how well the model imagined it.`,
    numbers: "What do the numbers mean?",
    numbersHow:
      "The shaded area is what was imagined; the outline is what really happened. 100% means that both are the same, 0% that they have nothing in common. It is the soft intersection over union on 64 × 64 cells: the smaller of the two values in each cell, added up, divided by the larger of the two, added up.",
    noMap: "this model has no such map",
    notYet: "not imagined yet",
    described: (/** @type {string} */ name, /** @type {string} */ words) => `${name}: ${words}`,
    inNumbers: (/** @type {string} */ summary) => `In numbers: ${summary}.`,
    took: (/** @type {number} */ milliseconds) => `Imagined in ${number(milliseconds)} ms.`,
  },

  imaginedVsReal: {
    green: "Green object",
    red: "Red ball",
    unknown: "unknown",
    /** @type {(title: string, green: string, red: string | null) => string} */
    run: (title, green, red) => `${title}: green object ${green}${red === null ? "" : `, red ball ${red}`}`,
    all: (/** @type {string[]} */ runs) => `As imagined – ${runs.join("; ")}.`,
    alone: "Without a ball",
    opened: "The opened attempt",
    ball: (/** @type {number} */ ball) => `The model’s ball ${ball}`,
    /** @type {(author: Author, attempt: number) => string} */
    attempt: (author, attempt) => `${author === "player" ? "Your" : "The model’s"} attempt ${attempt}`,
  },

  model: {
    nets: (/** @type {string} */ about) =>
      `${about} The panel Imagine shows all maps, and under “How?” what each net sees.`,
    named: (/** @type {string} */ name, /** @type {string} */ knows) => `${name} ${knows}.`,
  },

  modelPair: {
    playing: "Both models are playing.",
    noMap: "it has no such map",
    watch: (/** @type {number} */ ball) => `Watch its ball ${ball}`,
    solved: (/** @type {number} */ at) => `Solved on attempt ${at}.`,
    missed: (/** @type {number} */ attempts) => `Not solved in ${attempts} attempts.`,
    guess: (/** @type {string} */ chance) => `Its own guess for its first ball: ${chance}.`,
    neither: "Neither model solves this puzzle.",
    only: (/** @type {string} */ name) => `Only ${name} solves this puzzle.`,
    both: (/** @type {number} */ at) => `Both solve it on attempt ${at}.`,
    /** @type {(name: string, fewer: number, more: number) => string} */
    quicker: (name, fewer, more) => `${name} needs fewer attempts: ${fewer} instead of ${more}.`,
  },

  overlap: (/** @type {string} */ name, /** @type {number} */ share) =>
    `${name}, and a line round the real path: they overlap by ${percent(share)}`,

  /** The legend of the scene; `green` and `red`: the paths that the model imagines for a ball. */
  laid: { over: "Over the scene", green: "Green’s path, a guess", red: "Red’s path, a guess" },

  predict: {
    intro:
      "Which way will the green object go? Draw its path in the scene. Then run, and see who was closer: you or the model.",
    watch: "Run without a ball",
    run: "Run with the ball",
    wipe: "Erase",
    result: "Prediction and reality",
    measured: "How is it measured?",
    measuredHow:
      "Your line counts as if the green object had slid along it. The shaded path is laid over the real one, which is outlined: 100% means that both are the same. The model is measured in the same way: by its base path if there is no ball, by its target path if there is one. It has not seen your ball.",
    hint: "Draw with the mouse or a finger. With keys, in the scene: arrows draw on from the green object, with <kbd>Shift</kbd> further; <kbd>Backspace</kbd> takes a piece back.",
    ends: (/** @type {number} */ x, /** @type {number} */ y) =>
      `Your line ends at x ${number(x)}, y ${number(y)}. Ready? Run it.`,
    nothing: "Nothing drawn yet.",
    you: "You",
    model: "The model",
    alone: (/** @type {string} */ you) => `You were ${you} right.`,
    draw: (/** @type {string} */ both) => `A draw: both were ${both} right.`,
    player: (/** @type {string} */ you, /** @type {string} */ it) => `You were closer: ${you}, the model ${it}.`,
    modelCloser: (/** @type {string} */ you, /** @type {string} */ it) => `The model was closer: ${it}, you ${you}.`,
  },

  proposals: {
    back: "Previous ball",
    next: "Next ball",
    which: "Which of the model’s balls",
    other: "Next different result",
    hint: "The model has up to a hundred balls ready. Step through them and see where each comes from and what it does.",
    afresh: "These are its balls without its memory.",
    why: "Why this one",
    ball: "Ball",
    outcome: "Outcome",
    imagined: "Imagined",
    close: "Back to placing",
    /** @type {(by: 1 | -1) => string} */
    noOther: (by) => `No ball ${by > 0 ? "after" : "before"} this one has another result.`,
    none: "none",
    place: (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ r) =>
      `x ${decimal(x)}, y ${decimal(y)}, radius ${decimal(r)}`,
    notTried: "It was not tried in its turn.",
    origin: {
      perturbed: (/** @type {number} */ ball) => `Ball ${ball}, moved at random.`,
      success: (/** @type {number} */ chance) =>
        `After the balls tried before, the success net gives this one the best chance of solving the puzzle: ${percent(chance)}.`,
      uniform: "Random: the placement map shows no place where a ball may be.",
      /** @type {(value: number | null, x: number, y: number) => string} */
      map: (value, x, y) =>
        `The placement map:${value === null ? "" : ` it is ${number(value, 2)} at x ${x}, y ${y}.`} From there the ball was moved to cover more of the map.`,
      likeliest: (/** @type {string} */ chance) =>
        `Of all balls not tried yet, the model gave this one the best chance of solving the puzzle: ${chance}.`,
      /** @type {(before: string, failed: number, now: string) => string} */
      lowered: (before, failed, now) =>
        `Before the first attempt the model gave this ball a chance of ${before}. Then ball ${failed} failed, which starts much like it or did much the same. That left it ${now}, still the best of those not tried yet.`,
    },
  },

  remembers: {
    nothing: "It remembers nothing yet. From now on it learns from what you both try in this browser.",
    damaged: "Its memory was damaged or from another version, so it starts again with an empty one.",
    /** What stands before the earlier puzzle that helped, and after it. */
    source: (/** @type {boolean} */ mirrored) => ["It learned this from ", mirrored ? " (mirrored)." : "."],
    puzzle: (/** @type {string} */ kind, /** @type {number} */ place) => `${kind} ${place}`,
    custom: (/** @type {string | null} */ name) => (name === null ? "a custom puzzle" : `“${name}”`),
  },

  score: (/** @type {number} */ puzzles, /** @type {number} */ you, /** @type {number} */ it) =>
    `Points over ${puzzles === 1 ? "one puzzle" : `${number(puzzles)} puzzles`}: you ${you}, the model ${it}`,

  solveMap: {
    intro:
      "Where can the red ball start so that it solves the puzzle? The computer tries every place, first roughly, then more finely.",
    trying: "Trying",
    solves: "solves it",
    doesNot: "does not",
    noRoom: "no room",
    compare: "Compare with the model’s guess",
    hint: "It uses the radius of your ball. Each place gets a full simulation, in the background.",
    stop: "Stop",
    start: (/** @type {number} */ radius) => `Try every place with radius ${decimal(radius)}`,
    /** @type {(progress: number, solving: number, invalid: number, radius: number) => string} */
    tried: (progress, solving, invalid, radius) => {
      const [tried, about] =
        progress < 1 ? [`${percent(progress)} tried so far: `, "about "] : ["Every place tried: ", ""];
      return `${tried}${rough(solving, about)} of the places solve it with radius ${decimal(radius)}, and ${rough(invalid)} have no room for a ball.`;
    },
    sides: (/** @type {string} */ sides) => `Those that solve it: ${sides}.`,
    agrees: (/** @type {number} */ share) => `${percent(share)} of the model’s placement map lies on such places.`,
  },

  strip: {
    saved: "The picture is saved.",
    failed: "This browser could not make the picture.",
    puzzle: "Puzzle",
    ball: "The ball",
    result: "What happens",
  },

  trouble: { otherModel: "Use the default model" },

  walkthrough: {
    all: "All together",
    step: (/** @type {number} */ step, /** @type {number} */ of) => `Step ${step} of ${of}`,
    dot: (/** @type {number} */ step, /** @type {string} */ name) => `Step ${step}: ${name}`,
    here: (/** @type {string} */ words) => `It is ${words}.`,
  },

  /** A step of the story, or a ball of the model's, of how many. */
  of: (/** @type {number} */ place, /** @type {number} */ of) => `${place} of ${of}`,
};

/**
 * @param {number} share
 * @param {string} [about] before a rounded number
 */
function rough(share, about = "") {
  return share > 0 && share < 0.01 ? `less than ${percent(0.01)}` : about + percent(share);
}
