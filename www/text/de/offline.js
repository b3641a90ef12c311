// The German words for en/offline.js.

/** @type {typeof import("../en/offline.js").offline} */
export const offline = {
  label: "Neue Version",
  available: "Es gibt eine neue Version von Pathlight.",
  load: "Neue Version laden",
  later: "Später",
};
