// The German words for en/attempts.js.

import { counted, number, percent } from "./format.js";

/** @type {Record<import("../../pkg/pathlight.js").Status, string>} */
const STATUS = { solved: "gelöst", not_solved: "nicht gelöst", invalid: "ungültig" };

const steps = (/** @type {number} */ count) => counted(count, "Schritt", "Schritten");
/** All its digits, as it stands for one ball among many. */
const exact = (/** @type {number} */ value) => number(value, 20, { minimumFractionDigits: 0 });

/** @type {typeof import("../en/attempts.js").attempts} */
export const attempts = {
  file: {
    foreign: (name, why) =>
      `${name} ist keine Datei mit Versuchen aus Pathlight: ${why}. Hier bleibt alles, wie es war.`,
    tooLarge: (megabytes) => `Sie ist größer als ${megabytes} MB`,
    empty: "Sie ist leer",
    tooLong: (line) => `Zeile ${number(line)} ist zu lang`,
    notJson: (line) => `Zeile ${number(line)} ist kein JSON`,
    tooDeep: (line) => `Zeile ${number(line)} ist zu tief verschachtelt`,
  },

  luck: {
    asking: "Der Computer probiert Kugeln dicht neben deiner.",
    verdict: { plan: "Ein Plan", luck: "Eher Glück", both: "Von beidem etwas" },
    found: (verdict, valid, solved) =>
      `${verdict}: Von ${valid === 1 ? "der einen Kugel" : `den ${valid} Kugeln`}, die in Ort und Radius höchstens ein Pixel von deiner ${valid === 1 ? "abweicht" : "abweichen"}, ${solved > 1 ? "lösen" : "löst"} es ${solved > 1 ? solved : solved ? "eine" : "keine"}.`,
  },

  replays: {
    saved: (count) =>
      count === 1
        ? "Ein Versuch ist gespeichert. „Versuche öffnen“ simuliert ihn noch einmal, ebenso der Befehl „pathlight verify“."
        : `${number(count)} Versuche sind gespeichert. „Versuche öffnen“ simuliert sie noch einmal, ebenso der Befehl „pathlight verify“.`,
    read: (share) => `Gelesen: ${percent(share)} der Datei.`,
    begun: "Jeder Versuch wird noch einmal simuliert.",
    simulated: (done, of) => `Noch einmal simuliert: ${number(done)} von ${counted(of, "Versuch", "Versuchen")}.`,
    stop: "Anhalten",
    result: (name, same, done) =>
      `${name}: ${number(same)} von ${counted(done, "Versuch", "Versuchen")} ${same === 1 ? "geht" : "gehen"} bis aufs Bit gleich aus.`,
    stopped: (rest) => `Vor ${rest === 1 ? "dem letzten" : `den übrigen ${number(rest)}`} hast du angehalten.`,
    listed: (count) => `Die ersten ${number(count)} stehen in der Liste.`,
    left: (count, most) =>
      `In der Datei ${count === 1 ? "steht noch einer" : `stehen noch ${number(count)}`}: Die Seite liest ${number(most)}, „pathlight verify“ alle.`,

    ball: (x, y, r) => `x ${exact(x)}; y ${exact(y)}; Radius ${exact(r)}`,
    noBall: "keine Kugel",
    invalid: "ungültig, wie in der Datei",
    unplayable: {
      form: "Das ist kein Versuch: Die Zeile hat eine andere Form, oder ein Teil von ihr ist beschädigt.",
      puzzle: "Dieser Versuch lässt sich nicht simulieren: Sein Rätsel ist hier unbekannt oder nicht spielbar.",
      ball: "Dort darf keine Kugel liegen.",
    },
    outcome: ({ status, steps: made }) => `${STATUS[status]} nach ${steps(made)}`,
    otherOutcome: (said, found) => `In der Zeile steht „${said}“, richtig ist „${found}“.`,
    otherPoses: "Das Ergebnis ist dasselbe, aber die Bahnen weichen ab.",
    version: (its, ours) => `Der Versuch stammt aus Version ${its} des Simulators, hier läuft Version ${ours}.`,
    solved: (made) => `gelöst nach ${steps(made)}, bis aufs Bit gleich`,
    missed: (made) => `nicht gelöst nach ${steps(made)}, bis aufs Bit gleich`,
  },
};
