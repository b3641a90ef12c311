// Making a puzzle: its bodies, its problems, keeping and sharing it.

import { formatsOf } from "../formats.ts";
import { puzzle } from "./puzzle.ts";
import type { Named, NamedProblem, Role, Shape, Size } from "../../core/derived/bodies.ts";

const { number } = formatsOf("en-GB");

const SIZES: Record<Size, string> = { radius: "radius", length: "length", thickness: "thickness", height: "height" };
const px = (length: number) => (Math.abs(length) < 1e5 ? number(length, length % 1 ? 1 : 0) : length.toExponential(0));
const the = (body: Named | null) => `the ${puzzle.body(body!)}`;

export const make = {
  tab: "Make",
  hint: "Drag a body to move it. Tap it for handles: the square one resizes, the round one turns.",
  broken: "Not playable yet: see what is ringed in red.",
  watch: "Watch without a ball",

  add: "Add a body",
  shapes: { ball: "+ Ball", bar: "+ Bar", jar: "+ Jar", standing_sticks: "+ Sticks" } satisfies Record<Shape, string>,
  empty: "Start empty",
  selected: "Selected body",
  duplicate: "Duplicate",
  remove: "Delete",
  role: "It is",
  roles: {
    green: "green: has to reach the goal",
    blue: "blue: the goal, and moves",
    purple: "purple: the goal, and stays",
    gray: "gray: moves",
    black: "black: stays",
  } satisfies Record<Role, string>,

  details: "Details",
  body: "Body",
  nothing: "none selected",
  named: (body: Named, index: number) => `${index + 1}: ${puzzle.body(body)}`,
  angle: "angle",
  sizes: SIZES,
  keys: "Keys in the scene: N and P select, arrows move, comma and full stop turn, + and − resize, with Shift further; D duplicates, Delete removes, Ctrl+Z undoes.",
  /** For a screen reader. */
  described: (body: Named, x: number, y: number, degrees: number, sizes: readonly (readonly [Size, number])[]) =>
    `Selected: the ${puzzle.body(body)} at x ${px(x)}, y ${px(y)}, turned by ${px(degrees)} degrees, ` +
    `${sizes.map(([size, value]) => `${SIZES[size]} ${px(value)}`).join(", ")}.`,

  live: "Show where the model expects green to go",
  name: "Name",
  changed: (name: string) => `${name}, changed`,
  keep: "Keep in this browser",
  kept: "Kept in this browser",
  save: "Save as a file",
  open: "Open a file",
  link: "The address of this page holds your whole puzzle: whoever opens the link plays it.",
  yours: (count: number) => `Your puzzles (${number(count)})`,
  forget: (name: string) => `Delete “${name}”`,

  problem: ({ fault, body, other }: NamedProblem): string => {
    switch (fault.kind) {
      case "unreadable":
        return "It is no scene of Pathlight.";
      case "own_goal":
        return "Green cannot be its own goal: choose another goal.";
      case "static_object":
        return "Green has to move, or it never reaches a goal.";
      case "bodies":
        return fault.count > fault.most
          ? `It has more than ${fault.most} bodies: remove some.`
          : `It needs at least ${fault.least} bodies: add one.`;
      case "name":
        return `The name is longer than ${fault.most} characters.`;
      case "place":
        return `There is no valid place for ${the(body)}.`;
      case "length":
        return `The ${SIZES[fault.key]} of ${the(body)} has to be ${px(fault.least)} to ${px(fault.most)}.`;
      case "sticks_out":
      case "sticks_out_of_corner":
        return `Sticks out by ${px(fault.by)} px: move it inside, or make it smaller.`;
      case "outside":
        return `${px(fault.by)} px outside the scene: move it nearer, or delete it.`;
      case "overlap":
        return `Overlaps ${the(other)} by ${px(fault.by)} px: move them apart.`;
    }
  },
};
