// What the model imagines: the walkthrough, the maps, and how they are made.

import { formatsOf } from "../formats.ts";
import { balls } from "./widths.ts";
import type { Point } from "../../core/change/placement.ts";
import type { Step } from "../../core/change/walkthrough.ts";
import type { MapName } from "../../pkg/page/pathlight.js";

const { counted, percent } = formatsOf("en-GB");
const place = ([x, y]: Point) => `x ${Math.round(x)}, y ${Math.round(y)}`;
const chanceOf = (chance: number) => (chance < 0.01 ? "under 1%" : percent(chance));

export const imagine = {
  tab: "Imagine",
  walkthrough: "How the model comes to its ball",
  tour: "Play the steps",
  stop: "Stop",
  all: "All",
  back: "Step back",
  next: "Next step",
  step: (number: number, name: string) => `Step ${number}: ${name}`,
  maps: "Maps over the scene",
  intro: "Before anything moves, five small nets imagine. Press a map to lay it over the scene.",
  how: "How?",

  steps: {
    base: ["If you do nothing", "Where green goes by itself."],
    target: ["What green must do", "A path for green that ends at its goal."],
    action: ["What red must do", "A path for the red ball that makes green go there."],
    placement: ["Where to start", "Where the red ball should start, and where it would work."],
    imagined: [
      "Forty futures",
      "Each line is a possible path of green, each with a different ball. The stronger the line, the better the odds.",
    ],
    run: [
      "What really happens",
      "The model drops its favourite ball. Dotted: what it imagined. Solid: what really happens.",
    ],
  } satisfies Record<Step, [name: string, meaning: string]>,
  /** The map of all places; the other maps are named like their steps. */
  works: "What works",
  /** The paper's names for them; it has no map of what works. */
  paper: {
    base: "base path",
    target: "target path",
    action: "action path",
    placement: "placement",
    success: "success",
  } satisfies Record<MapName, string>,
  hows: {
    base: "Its net sees only the scene, as pictures of 64 × 64 cells, one for each colour. For every cell it says how sure it is that green passes there.",
    target:
      "Its net sees only the scene too. It learned from solved puzzles which way green went there. It does not know the red ball yet.",
    action:
      "Its net sees the scene, the base path and the target path: what would happen, and what should. The difference is what the red ball has to do.",
    placement: "Its net sees the scene, the target path and the action path.",
    success:
      "A fifth net, which the paper does not have, says for eight sizes of ball at every place how likely such a ball solves the puzzle. The map shows the best size.",
    imagined:
      "The fifth net learned from balls of all kinds what happens after they drop. The most promising balls become candidates. For each it imagines where green and the ball would go, and how likely that solves the puzzle. The forty likeliest are drawn. Nothing is simulated.",
    run: "The ball runs in the same simulator as yours. The wider the ribbon around a dotted line, the less sure the model was. If the ball fails, balls much like it become less likely, and the likeliest of the rest is next.",
  } satisfies Record<MapName | Step, string>,

  /** A map for people who cannot see it. */
  path: (from: Point, to: Point) => `from ${place(from)} to ${place(to)}`,
  strongest: (at: Point) => `strongest at ${place(at)}`,
  considered: (count: number, likely: number) =>
    `It considered ${counted(count, "ball", "balls")}, and gives ${likely || "none"} of them more than 50%.`,
  waiting: "The model is thinking …",
  ended: (solved: boolean, chance: number) =>
    `It gave its ball ${chanceOf(chance)}, and ${solved ? "it works." : "it does not work."}`,
  off: (distance: number, radius: number) =>
    `The path it imagined for green was ${balls(distance, radius)} off, on average.`,
};
