// What the page of the results says.

import { list, number, percent } from "./format.js";

export const results = {
  title: "How good are the models?",
  model: "Model",
  agent: "Agent",
  show: "Show",
  all: "all puzzles",
  failures: "only failures",
  late: "failures, and those solved after the tenth attempt",
  first: "those solved at the first attempt",
  csv: "Save all as CSV",
  cells: "Each entry opens its puzzle with this model. A number is the attempt that solved it; × means not solved.",
  none: "There are none.",

  namedAgent: (/** @type {string} */ name, /** @type {string} */ what) => `${name}: ${what}`,
  about: (/** @type {string} */ name, /** @type {string} */ what, /** @type {number} */ puzzles) =>
    `${name} ${what}; it has never seen these ${number(puzzles)} puzzles of the benchmark PHYRE.`,
  /** How many are solved within a hundred attempts, ten and one. */
  outcome: (/** @type {number[]} */ [hundred, ten, one], /** @type {number} */ of) =>
    `${number(hundred)} of ${number(of)} puzzles solved within a hundred attempts, ${number(ten)} within ten, ${number(one)} at the first.`,
  /** 0 to 100. */
  auccess: (/** @type {number} */ auccess) => `Auccess ${number(auccess, 1)} of 100: the fewer attempts, the higher.`,
  compared: (/** @type {[agent: string, auccess: number][]} */ others) =>
    `For comparison: ${list(others.map(([agent, auccess]) => `${agent} ${number(auccess, 1)}`))}.`,
  ofKind: (/** @type {number} */ solved, /** @type {number} */ of) => `${number(solved)} of ${number(of)} solved`,
  solved: (/** @type {string} */ task, /** @type {number} */ at) => `${task}, solved on attempt ${at}`,
  missed: (/** @type {string} */ task) => `${task}, not solved`,

  beside: {
    title: "Compared with published results",
    about:
      "Auccess, averaged over PHYRE’s ten splits of the puzzles; the figures above are for one split. We trained most nets briefly, anew for each split, and measured them in version 3 of our simulator, which differed slightly from PHYRE’s. RAND tries the same list of balls on every puzzle; our random balls are drawn anew each time.",
    within: "Known kinds",
    cross: "New kinds",
    byKind: {
      title: "The paper’s nets, kind by kind",
      about: "A dash: no split tests this kind as new.",
      kind: "Kind",
      published: "published",
      ours: "ours",
    },
    otherData:
      "online, trained differently: also on balls that the net had proposed (known kinds), or on random puzzles alone (new kinds)",
    ours: "Ours",
    published: "Published",
  },

  calibration: {
    title: "When it says 30%, is it right 30% of the time?",
    about:
      "Of the balls to which the model gives a chance of 30%, three in ten should solve their puzzle. Below the diagonal it promises too much. Random balls are any that a person may place; candidates are those that the model itself considers.",
    chart: "Chance given and share that solves; the table has the numbers",
    randomKey: "● random balls",
    candidatesKey: "■ candidates",
    chance: "Chance",
    random: "Random balls",
    candidates: "Candidates",
    balls: "balls",
    solve: "solve",
    range: (/** @type {number} */ from, /** @type {number} */ to) => `${number(100 * from)} to ${percent(to)}`,
  },
};
