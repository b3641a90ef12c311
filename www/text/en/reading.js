// What is said of links, files and storage that cannot be read, and of a wasm that does not come.

import { list, number } from "./format.js";

export const reading = {
  link: {
    /** @type {(parts: string[], more: boolean) => string} */
    unread: (parts, more) =>
      `This link says ${list([...parts.map((part) => `“${part}”`), ...(more ? ["more"] : [])])}, which Pathlight does not understand.`,
  },

  progressFile: {
    tooLarge:
      "This file is too large to be read as a whole. Choose one with an attempt on each line, as “pathlight” and this page write them.",
    empty: "This file holds no progress of Pathlight and no attempts. Choose one that was saved here.",
  },

  puzzleStore: {
    full: (/** @type {number} */ most) =>
      `The page keeps ${number(most)} puzzles: delete some on the home page first. What is in a file stays there.`,
    refused:
      "This browser keeps nothing for the page, or has no room left: save the puzzle as a file, or copy its link.",
  },

  wasm: {
    /** The API says it in English. */
    failed: (/** @type {string} */ why) => why,
  },
};
