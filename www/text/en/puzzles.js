// What is said of puzzles: their names, goals, bodies and how hard they are.

import { number } from "./format.js";

/** @typedef {Pick<import("../../pkg/pathlight.js").Body, "role" | "shape">} NamedBody */
/** @typedef {import("../../pkg/pathlight.js").Body} Body */
/** @typedef {"easy" | "medium" | "hard"} Difficulty */

/** @type {Record<Body["shape"], string>} */
const SHAPES = { ball: "ball", bar: "bar", jar: "jar", standing_sticks: "standing sticks" };

const bodyName = (/** @type {NamedBody} */ { role, shape }) => `${role} ${SHAPES[shape]}`;

const placed = (/** @type {Body} */ body) => `${bodyName(body)} at x ${number(body.x)}, y ${number(body.y)}`;

export const puzzles = {
  /** "green ball". */
  body: bodyName,
  numbered: (/** @type {string} */ kind, /** @type {number} */ place, /** @type {number} */ of) =>
    `${kind}, ${place} of ${of}`,
  custom: "Custom puzzle",
  edited: (/** @type {string} */ name) => `${name}, edited`,
  customStory: "Somebody made this scene. It is not one of the benchmark’s puzzles.",
  goal: (/** @type {NamedBody} */ object, /** @type {NamedBody} */ target, /** @type {number} */ time) =>
    `Get the ${bodyName(object)} to touch the ${bodyName(target)} for ${time} seconds.`,
  /** @type {(object: Body, target: Body, others: Body[]) => string} */
  description: (object, target, others) =>
    `256 by 256, y is up. The ${placed(object)}; the goal is the ${placed(target)}. ` +
    (others.length ? `Also: ${others.map(placed).join("; ")}.` : "Nothing else."),
  /** @type {Record<Difficulty, string>} */
  difficulties: { easy: "easy", medium: "medium", hard: "hard" },
  oneInSolves: (/** @type {number} */ balls) => `about 1 ball in ${number(balls)} solves it`,
  fewerSolve: (/** @type {number} */ balls) => `fewer than 1 ball in ${number(balls)} solve it`,
  howHard: (/** @type {Difficulty} */ difficulty, /** @type {string} */ share) =>
    `${puzzles.difficulties[difficulty]}: ${share}`,
  facts: (/** @type {string} */ task, /** @type {string} */ difficulty) => `Puzzle ${task}, ${difficulty}.`,
};
