// Making a puzzle: its bodies, its problems, keeping and sharing it.

import { formatsOf } from "../formats.ts";
import { puzzle, theBody } from "./puzzle.ts";
import type { Size } from "../../core/derived/bodies.ts";
import type { Text } from "../text.ts";

const { number } = formatsOf("de");

const SIZES: Record<Size, string> = { radius: "Radius", length: "Länge", thickness: "Dicke", height: "Höhe" };
const px = (length: number) => (Math.abs(length) < 1e5 ? number(length, length % 1 ? 1 : 0) : length.toExponential(0));

export const make: Text["make"] = {
  tab: "Bauen",
  hint: "Zieh ein Teil, um es zu verschieben. Tipp es an, dann hat es Griffe: Der eckige ändert die Größe, der runde dreht.",
  broken: "Noch nicht spielbar: Schau nach, was rot umringt ist.",
  watch: "Ohne Kugel ansehen",

  add: "Teil hinzufügen",
  shapes: { ball: "+ Kugel", bar: "+ Balken", jar: "+ Glas", standing_sticks: "+ Stäbe" },
  empty: "Leer beginnen",
  selected: "Gewähltes Teil",
  duplicate: "Duplizieren",
  remove: "Löschen",
  role: "Es ist",
  roles: {
    green: "grün: soll ans Ziel",
    blue: "blau: das Ziel, beweglich",
    purple: "violett: das Ziel, fest",
    gray: "grau: beweglich",
    black: "schwarz: fest",
  },

  details: "Details",
  body: "Teil",
  nothing: "nichts gewählt",
  named: (body, index) => `${index + 1}: ${puzzle.body(body)}`,
  angle: "Winkel",
  sizes: SIZES,
  keys: "Tasten in der Szene: N und P wählen, Pfeile verschieben, Komma und Punkt drehen, + und − ändern die Größe, mit Umschalt in größeren Schritten; D dupliziert, Entf löscht, Strg+Z macht rückgängig.",
  described: (body, x, y, degrees, sizes) =>
    `Gewählt: ${puzzle.body(body)} bei x ${px(x)}, y ${px(y)}, um ${px(degrees)} Grad gedreht, ` +
    `${sizes.map(([size, value]) => `${SIZES[size]} ${px(value)}`).join("; ")}.`,

  live: "Zeigen, wo das Modell Grün erwartet",
  name: "Name",
  changed: (name) => `${name}, verändert`,
  keep: "In diesem Browser behalten",
  kept: "In diesem Browser behalten ✓",
  save: "Als Datei speichern",
  open: "Datei öffnen",
  link: "In der Adresse dieser Seite steckt dein ganzes Rätsel: Wer den Link öffnet, spielt es.",
  yours: (count) => `Deine Rätsel (${number(count)})`,
  forget: (name) => `„${name}“ löschen`,

  problem: ({ fault, body, other }) => {
    switch (fault.kind) {
      case "unreadable":
        return "Das ist keine Szene von Pathlight.";
      case "own_goal":
        return "Grün kann nicht sein eigenes Ziel sein: Wähl ein anderes Ziel.";
      case "static_object":
        return "Grün muss beweglich sein, sonst kommt es nie ans Ziel.";
      case "bodies":
        return fault.count > fault.most
          ? `Es sind mehr als ${fault.most} Teile: Lösch einige.`
          : `Es braucht mindestens ${fault.least} Teile: Füg eins hinzu.`;
      case "name":
        return `Der Name hat mehr als ${fault.most} Zeichen.`;
      case "place":
        return `Kein gültiger Ort für ${theBody(body!, "accusative")}.`;
      case "length":
        return `${SIZES[fault.key]} nicht erlaubt, ${theBody(body!)}: möglich sind ${px(fault.least)} bis ${px(fault.most)}.`;
      case "sticks_out":
      case "sticks_out_of_corner":
        return `Ragt ${px(fault.by)} px hinaus: Schieb es hinein oder mach es kleiner.`;
      case "outside":
        return `Liegt ${px(fault.by)} px außerhalb: Schieb es näher oder lösch es.`;
      case "overlap":
        return `Überschneidet ${theBody(other!, "accusative")} um ${px(fault.by)} px: Schieb sie auseinander.`;
    }
  },
};
