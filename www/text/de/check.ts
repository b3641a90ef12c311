// The check: where balls of a radius work, and the search for an easy one.

import { formatsOf } from "../formats.ts";
import type { Text } from "../text.ts";

const { counted, number, percent } = formatsOf("de");

export const check: Text["check"] = {
  show: "Alle Plätze zeigen, die gehen",
  offer: "Dreimal verfehlt: Möchtest du sehen, wo eine Kugel geht?",
  radius: "Radius der Kugeln",
  tried: (progress, working) =>
    (progress < 1
      ? `${percent(progress)} probiert.`
      : working === 0
        ? "Mit dieser Größe geht keine Kugel."
        : `Eine Kugel dieser Größe geht an ${working < 0.01 ? "weniger als 1 %" : percent(working)} aller Plätze.`) +
    `${working === 0 && progress === 1 ? "" : " Gelb: geht."} Gestreift: kein Platz für die Kugel.`,
  compare: "Mit der Vermutung des Modells vergleichen",
  agrees: (share) => `${percent(share)} seiner Vermutung liegen dort, wo eine Kugel geht.`,
  seek: "Eine Lösung zeigen",
  stop: "Nicht weitersuchen",
  found: ({ progress, valid, solved, rank, easiest, solves_itself }) =>
    [
      solves_itself ? "Es löst sich von selbst, ganz ohne Kugel." : "",
      progress < 1
        ? `Sucht eine einfache Kugel: ${percent(progress)}.`
        : easiest
          ? `Von ${counted(valid, "Kugel", "Kugeln")} ${solved === 1 ? "geht eine" : `gehen ${number(solved)}`}. Eine einfache liegt jetzt in der Szene.`
          : `Von ${counted(valid, "Kugel", "Kugeln")} aller Plätze und Größen geht keine. Dazwischen könnte es noch eine geben.`,
      progress === 1 && easiest && rank !== null ? `${percent(rank)} der Rätsel von Pathlight sind schwerer.` : "",
    ]
      .filter(Boolean)
      .join(" "),
};
