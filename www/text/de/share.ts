// Sharing a puzzle, and links for a lesson.

import { formatsOf } from "../formats.ts";
import type { Found } from "../en/share.ts";
import type { Text } from "../text.ts";

const { counted } = formatsOf("de");
const MOST_MARKS = 20;

const first = (at: number) => (at === 1 ? "mit der ersten Kugel" : `mit Kugel ${at}`);
const isWon = ({ solvedAt, modelAt, modelBalls }: Found) =>
  solvedAt !== null && modelBalls >= solvedAt && (modelAt === null || modelAt > solvedAt);

const model = ({ modelAt, modelBalls }: Found) =>
  modelAt !== null
    ? `Das Modell brauchte ${counted(modelAt, "Kugel", "Kugeln")}.`
    : modelBalls > 0
      ? `Das Modell hat es mit ${counted(modelBalls, "Kugel", "Kugeln")} nicht gelöst.`
      : "";

export const share: Text["share"] = {
  titles: { share: "Teilen", lesson: "Link für den Unterricht", about: "Über Pathlight", forget: "Alles vergessen?" },

  headline: (solvedAt) => (solvedAt === null ? "Kannst du das lösen?" : `Gelöst ${first(solvedAt)}`),
  model,
  message: (puzzle, found, day) => {
    const { solvedAt } = found;
    if (solvedAt === null) return `„${puzzle}“ in Pathlight: Kannst du das lösen?`;
    const misses = solvedAt - 1;
    const marks = `${misses > MOST_MARKS ? `${misses} × 🔴 ` : "🔴".repeat(misses)}🟢`;
    const daily = day === null ? "" : `Pathlights Rätsel des Tages. ${marks} `;
    const result = isWon(found)
      ? `Ich habe das Modell bei „${puzzle}“ ${first(solvedAt)} geschlagen.`
      : `Ich habe „${puzzle}“ ${first(solvedAt)} gelöst.`;
    const ask = solvedAt === 1 ? "Schaffst du das auch?" : "Schaffst du es schneller?";
    return `${daily}${result} ${model(found)} ${ask}`.replace("  ", " ");
  },
  link: "Der Link",
  noBall: "Der Link verrät weder deine Kugel noch die des Modells noch seine Vermutung, bis das Rätsel gelöst ist.",
  copy: "Text und Link kopieren",
  system: "Teilen …",
  save: "Bild speichern",
  drawing: "Das Bild wird gemalt …",
  noCard: {
    missing: "Dieser Browser gibt kein Bild her. Text und Link sagen alles.",
    noise: "Dieser Browser schützt seine Bilder, darum kämen nur Streifen heraus. Text und Link sagen alles.",
  },
  withBall: "Meine Kugel im Bild zeigen",
  done: {
    copied: "Kopiert.",
    not_copied: "Dieser Browser erlaubt der Seite nicht, etwas zu kopieren. Markier oben den Link und kopier ihn.",
    not_shared: "Dieser Browser konnte nichts teilen. Kopier Text und Link.",
  },
  send: "Weitersagen",

  challenge: (at) =>
    `Jemand hat das ${first(at)} gelöst. Schaffst du es schneller? Das Modell schweigt, bis du es gelöst hast.`,
  challenged: (at, theirs) =>
    at < theirs
      ? `Du gewinnst: Die anderen brauchten ${theirs} Kugeln.`
      : at === theirs
        ? "Unentschieden: gleich viele Kugeln."
        : `Die anderen brauchten ${counted(theirs, "Kugel", "Kugeln")}.`,

  puzzles: "Rätsel nach Nummer, eins nach dem anderen",
  place: (number, of) => `${number} von ${of}`,
  noPuzzles: (wrong) =>
    `${wrong.join(", ")}: ${wrong.length === 1 ? "Das ist kein Rätsel" : "Das sind keine Rätsel"}. Ihre Nummern sehen aus wie 00007:008 oder 7:8.`,
  shows: "Was die Klasse sieht",
  presets: { everything: "Alles", play: "Nur Spielen", predict: "Vorhersagen: ohne Vermutung des Modells" },
  customise: "Selbst auswählen",
  parts: { puzzles: "Die Wege zu anderen Rätseln", guess: "Die Vermutung des Modells", model: "Das Modell" },
  presentation: "Als Präsentation, für einen Beamer",
  copyLink: "Link kopieren",
  preview: "So ansehen, wie die Klasse es sieht",
  code: "Der Link als QR-Code",
  noCode: "Für einen QR-Code ist der Link zu lang. Er funktioniert auch ohne.",
  ownMachine: "Dieser Link funktioniert nur auf diesem Computer: Stell die Seite dort bereit, wo andere sie erreichen.",
  end: "Im Link steckt alles: Sonst wird nirgends etwas gespeichert.",
};
