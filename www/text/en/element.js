// What `element/` says: a puzzle around its panels, the menu “…”, and the sheets about the keys and about Pathlight.

import { list } from "./format.js";

export const element = {
  /** A panel inside of the tab that has its name. */
  insideOf: { imagine: "The story" },
  /** The panels, as their tabs and links for lessons call them. */
  panels: {
    play: "Play",
    imagine: "Imagine",
    compare: "The model’s balls, one by one",
    predict: "Predict",
    map: "Check the answer",
    make: "Make",
  },
  tabs: "Panels",
  parts: "Parts",
  close: "Close",
  tryAgain: "Try again",

  puzzle: (/** @type {string} */ name, /** @type {string | null} */ task) => `Puzzle ${name} ${task ?? ""}`.trim(),
  noPuzzle: (/** @type {string} */ task) => `There is no puzzle ${task}.`,
  noPanels: "The panels of this puzzle could not be loaded. Check the connection, and load the page again.",
  unread: (/** @type {string[]} */ attributes) =>
    `This page asks for a puzzle with ${list(attributes)}, which Pathlight does not understand.`,

  style: {
    missing: (/** @type {string} */ why, /** @type {string} */ address) =>
      `Pathlight’s style sheet could not be loaded: ${why} for ${address}. Build or install Pathlight again.`,
    unreachable: (/** @type {string} */ why, /** @type {string} */ address) =>
      `Pathlight’s style sheet could not be loaded: ${why} for ${address}. Check the connection and try again.`,
  },

  scene: {
    role: "puzzle scene",
    playback: "Playback",
    step: "One step",
    time: "Time",
    speed: "Speed",
    back: "Back to placing",
    reset: "Reset",
    seeIt: "See it",
    closest: "Shows the moment at which the green object was nearest to its goal",
    touched: "How long the green object has touched its goal",
    guess: "The model’s guess",
    introduction: "Introduction",
    leaveIntroduction: "Leave the introduction",
    takeOff: "Hide the maps",
  },

  story: { label: "Story", back: "Back", next: "Next", leave: "All panels" },

  more: {
    title: "More",
    ball: "Ball",
    model: "Model",
    opacity: "Opacity",
    saveMaps: "Save all maps as one picture",
    trained: "How was it trained?",
    attempts: "Attempts",
    saveAttempts: "Save the attempts",
    openAttempts: "Open attempts",
    attemptsFile: "A file of attempts",
    clearAttempts: "Clear attempts",
    saveBalls: "Save the model’s balls as CSV",
    pair: "Two models side by side",
    playBoth: "Let both play",
    second: "Second model",
    map: "Map",
  },

  keys: {
    title: "Keys",
    ctrl: "Ctrl",
    space: "Space",
    to: "to",
    move: "in the scene: move the ball by 1, with <kbd>Shift</kbd> by 10",
    resize: "in the scene: larger, smaller",
    undo: "undo, redo a placement",
    run: "run, pause, go on",
    step: "one step forward, one back",
    reset: "back to placing",
    puzzles: "previous, next puzzle",
    outcome: "among the model’s balls: the next one with another result, with <kbd>Shift</kbd> the one before",
    presentation: "the presentation: the scene and one sentence, in large type; <kbd>Esc</kbd> leaves it",
    story: "<kbd>←</kbd> <kbd>→</kbd> or <kbd>PgUp</kbd> <kbd>PgDn</kbd> go through the story",
    sheet: "this sheet",
  },

  about: {
    title: "About Pathlight",
    rules:
      "You choose where one red ball starts. After that nobody touches anything: balls fall and roll, bars tip, and everything bumps into everything else.",
    sameRules: "The model plays by the same rules, in the same simulator.",
    thinks: "How the model thinks",
    training: "How it was trained",
    trained:
      "Nobody told it the laws of motion. Its map nets were shown solved puzzles: the scene, the path that the green object takes by itself, the paths that it and the red ball take when the puzzle is solved, and where the red ball started. Each time, all their numbers were changed a little so that their next maps would be closer.",
    noModel: "No model is loaded.",
    sources: "Where the ideas come from",
    paper: `The nets: Augustin Harter, Andrew Melnik, Gaurav Kumar, Dhruv Agarwal, Animesh Garg and Helge Ritter, <a href="https://arxiv.org/abs/2011.07357">Solving Physics Puzzles by Reasoning about Paths</a> (2020).`,
    benchmark: `The puzzles: the 25 ball templates of <a href="https://phyre.ai">PHYRE</a>, a benchmark for physical reasoning by Anton Bakhtin and others (2019).`,
    local: "All of this runs in your browser. Nothing that you do here leaves your device.",
    licences: `Pathlight is free software under the Apache License 2.0, and made with the work of many others: <a id="licences" target="_blank">their names and licences</a>.`,
  },
};
