// The German words for en/reading.js.

import { list, number } from "./format.js";

/** @type {typeof import("../en/reading.js").reading} */
export const reading = {
  link: {
    unread: (parts, more) =>
      `In diesem Link steht ${list([...parts.map((part) => `„${part}“`), ...(more ? ["noch mehr"] : [])])}. Das versteht Pathlight nicht.`,
  },

  progressFile: {
    tooLarge:
      "Diese Datei ist zu groß, um sie als Ganzes zu lesen. Wähl eine mit einem Versuch pro Zeile, wie „pathlight“ und diese Seite sie schreiben.",
    empty: "Diese Datei enthält weder Fortschritt noch Versuche aus Pathlight. Wähl eine, die hier gespeichert wurde.",
  },

  puzzleStore: {
    full: (most) =>
      `Die Seite speichert höchstens ${number(most)} Rätsel: Lösch zuerst einige auf der Startseite. Was in einer Datei steht, bleibt dort.`,
    refused:
      "Dieser Browser speichert nichts für die Seite oder hat keinen Platz mehr: Speichere das Rätsel als Datei oder kopier seinen Link.",
  },

  wasm: {
    failed: (why) =>
      `Pathlight ließ sich nicht laden. Prüf die Verbindung und versuch es noch einmal, am besten in einem aktuellen Browser. (${why})`,
  },
};
