// The panel Data: numbers and files.

import { formatsOf } from "../formats.ts";

const { counted, number, percent } = formatsOf("en-GB");

export const data = {
  tab: "Data",
  ball: "Ball",
  axes: { x: "x", y: "y", r: "radius" },
  run: "Imagined and real",
  noRun: "Drop a ball: here you will see in numbers how well it was imagined.",
  green: "Green",
  red: "Red",
  off: "Green, off by",
  you: "Your ball",
  model: "The model’s ball",
  alone: "Without a ball",
  agreement: percent,
  px: (distance: number) => `${number(distance, 1)}\u00a0px`,
  explained:
    "Percentages: how well the imagined paths cover the real ones, intersection over union on 64 × 64 cells; without a ball the base path, else target and action path. Distance: between what the model imagined for your very ball and what happened, on average.",
  saveMaps: "Save the maps as a picture",
  attempts: "Your attempts",
  kept: (count: number) =>
    `${counted(count, "attempt", "attempts")}, kept in this browser alone. Safari deletes them after seven days without a visit, other browsers if the disk is full; a file stays.`,
  save: "Save",
  open: "Open a file",
  table: "This puzzle as CSV",
};
