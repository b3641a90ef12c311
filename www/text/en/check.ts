// The check: where balls of a radius work, and the search for an easy one.

import { formatsOf } from "../formats.ts";
import type { FoundSolutions } from "../../pkg/page/pathlight.js";

const { counted, number, percent } = formatsOf("en-GB");

export const check = {
  show: "Show every place that works",
  offer: "Three misses: would you like to see where a ball works?",
  radius: "Radius of the balls",
  /** `working`: the share of the places where a ball works. */
  tried: (progress: number, working: number) =>
    (progress < 1
      ? `${percent(progress)} tried.`
      : working === 0
        ? "No ball of this size works."
        : `A ball of this size works at ${working < 0.01 ? "less than 1%" : percent(working)} of all places.`) +
    `${working === 0 && progress === 1 ? "" : " Yellow: works."} Striped: no room for the ball.`,
  compare: "Compare with the model’s guess",
  agrees: (share: number) => `${percent(share)} of its guess lies where a ball works.`,
  seek: "Show a solution",
  stop: "Stop looking",
  found: ({ progress, valid, solved, rank, easiest, solves_itself }: FoundSolutions) =>
    [
      solves_itself ? "It solves itself, without any ball." : "",
      progress < 1
        ? `Looking for an easy ball: ${percent(progress)}.`
        : easiest
          ? `${number(solved)} of ${counted(valid, "ball", "balls")} work. An easy one lies in the scene now.`
          : `None of ${counted(valid, "ball", "balls")} works, of all places and sizes. One in between still might.`,
      progress === 1 && easiest && rank !== null ? `${percent(rank)} of Pathlight’s puzzles are harder.` : "",
    ]
      .filter(Boolean)
      .join(" "),
};
