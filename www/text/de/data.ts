// The panel Data: numbers and files.

import { formatsOf } from "../formats.ts";
import type { Text } from "../text.ts";

const { counted, number, percent } = formatsOf("de");

export const data: Text["data"] = {
  tab: "Daten",
  ball: "Kugel",
  axes: { x: "x", y: "y", r: "Radius" },
  run: "Vorgestellt und wirklich",
  noRun: "Lass eine Kugel fallen: Dann steht hier in Zahlen, wie gut die Vorstellung war.",
  green: "Grün",
  red: "Rot",
  off: "Grün daneben um",
  you: "Deine Kugel",
  model: "Kugel des Modells",
  alone: "Ohne Kugel",
  agreement: percent,
  px: (distance) => `${number(distance, 1)}\u00a0px`,
  explained:
    "Prozente: wie gut die vorgestellten Bahnen die wirklichen decken, Schnitt durch Vereinigung auf 64 × 64 Feldern; ohne Kugel die Grundbahn, sonst Ziel- und Aktionsbahn. Abstand: zwischen dem, was sich das Modell für genau deine Kugel vorgestellt hat, und dem, was geschah, im Schnitt.",
  saveMaps: "Karten als Bild speichern",
  attempts: "Deine Versuche",
  kept: (count) =>
    `${counted(count, "Versuch", "Versuche")}, nur in diesem Browser. Safari löscht sie nach sieben Tagen ohne Besuch, andere Browser, wenn die Platte voll ist; eine Datei bleibt.`,
  save: "Speichern",
  open: "Datei öffnen",
  table: "Dieses Rätsel als CSV",
};
