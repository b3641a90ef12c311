// The sheet "About Pathlight".

import type { Text } from "../text.ts";

export const about: Text["about"] = {
  idea: [
    "Pathlight ist ein Spiel gegen eine kleine KI, die plant, indem sie sich etwas vorstellt. Bevor eine Kugel fällt, malen vier kleine neuronale Netze, wohin das grüne Objekt von allein gelangt, wohin es soll, was Rot dafür tun muss und wo Rot beginnen sollte. Ein fünftes stellt sich vor, was irgendeine Kugel bewirkt.",
    "Nichts, was du vom Modell siehst, ist gestellt: Es denkt in deinem Browser, während du spielst. Dann zeigt der Simulator, was wirklich passiert, auf das Bit genau wie in dem Benchmark, aus dem die Rätsel stammen. Was du spielst, bleibt auf diesem Gerät.",
  ],
  paper: "Die Arbeit dazu: Solving Physics Puzzles by Reasoning about Paths (Harter und andere, 2020)",
  phyre: "Die Rätsel: PHYRE, ein Benchmark für physikalisches Denken (Bakhtin und andere, 2019)",
  keys: "Tasten",
  keyList: [
    ["← ↑ → ↓", "die Kugel bewegen; mit der Umschalttaste weiter"],
    ["+ -", "ihre Größe ändern"],
    ["Eingabe", "fallen lassen, dann weiter"],
    ["Leertaste", "anhalten oder abspielen"],
    [", .", "einen Schritt zurück oder vor"],
    ["R", "neuer Versuch"],
    ["Strg+Z Strg+Y", "rückgängig, wiederholen"],
    ["1 … 5", "die Bereiche"],
    ["[ ]", "das Rätsel davor und danach"],
  ],
  source: "Quelltext und Zitat",
  cite: "Pathlight ist quelloffen, unter der Apache-Lizenz 2.0. Wer es in der Forschung benutzt, kann es zitieren, und die Arbeiten, auf denen es beruht.",
  citation: "So wird es zitiert",
  licences: "Lizenzen von allem, was darin steckt",
};
