// The German words for en/learns.js.

import { counted, number, percent } from "./format.js";
import { upper } from "../sentence.js";

const puzzles = (/** @type {number} */ count) => counted(count, "Rätsel", "Rätsel");

/** @type {(first: number | null, limit: number) => string} */
const tries = (first, limit) =>
  first === null
    ? `nicht in ${counted(limit, "Versuch", "Versuchen")}`
    : first === 1
      ? "sofort"
      : `im ${first}. Versuch`;

/** @type {typeof import("../en/learns.js").learns} */
export const learns = {
  title: "Es lernt, während du zuschaust",
  about:
    "Rätsel dieser Arten hat das Modell noch nie gesehen. Es spielt zwanzig Rätsel einer Art nacheinander und merkt sich, was jeder Versuch gezeigt hat. Daneben spielt das gleiche Modell ohne Gedächtnis: Es vergisst nach jedem Rätsel alles. Das ist ein einzelner Durchgang in fester Reihenfolge, kein Mittelwert.",
  kind: "Art von Rätseln",

  play: (count) => `${count} spielen lassen`,
  playMore: (count) => `Noch ${count} spielen lassen`,
  pause: "Pause",
  goOn: "Weiter",
  next: "Nächstes",
  finish: "Bis zum Ende",
  fetching: (done) => `Das Modell wird geladen …${done === null ? "" : ` ${percent(done)}`}`,

  withMemory: "Mit Gedächtnis",
  without: "Ohne",
  withMemoryScene: "Was das Modell mit seinem Gedächtnis probiert",
  withoutScene: "Was das gleiche Modell ohne Gedächtnis probiert",
  try: (at) => `Versuch ${at}`,
  solved: (first, limit) => `${upper(tries(first, limit))} gelöst`,
  missed: (made) => `Nicht gelöst in ${counted(made, "Versuch", "Versuchen")}`,

  chart: "Versuche je Rätsel",
  withMemoryKey: "● mit Gedächtnis",
  withoutKey: "■ ohne",
  missedKey: "× nicht gelöst",
  lineKey: "— Verlauf über fünf Rätsel",
  chartLabel: "Versuche je Rätsel, mit Gedächtnis und ohne; die Zahlen stehen in der Liste darunter",
  axis: "Rätsel",

  puzzles: "Rätsel für Rätsel",
  puzzle: (place) => `Rätsel ${place}`,
  status: (place, played) => `Rätsel ${place}: ${played}`,
  played: (learned, fresh, limit, helped) =>
    `${tries(learned, limit)}${learned === null ? "" : " gelöst"}${helped}. Ohne Gedächtnis: ${tries(fresh, limit)}.`,
  helped: {
    same: (place, mirrored) => `, dank Rätsel ${place}${mirrored ? " (gespiegelt)" : ""}`,
    other: (kind, task, mirrored) => `, dank ${kind ? `„${kind}“ ` : ""}${task}${mirrored ? " (gespiegelt)" : ""}`,
  },
  total: (count, learned, fresh) =>
    `In diesem einen Durchgang brauchte es für ${puzzles(count)} mit Gedächtnis ${counted(learned, "Versuch", "Versuche")}, ohne ${number(fresh)}.`,

  forget: "Alles vergessen",
  forgotten: "Es hat alles vergessen.",
  remembers: (count) => `Es erinnert sich an ${puzzles(count)}.`,
  remembersNothing: "Noch erinnert es sich an nichts.",
};
