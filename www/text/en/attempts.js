// What `attempts/` says: files of attempts, and whether a solution was luck.

import { counted, number, percent } from "./format.js";

/** @typedef {import("../../pkg/pathlight.js").AttemptLine} AttemptLine */

/** @type {Record<AttemptLine["status"], string>} */
const STATUS = { solved: "solved", not_solved: "not solved", invalid: "invalid" };

export const attempts = {
  file: {
    foreign: (/** @type {string} */ name, /** @type {string} */ why) =>
      `${name} is not a file of attempts from Pathlight: ${why}. Nothing was changed.`,
    tooLarge: (/** @type {number} */ megabytes) => `it is larger than ${megabytes} MB`,
    empty: "it is empty",
    tooLong: (/** @type {number} */ line) => `line ${number(line)} is too long`,
    notJson: (/** @type {number} */ line) => `line ${number(line)} is not JSON`,
    tooDeep: (/** @type {number} */ line) => `line ${number(line)} is nested too deeply`,
  },

  luck: {
    asking: "The computer tries the balls beside yours.",
    verdict: { plan: "A plan", luck: "Mostly luck", both: "Some of both" },
    /** @type {(verdict: string, valid: number, solved: number) => string} */
    found: (verdict, valid, solved) =>
      `${verdict}: of the ${counted(valid, "ball", "balls")} within a pixel of yours in place and radius, ${solved} ${solved === 1 ? "solves" : "solve"} it.`,
  },

  replays: {
    saved: (/** @type {number} */ count) =>
      `${count === 1 ? "One attempt is" : `${number(count)} attempts are`} saved. “Open attempts” simulates the file again; so does the command “pathlight verify”.`,
    read: (/** @type {number} */ share) => `${percent(share)} of the file is read.`,
    begun: "Each attempt is simulated again.",
    simulated: (/** @type {number} */ done, /** @type {number} */ of) =>
      `${number(done)} of ${counted(of, "attempt", "attempts")} simulated again.`,
    stop: "Stop",
    /** @type {(name: string, same: number, done: number) => string} */
    result: (name, same, done) =>
      `${name}: ${number(same)} of ${counted(done, "attempt", "attempts")} ${same === 1 ? "comes" : "come"} out the same to the bit.`,
    stopped: (/** @type {number} */ rest) =>
      `You stopped before the ${rest === 1 ? "last one" : `other ${number(rest)}`}.`,
    listed: (/** @type {number} */ count) => `The first ${number(count)} are listed.`,
    left: (/** @type {number} */ count, /** @type {number} */ most) =>
      `${number(count)} more ${count === 1 ? "is" : "are"} in the file: the page reads ${number(most)}, “pathlight verify” all.`,

    ball: (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ r) => `x ${x}, y ${y}, radius ${r}`,
    noBall: "no ball",
    invalid: "not valid, the same",
    unplayable: {
      form: "This is not an attempt: its line has another form, or a part of it is damaged.",
      puzzle: "This attempt cannot be simulated: its puzzle is not known here, or may not be played.",
      ball: "The ball may not be placed there.",
    },
    outcome: (/** @type {Pick<AttemptLine, "status" | "steps">} */ { status, steps }) =>
      `${STATUS[status]} after ${number(steps)} steps`,
    otherOutcome: (/** @type {string} */ said, /** @type {string} */ found) =>
      `The line says ${said}, but it is ${found}.`,
    otherPoses: "The outcome is the same, but the poses differ.",
    version: (/** @type {number} */ its, /** @type {number} */ ours) =>
      `It was made by version ${its} of the simulator, and this is version ${ours}.`,
    solved: (/** @type {number} */ steps) => `solved in ${number(steps)} steps, the same to the bit`,
    missed: (/** @type {number} */ steps) => `not solved in ${number(steps)} steps, the same to the bit`,
  },
};
