// Puzzles: their names, goals and bodies.

import { MAX_RADIUS, MIN_RADIUS, TEMPLATES } from "../../pkg/constants.ts";
import { GOAL_SECONDS, formatsOf } from "../formats.ts";
import type { Named } from "../../core/derived/bodies.ts";
import type { About, Body, InvalidBall } from "../../pkg/page/pathlight.js";

const { number } = formatsOf("en-GB");
const SHAPES: Record<Body["shape"], string> = {
  ball: "ball",
  bar: "bar",
  jar: "jar",
  standing_sticks: "standing sticks",
};
const kinds = new Map(TEMPLATES.map((template) => [template.id, template]));

const body = ({ role, shape }: Named) => `${role} ${SHAPES[shape]}`;
const placed = (one: Body) => `${body(one)} at x ${number(one.x)}, y ${number(one.y)}`;

export const puzzle = {
  name: ({ id, name }: Pick<About, "id" | "name">) =>
    id ? kinds.get(id.slice(0, 5))!.name : (name ?? "Custom puzzle"),
  /** What happens in the puzzle, and what to do. */
  instructions: ({ id }: About) => (id ? kinds.get(id.slice(0, 5))!.story : "This scene is homemade."),
  goal: (object: Body, target: Body) =>
    `Get the ${body(object)} to touch the ${body(target)} for ${GOAL_SECONDS} seconds.`,
  body,
  scene: (object: Body, target: Body, others: readonly Body[]) =>
    `256 by 256, y is up. The ${placed(object)}; the goal is the ${placed(target)}. ` +
    (others.length ? `Also: ${[...new Set(others.map(placed))].join("; ")}.` : "Nothing else."),
  ballAt: (x: number, y: number, r: number) => `Your ball is at x ${x}, y ${y}, with radius ${r}.`,
  fault: (fault: InvalidBall, bodies: readonly Body[]) =>
    fault.kind === "overlaps"
      ? `Not here: the ball overlaps the ${body(bodies[fault.body]!)}.`
      : fault.kind === "outside"
        ? "Not here: too close to the edge."
        : `The radius of the ball is ${MIN_RADIUS} to ${MAX_RADIUS}.`,
};
