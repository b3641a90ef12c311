// What `page/learns-….js` say: the model plays puzzles of a kind that is new to it, with a memory and without.

import { counted, percent } from "./format.js";

const puzzles = (/** @type {number} */ count) => counted(count, "puzzle", "puzzles");

/** @type {(first: number | null, limit: number) => string} */
const tries = (first, limit) =>
  first === null ? `not solved in ${limit} attempts` : first === 1 ? "at once" : `on attempt ${first}`;

export const learns = {
  title: "It learns while you watch",
  about:
    "The model has never seen puzzles of these kinds. It plays twenty of one kind in a row and remembers what each attempt taught it. Next to it, the same model plays without a memory: it forgets everything after each puzzle. This is a single run in a fixed order, not an average.",
  kind: "Kind of puzzles",

  play: (/** @type {number} */ count) => `Let it play ${count}`,
  playMore: (/** @type {number} */ count) => `Play ${count} more`,
  pause: "Pause",
  goOn: "Go on",
  next: "Next",
  finish: "To the end",
  fetching: (/** @type {number | null} */ done) => `Fetching the model …${done === null ? "" : ` ${percent(done)}`}`,

  withMemory: "With memory",
  without: "Without",
  withMemoryScene: "What the model tries with its memory",
  withoutScene: "What the same model tries without a memory",
  try: (/** @type {number} */ at) => `Attempt ${at}`,
  solved: (/** @type {number} */ first, /** @type {number} */ limit) => `Solved ${tries(first, limit)}`,
  missed: (/** @type {number} */ made) => `Not in ${made} attempts`,

  chart: "Attempts for each puzzle",
  withMemoryKey: "● with memory",
  withoutKey: "■ without",
  missedKey: "× not solved",
  lineKey: "— trend over five puzzles",
  chartLabel: "Attempts for each puzzle, with memory and without; the list below has the numbers",
  axis: "puzzle",

  puzzles: "Puzzle by puzzle",
  puzzle: (/** @type {number} */ place) => `Puzzle ${place}`,
  status: (/** @type {number} */ place, /** @type {string} */ played) => `Puzzle ${place}: ${played}`,
  /** @type {(learned: number | null, fresh: number | null, limit: number, helped: string) => string} */
  played: (learned, fresh, limit, helped) =>
    `${learned === null ? "" : "solved "}${tries(learned, limit)}${helped}. Without memory: ${tries(fresh, limit)}.`,
  /** Which puzzle helped; `kind` and `task` of another kind, `place` of the same. */
  helped: {
    same: (/** @type {number} */ place, /** @type {boolean} */ mirrored) =>
      `, helped by puzzle ${place}${mirrored ? " (mirrored)" : ""}`,
    other: (/** @type {string} */ kind, /** @type {string} */ task, /** @type {boolean} */ mirrored) =>
      `, helped by ${kind ? `${kind} ` : ""}${task}${mirrored ? " (mirrored)" : ""}`,
  },
  total: (/** @type {number} */ count, /** @type {number} */ learned, /** @type {number} */ fresh) =>
    `In this one run, ${puzzles(count)} took it ${counted(learned, "attempt", "attempts")} with its memory, and ${counted(fresh, "attempt", "attempts")} without.`,

  forget: "Forget everything",
  forgotten: "It has forgotten everything.",
  remembers: (/** @type {number} */ count) => `It remembers ${puzzles(count)}.`,
  remembersNothing: "It remembers nothing yet.",
};
