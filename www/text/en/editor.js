// What `editor/` says: the panel Make, its bodies and checks, and files and links of puzzles.

import { counted, number, percent } from "./format.js";
import { upper } from "../sentence.js";
import { puzzles } from "./puzzles.js";

/** @typedef {import("./puzzles.js").NamedBody} NamedBody */
/** @typedef {NamedBody & { index: number }} IndexedBody */
/** @typedef {import("../../editor/body-geometry.js").Size} Size */

/** @type {Record<Size, string>} */
const SIZES = { radius: "radius", length: "length", thickness: "thickness", height: "height" };

/** @param {number} value */
const decimal = (value) => number(value, 2, { minimumFractionDigits: 0 });

export const editor = {
  panel: {
    intro: "Make a puzzle of your own out of this one.",
    neverSeen: "Change something: it will be new to the model.",
    changes: "Changes",
    add: "Add a body",
    addBall: "+ Ball",
    addBar: "+ Bar",
    addJar: "+ Jar",
    addSticks: "+ Sticks",
    snap: "Snap to grid",
    problems: "What to fix first",
    bodies: "Bodies",
    selected: "Selected body",
    angle: "angle",
    moves: "Moves",
    actions: "What to do with it",
    object: "Green object",
    goal: "Goal",
    duplicate: "Duplicate",
    remove: "Delete",
    hint: "Select a body in the scene or in the list. With keys, in the scene: <kbd>N</kbd> and <kbd>P</kbd> select, arrows move, <kbd>,</kbd> <kbd>.</kbd> turn, <kbd>+</kbd> <kbd>−</kbd> resize, with <kbd>Shift</kbd> further; <kbd>D</kbd> duplicates, <kbd>Delete</kbd> removes.",
    // docs/results.md, "In other scenes", has the figures.
    elsewhere:
      "The model imagines a changed puzzle about as well as the original. In one unlike any of the 25 kinds, the model that knows them all mostly guesses. The other does better: it learned to judge balls from random puzzles.",
    imagined: "What the model imagines",
    check: "Can it be solved?",
    trying: "Trying",
    reveal: "Show the easiest ball",
    yours: "Your puzzle",
    name: "Name",
    keep: "Keep it in this browser",
    save: "Save to a file",
    link: "The address of this page holds the whole puzzle: copy the link, and whoever opens it plays what you made.",
  },

  sizes: SIZES,

  bodies: {
    none: "Nothing is selected.",
    /** @type {(body: NamedBody, index: number | null) => string} the index where several are alike */
    name: (body, index) => puzzles.body(body) + (index === null ? "" : ` (body ${index})`),
    /**
     * @type {(name: string, place: { x: number, y: number, degrees: number }, sizes: [Size, number][],
     *   moves: boolean) => string}
     */
    described: (name, { x, y, degrees }, sizes, moves) =>
      `${upper(name)}: x ${decimal(x)}, y ${decimal(y)}, turned by ${decimal(degrees)} degrees, ` +
      `${sizes.map(([size, value]) => `${SIZES[size]} ${decimal(value)}`).join(", ")}, ${moves ? "moves" : "is fixed"}.`,
  },

  check: {
    search: "Search for solutions",
    stop: "Stop",
    blocked: "Fix the problems above first, then search.",
    solvesItself: "The scene solves itself, without any ball.",
    /** @type {(solved: number, valid: number, ended: boolean) => string} */
    found: (solved, valid, ended) =>
      `It can be solved: ${number(solved)} of ${tried(valid, ended)} ${solved === 1 ? "solves" : "solve"} it, ${share(solved / valid)}.`,
    /** @type {(valid: number, ended: boolean) => string} */
    none: (valid, ended) => `No solution found in ${tried(valid, ended)}.`,
    harder: (/** @type {number} */ rank) => `${percent(rank)} of the benchmark’s puzzles are harder.`,
    between: "A ball between those of the grid may still solve it.",
    easiest: (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ r) =>
      `The easiest ball is at x ${x}, y ${y} with radius ${r}: it is in the scene now. Press “Drop it”.`,
  },

  /** Why a scene may not be played. */
  problems: {
    unreadable: (/** @type {string} */ why) => why,
    ownGoal: "The green object cannot be its own goal: choose another body as the goal.",
    staticObject: "The green object is fixed, so it never reaches a goal: let it move, or choose another.",
    /** @type {(least: number, most: number, tooMany: boolean) => string} */
    bodies: (least, most, tooMany) =>
      `A scene has ${least} to ${most} bodies, and this one has ${tooMany ? "more: remove some" : "fewer: add some"}.`,
    name: (/** @type {number} */ most) => `The name is longer than ${most} characters: shorten it.`,
    place: (/** @type {IndexedBody} */ body) =>
      `The ${indexed(body)} has no valid place: x and y must be numbers, and the angle from -2π to 2π.`,
    /** @type {(body: IndexedBody, size: Size, length: number, allowed: [least: number, most: number]) => string} */
    length: (body, size, length, [least, most]) =>
      `The ${SIZES[size]} of the ${indexed(body)} is ${px(length)} px, but may be ${least} to ${most}: ` +
      `make it ${length > most ? "smaller" : "larger"}.`,
    sticksOut: (/** @type {IndexedBody} */ body, /** @type {number} */ by) =>
      `The ${indexed(body)} sticks out of the scene by ${px(by)} px: move it inside or make it smaller.`,
    sticksOutOfCorner: (/** @type {IndexedBody} */ body, /** @type {number} */ by) =>
      `The ${indexed(body)} sticks out of a corner of the scene by ${px(by)} px: move it inside or make it smaller.`,
    outside: (/** @type {IndexedBody} */ body, /** @type {number} */ by) =>
      `The ${indexed(body)} is ${px(by)} px outside of the scene: move it nearer, or remove it.`,
    /** @type {(body: IndexedBody, other: IndexedBody, by: number, most: number) => string} */
    overlap: (body, other, by, most) =>
      `The ${indexed(body)} and the ${indexed(other)} overlap by ${px(by)} px, more than ${most}: move them apart.`,
  },

  live: {
    notYet: "not imagined yet",
    solvesItself: "Without a ball the scene solves itself: there is nothing left to do.",
    ends: (/** @type {number} */ x, /** @type {number} */ y) =>
      `Without a ball the green object ends at x ${number(x)}, y ${number(y)}.`,
  },

  file: {
    attempts: (/** @type {string} */ name) =>
      `${name} is a file of attempts, not of puzzles: open a puzzle, and then the file by “Open attempts”. Nothing was changed.`,
    foreign: (/** @type {string} */ name) => `${name} is not a file of puzzles from Pathlight. Nothing was changed.`,
    tooLarge: (/** @type {string} */ name, /** @type {number} */ megabytes) =>
      `${name} is larger than ${megabytes} MB. Split it. Nothing was changed.`,
    empty: (/** @type {string} */ name) => `${name} holds no puzzle.`,
    /** @type {(name: string, place: number | null, why: string) => string} the place among the puzzles of the file */
    unplayable: (name, place, why) =>
      `${place === null ? name : `Puzzle ${number(place)} of ${name}`} cannot be played: ${why} Nothing was changed.`,
  },

  link: {
    damaged: "This link holds a custom puzzle, but it is damaged: perhaps a part of it is missing. Ask for it again.",
    unplayable: (/** @type {string} */ why) => `This link holds a custom puzzle that cannot be played: ${why}`,
  },

  kept: (/** @type {string} */ name) =>
    `“${name}” is kept in this browser: find it on the home page, under “Your custom puzzles”.`,
};

/** @param {IndexedBody} body */
function indexed(body) {
  return `${puzzles.body(body)} (body ${body.index})`;
}

/**
 * A length; one that is far too large as a power of ten.
 * @param {number} length
 */
function px(length) {
  return Math.abs(length) < 1e5 ? number(length, 1) : length.toExponential(0);
}

/**
 * @param {number} balls
 * @param {boolean} ended
 */
function tried(balls, ended) {
  return counted(balls, "ball", "balls") + (ended ? "" : " so far");
}

/** @param {number} fraction */
function share(fraction) {
  return fraction < 0.001 ? "less than one in a thousand" : percent(fraction, fraction < 0.01 ? 1 : 0);
}
