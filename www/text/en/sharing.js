// What the dialogs say by which a person shares a puzzle, and makes a link for a lesson.

/** @typedef {import("../../state/url-state.js").Hideable} Hideable */

export const sharing = {
  title: "Share",
  copyLink: "Copy a link to what you see",
  lessonLink: "Link for a lesson",
  noBall: "The link in the text does not give away where your ball was.",
  system: "Share…",
  copy: "Copy text and link",
  savePicture: "Save the picture",
  saveFilm: "Save the film",
  film: "Make a film",
  stop: "Stop recording",
  recording: "Recording",
  close: "Close",

  showPaths: "Show my path and the model’s in the picture",
  showBall: "Show my ball in the picture",

  /** What is shared. */
  ask: (/** @type {string} */ puzzle) => `“${puzzle}”: can you solve it?`,
  day: (/** @type {string} */ day, /** @type {string} */ puzzle) => `Pathlight, ${day}: ${puzzle}`,
  solved: (/** @type {string} */ puzzle, /** @type {number} */ at) =>
    `I solved Pathlight’s puzzle “${puzzle}” ${at === 1 ? "at the first attempt" : `in ${at} attempts`}.`,
  match: "Can you match it?",
  better: "Can you do better?",
  modelSolved: (/** @type {number} */ at, /** @type {boolean} */ remembers) =>
    `${model(remembers)} needed ${at === 1 ? "one attempt" : `${at} attempts`}.`,
  modelMissed: (/** @type {number} */ made, /** @type {boolean} */ remembers) =>
    `${model(remembers)} did not solve it in ${made === 1 ? "one attempt" : `${made} attempts`}.`,

  /** On the picture. */
  card: {
    solved: (/** @type {number} */ at) => (at === 1 ? "Solved at the first attempt" : `Solved in ${at} attempts`),
    ask: "Can you solve it?",
    dashed: "Its path is dashed.",
    alt: (/** @type {string} */ puzzle, /** @type {string} */ solved, /** @type {string} */ model) =>
      `${puzzle}. ${solved}. ${model}`,
  },

  done: {
    film: (/** @type {boolean} */ withBall) =>
      `The film is ready: save or share it.${withBall ? " It shows your ball." : ""}`,
    filmStopped: "The film was stopped.",
    filmFailed: "This browser could not record the film. The picture can be saved.",
    shareFailed: "This browser could not share it. Copy the text, or save the picture.",
    copied: "The text and the link are copied.",
    pictureSaved: "The picture is saved.",
    filmSaved: "The film is saved.",
  },

  lesson: {
    title: "Link for a lesson",
    panels: "Panels",
    others: "Students can use",
    begins: "It begins",
    presentation: "As a presentation, for a projector",
    ball: "With the ball that is placed now",
    link: "The link",
    copy: "Copy",
    copied: "The link is copied.",
    notCopied: "This browser does not let the page copy: the address is selected, copy it with the keys or the menu.",
    ownMachine: "This link works only on this computer: serve the page where others can reach it.",
    code: "The link as a QR code",
    noCode: (/** @type {string} */ why) => `There is no QR code: ${why}. The address above works without it.`,
    end: "Whoever opens the link does not see what you left out. The link holds everything: nothing is stored elsewhere.",
    close: "Close",
    /**
     * The parts that a link can hide, beside the panels.
     * @type {Partial<Record<Hideable, string>>}
     */
    parts: {
      compare: "The race against the model",
      story: "The sentence that says what happens and what to do",
      hint: "How to place the ball",
      fields: "The ball’s slider and numbers, undo and redo",
      watch: "The button that runs the scene without a ball",
      attempts: "The list of attempts",
      save: "The button that saves all maps as one picture",
      forecast: "The model’s guess",
      transport: "The timeline and single steps",
      speed: "The speed",
      puzzles: "The links to other puzzles",
      tools: "The buttons at the top",
    },
  },
};

/** @param {boolean} remembers */
function model(remembers) {
  return remembers ? "The model, with its memory," : "The model";
}
