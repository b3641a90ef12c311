// What `page/` and `widgets/` say: the header, notices, files, progress and custom puzzles.

import { counted, number, percent } from "./format.js";

const MONTHS = [
  "January",
  "February",
  "March",
  "April",
  "May",
  "June",
  "July",
  "August",
  "September",
  "October",
  "November",
  "December",
];

const attempts = (/** @type {number} */ count) => counted(count, "attempt", "attempts");
const puzzles = (/** @type {number} */ count) => counted(count, "puzzle", "puzzles");
const notLoaded = (/** @type {string} */ part) =>
  `${part} could not be loaded. Check the connection; if Pathlight has been updated meanwhile, load the page again.`;

export const page = {
  name: "Pathlight",
  description:
    "Place one red ball so that the green object touches its goal, and watch a tiny AI imagine what happens.",
  title: (/** @type {string} */ shown) => `${shown} – Pathlight`,
  views: { results: "Results", learns: "It learns while you watch" },
  // Not by toLocaleDateString, whose first call loads the data of a language, some 20 ms.
  day: (/** @type {Date} */ date) => `${date.getDate()} ${MONTHS[date.getMonth()]} ${date.getFullYear()}`,

  header: {
    skip: "Skip to the scene",
    puzzle: "Puzzle",
    previous: "Previous puzzle",
    previousKey: "Previous puzzle  [",
    which: "Which of the 100 puzzles",
    next: "Next puzzle",
    nextKey: "Next puzzle  ]",
    random: "Random puzzle",
    share: "Share",
    presentation: "Presentation: the scene and one sentence, in large type",
    presentationKey: "Presentation  V",
    about: "About Pathlight",
    keys: "Keys",
    keysKey: "Keys  ?",
  },

  /** Short words: they have to fit into the picker. */
  picker: {
    puzzle: (/** @type {string} */ task) => `Puzzle ${task}`,
    place: (/** @type {number} */ place, /** @type {number} */ of) => `${place} of ${of}`,
    solved: (/** @type {number} */ place, /** @type {number} */ at) => `${place}: solved at try ${at}`,
    tried: (/** @type {number} */ place, /** @type {number} */ made) =>
      `${place}: missed, ${made === 1 ? "1 try" : `${made} tries`}`,
  },

  links: {
    all: "All puzzles",
    first: (/** @type {string} */ kind) => `The first puzzle of ${kind}`,
    noPuzzle: (/** @type {string} */ task) => `This link asks for puzzle ${task}, which does not exist.`,
    hidesAll: "This link names no puzzle, and hides the list of them.",
    copied: "The link to what you see is copied.",
    notCopied: (/** @type {string} */ link) => `This browser does not let the page copy. The link is ${link}`,
  },

  broken: {
    crash: (/** @type {string} */ reason) => `Something in Pathlight broke: ${reason}. Load the page again to go on.`,
    reload: "Load it again",
    noCanvas:
      "This browser gives the page no canvas to draw on: perhaps its memory is used up. Close other tabs, and load the page again.",
  },

  notLoaded: {
    results: notLoaded("The page of the results"),
    learns: notLoaded("This part of the page"),
    share: notLoaded("The sheet to share a puzzle"),
  },

  files: {
    several: (/** @type {number} */ count) => counted(count, "file", "files"),
    reading: (/** @type {string} */ name, /** @type {number} */ done) => `Reading ${name}: ${percent(done)}`,
    stop: "Stop",
    stopped: (/** @type {string} */ name) => `Reading ${name} was stopped. Nothing was changed.`,
    failed: (/** @type {string} */ name) =>
      `${name} could not be read. If it was moved or changed, choose it again. Nothing was changed.`,
    tooLarge: (/** @type {string} */ name, /** @type {number} */ megabytes) =>
      `${name} is larger than ${megabytes} MB. Split it. Nothing was changed.`,
  },

  progress: {
    save: "Save to a file",
    saveAll: "Save all to a file",
    forget: "Forget progress",
    read: "Load progress from a file",
    file: "A file with progress",
    soFar: (/** @type {number} */ tried, /** @type {number} */ solved, /** @type {number} */ made) =>
      `So far you have tried ${puzzles(tried)} and solved ${number(solved)}, in ${attempts(made)}.`,
    custom: (/** @type {number} */ tried, /** @type {number} */ solved, /** @type {number} */ made) =>
      `Of your own puzzles you have tried ${number(tried)} and solved ${number(solved)}, in ${attempts(made)}.`,
    ofKind: (/** @type {number} */ solved, /** @type {number} */ of, /** @type {number} */ made) =>
      `${solved ? "✓" : "×"} ${solved} of ${of} solved, in ${attempts(made)}`,
    forbidden: "This browser does not let the page store anything: your progress is lost when you close the page.",
    full: (/** @type {number} */ made) =>
      made
        ? `This browser has no room left: ${counted(made, "attempt is", "attempts are")} lost when you close the page, unless you save them to a file.`
        : "This browser has no room left: the latest changes are lost when you close the page.",
    readBack: (/** @type {number} */ count, /** @type {number} */ made) =>
      `Loaded: ${puzzles(count)}, with ${attempts(made)}.`,
    added: (/** @type {number} */ made, /** @type {number} */ solved) =>
      `New here: ${attempts(made)}, ${counted(solved, "solved puzzle", "solved puzzles")}.`,
    left: (/** @type {number} */ made, /** @type {number} */ most) =>
      `${counted(made, "attempt stays", "attempts stay")} only in the file: this browser keeps 100 per player and puzzle, 1,000 for custom puzzles, and ${number(most)} in all.`,
    unread: (/** @type {number} */ lines) => `Not read: ${counted(lines, "line", "lines")} without a valid attempt.`,
    undo: "Undo",
    gone: "Undone: your progress is as it was before.",
  },

  forget: {
    title: "Forget your progress?",
    words:
      "This device will no longer know which puzzles you have tried and solved, nor your attempts. The model forgets them too. That cannot be undone.",
    keep: "Keep it",
    forget: "Forget it",
  },

  custom: {
    title: "Your custom puzzles",
    empty:
      "None yet. Open any puzzle, press Make and change it. You can keep your puzzles here, and anybody with the link can play them.",
    open: "Open a file",
    saveAll: "Save all to a file",
    files: "Files of puzzles",
    hidden: "This link shows only one puzzle, so no file is opened here.",
    remove: "Delete",
    removeNamed: (/** @type {string} */ name) => `Delete ${name}`,
    removed: (/** @type {string} */ name) => `“${name}” is deleted.`,
    undo: "Undo",
    back: (/** @type {string} */ name) => `“${name}” is back.`,
    kept: (/** @type {number} */ count) =>
      count === 1
        ? "One puzzle is kept: find it under “Your custom puzzles”."
        : `${number(count)} puzzles are kept: find them under “Your custom puzzles”.`,
    known: (/** @type {number} */ count) => `${count === 1 ? "One is" : `${number(count)} are`} there already.`,
    left: (/** @type {number} */ count, /** @type {number} */ most) =>
      `No room for ${number(count)}: the page keeps ${number(most)} puzzles. Those stay in the file; first delete some puzzles here.`,
    solved: (/** @type {number} */ made) => `✓ solved, in ${attempts(made)}`,
    missed: (/** @type {number} */ made) => `× not solved, in ${attempts(made)}`,
  },

  widgets: { close: "Close", mostly: (/** @type {string} */ difficulty) => `mostly ${difficulty}` },
};
