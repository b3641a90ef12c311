// The home page.

import { formatsOf } from "../formats.ts";
import { balls } from "./widths.ts";
import type { Difficulty } from "../../core/derived/home.ts";
import type { Text } from "../text.ts";

const { counted, number, percent } = formatsOf("de");

const LEVELS: Record<Difficulty, string> = { easy: "leicht", medium: "mittel", hard: "schwer" };

export const home: Text["home"] = {
  title: "Schau zu, wie sich eine winzige KI vorstellt, was passiert. Dann schlag sie.",
  about:
    "Setz eine rote Kugel so, dass das grüne Objekt 3 Sekunden lang sein gestreiftes Ziel berührt. Die KI ist ein kleines Modell, das in deinem Browser läuft; auch sie hat dieses Rätsel noch nie gesehen.",
  play: "Animation abspielen",
  pause: "Animation anhalten",

  waiting: "Du kannst schon spielen: Klick oder tipp ins Bild.",
  imagine: (futures) => `Das Modell stellt sich ${futures} Bahnen vor …`,
  pick: (chance) => `… und wählt eine: Es ist sich zu ${percent(chance)} sicher.`,
  real: "Jetzt fällt seine Kugel wirklich.",
  result: (solved, off, radius) =>
    `${solved ? "Gelöst" : "Verfehlt"}: Seine Vermutung lag um ${balls(off, radius)} daneben. Du bist dran: Klick oder tipp ins Bild.`,

  day: "Rätsel des Tages",
  unsolved: "Das hat das Modell nie gelöst",
  canYou: (facts) => `Schaffst du es? ${facts}`,
  make: "Bau dein eigenes Rätsel",
  makeHint: "Verschieb, was du willst, spiel es und schick es Freunden",
  facts: (puzzle, difficulty) => `${puzzle}, ${LEVELS[difficulty]}`,
  howHard: (difficulty, rate) =>
    `${LEVELS[difficulty].charAt(0).toUpperCase()}${LEVELS[difficulty].slice(1)}: ` +
    (rate > 0.002 ? `1 von ${Math.round(1 / rate)} Kugeln löst es.` : "Weniger als 1 von 500 Kugeln löst es."),

  kinds: (count) => `${count} Arten, jede mit einem Rätsel, das für das Modell neu ist`,
  number: "Oder nach Nummer:",
  standing: (next, of, played) => {
    const solved = played.filter((one) => one.solved).length;
    const missed = played.length - solved;
    const found = [solved && `${solved} gelöst`, missed && `${missed} verfehlt`].filter(Boolean).join(", ");
    return `Rätsel ${next} von ${of} · ${found}`;
  },
  results: "Wie gut ist das Modell? Alle Ergebnisse",
  learns: "Sieh ihm beim Lernen zu",

  progress: "Dein Fortschritt",
  soFar: ({ tried, solved, attempts }) =>
    `Bisher hast du ${counted(tried, "Rätsel", "Rätsel")} probiert und ${number(solved)} gelöst, mit ${counted(attempts, "Kugel", "Kugeln")}`,
  keeps:
    "Alles bleibt auf diesem Gerät, in diesem Browser. Safari vergisst es nach sieben Tagen ohne Besuch; eine Datei behält es.",
  save: "Als Datei speichern",
  open: "Datei öffnen",
  forget: "Alles vergessen",
  keep: "Behalten",
  forgetHint:
    "Dieser Browser kennt dann keine deiner Kugeln und Lösungen mehr. Das lässt sich nicht rückgängig machen.",
};
