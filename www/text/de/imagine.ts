// What the model imagines: the walkthrough, the maps, and how they are made.

import { formatsOf } from "../formats.ts";
import { balls } from "./widths.ts";
import type { Point } from "../../core/change/placement.ts";
import type { Text } from "../text.ts";

const { counted, percent } = formatsOf("de");
const place = ([x, y]: Point) => `x ${Math.round(x)}, y ${Math.round(y)}`;
const chanceOf = (chance: number) => (chance < 0.01 ? "unter 1 %" : percent(chance));

export const imagine: Text["imagine"] = {
  tab: "Vorstellen",
  walkthrough: "Wie das Modell auf seine Kugel kommt",
  tour: "Schritte abspielen",
  stop: "Anhalten",
  all: "Alle",
  back: "Schritt zurück",
  next: "Nächster Schritt",
  step: (number, name) => `Schritt ${number}: ${name}`,
  maps: "Karten über der Szene",
  intro:
    "Bevor sich etwas bewegt, stellen sich fünf kleine Netze vor, was kommt. Tipp auf eine Karte, um sie über die Szene zu legen.",
  how: "Wie geht das?",

  steps: {
    base: ["Wenn du nichts tust", "Wohin sich Grün von allein bewegt."],
    target: ["Was Grün tun muss", "Eine Bahn für Grün, die an seinem Ziel endet."],
    action: ["Was Rot tun muss", "Eine Bahn für die rote Kugel, die Grün dorthin bringt."],
    placement: ["Wo Rot beginnt", "Wo die rote Kugel starten sollte und wo es klappen würde."],
    imagined: [
      "Vierzig mögliche Bahnen",
      "Jede Linie ist eine mögliche Bahn von Grün, jede mit einer anderen Kugel. Je kräftiger die Linie, desto besser die Chancen.",
    ],
    run: [
      "Was wirklich passiert",
      "Das Modell lässt seine Lieblingskugel fallen. Gepunktet: was es sich vorgestellt hat. Durchgezogen: was wirklich passiert.",
    ],
  },
  works: "Was gelingt",
  paper: {
    base: "Grundbahn",
    target: "Zielbahn",
    action: "Aktionsbahn",
    placement: "Startkarte",
    success: "Erfolgskarte",
  },
  hows: {
    base: "Das Netz sieht nur die Szene, als Bilder aus 64 × 64 Feldern, eines für jede Farbe. Für jedes Feld sagt es, wie sicher es ist, dass Grün dort vorbeikommt.",
    target:
      "Auch dieses Netz sieht nur die Szene. Es hat aus gelösten Rätseln gelernt, welchen Weg Grün dort nahm. Die rote Kugel kennt es noch nicht.",
    action:
      "Dieses Netz sieht die Szene, die Grundbahn und die Zielbahn: was passieren würde und was passieren soll. Für den Unterschied muss die rote Kugel sorgen.",
    placement: "Dieses Netz sieht die Szene, die Zielbahn und die Aktionsbahn.",
    success:
      "Ein fünftes Netz, das es im Fachartikel nicht gibt, sagt für Kugeln in acht Größen an jedem Ort, wie wahrscheinlich sie das Rätsel lösen. Die Karte zeigt die beste Größe.",
    imagined:
      "Das fünfte Netz hat an Kugeln aller Art gelernt, was sie bewirken. Die vielversprechendsten Kugeln kommen in die Auswahl. Bei jeder davon stellt es sich vor, wohin sich Grün und die Kugel bewegen würden und wie wahrscheinlich das eine Lösung ist. Gezeichnet sind die vierzig aussichtsreichsten. Nichts davon wird simuliert.",
    run: "Die Kugel läuft im selben Simulator wie deine. Je breiter das Band um eine gepunktete Linie, desto unsicherer war sich das Modell. Schafft es die Kugel nicht, werden ähnliche unwahrscheinlicher, und die aussichtsreichste der anderen ist als Nächste dran.",
  },

  path: (from, to) => `von ${place(from)} bis ${place(to)}`,
  strongest: (at) => `am stärksten bei ${place(at)}`,
  considered: (count, likely) =>
    `Es hat ${counted(count, "Kugel", "Kugeln")} erwogen und gibt ${likely === 1 ? "einer" : likely || "keiner"} davon mehr als 50 %.`,
  waiting: "Das Modell überlegt …",
  ended: (solved, chance) =>
    `Es gab seiner Kugel ${chanceOf(chance)}, und ${solved ? "sie schafft es." : "sie schafft es nicht."}`,
  off: (distance, radius) =>
    `Die Bahn, die es sich für Grün vorgestellt hat, lag im Schnitt um ${balls(distance, radius)} daneben.`,
};
