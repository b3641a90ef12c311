// Predicting where the green object goes.

import { formatsOf } from "../formats.ts";
import type { Text } from "../text.ts";

const { percent } = formatsOf("de");

export const predict: Text["predict"] = {
  tab: "Vorhersagen",
  intro:
    "Welchen Weg nimmt Grün? Zeichne seine Bahn und lass es dann laufen: Warst du näher dran oder das Modell? Ohne Kugel, oder mit einer, die du vorher setzt.",
  keys: "Mit Tasten: In der Szene zeichnen Pfeile von Grün aus weiter, mit der Umschalttaste in größeren Schritten.",
  draw: "Fang bei Grün an und zeichne seinen Weg.",
  drawn: "Fertig? Dann lass es laufen.",
  wipe: "Linie wegwischen",
  noBall: "Kugel wegnehmen",
  result: (you, model) => {
    const [mine, its] = [percent(you), model === null ? null : percent(model)];
    if (model === null) return `Du hattest zu ${mine} recht.`;
    if (mine === its) return `Unentschieden: Beide hatten zu ${mine} recht.`;
    return you > model
      ? `Du warst näher dran: ${mine}, das Modell ${its}.`
      : `Das Modell war näher dran: ${its}, du ${mine}.`;
  },
  measured: "100 %: genau der wirkliche Weg von Grün. 0 %: nichts davon.",
};
