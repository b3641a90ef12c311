// Paints over a scene being made: ring and knobs of the selected body, and rings around bodies with a problem.

import { circleOf, knobsOf } from "../core/derived/bodies.ts";
import { DARK_PALETTE, LIGHT_PALETTE, SCENE_SIZE } from "../pkg/constants.ts";
import type { Point } from "../core/change/placement.ts";
import type { CustomBody } from "../pkg/page/pathlight.js";

/** Radius of a knob, CSS px. */
export const KNOB = 7;
/** Distance of a ring from its body, px. */
const GAP = 3;

/** `unit` is the size of a CSS px in px of the scene. */
export function paintKnobs(
  context: CanvasRenderingContext2D,
  selected: CustomBody | null,
  troubled: readonly CustomBody[],
  unit: number,
  dark: boolean,
): void {
  const { ink, paper, red } = dark ? DARK_PALETTE : LIGHT_PALETTE;
  const { width } = context.canvas;
  context.save();
  context.setTransform(width / SCENE_SIZE, 0, 0, -width / SCENE_SIZE, 0, width);
  context.globalAlpha = 1;
  for (const body of troubled) ring(body, red, [], 2);
  if (selected) {
    ring(selected, ink, [4 * unit, 3 * unit], 1.5);
    const { size, turn } = knobsOf(selected);
    // A square knob resizes, a round one turns.
    const half = 0.85 * KNOB * unit;
    knob(size, ([x, y]) => context.rect(x - half, y - half, 2 * half, 2 * half));
    if (turn) knob(turn, ([x, y]) => context.arc(x, y, KNOB * unit, 0, 2 * Math.PI));
  }
  context.restore();

  function ring(body: CustomBody, colour: string, dashes: number[], lineWidth: number): void {
    context.beginPath();
    if (body.shape === "bar") {
      const [w, h] = [body.length / 2 + GAP, body.thickness / 2 + GAP];
      context.save();
      context.translate(body.x, body.y);
      context.rotate(body.angle);
      context.rect(-w, -h, 2 * w, 2 * h);
      context.restore();
    } else {
      const { centre, radius } = circleOf(body);
      context.arc(...centre, radius + GAP, 0, 2 * Math.PI);
    }
    context.setLineDash(dashes);
    context.strokeStyle = colour;
    context.lineWidth = lineWidth * unit;
    context.stroke();
    context.setLineDash([]);
  }

  function knob(at: Point, outline: (at: Point) => void): void {
    context.beginPath();
    outline(at);
    context.fillStyle = paper;
    context.fill();
    context.strokeStyle = ink;
    context.lineWidth = 1.5 * unit;
    context.stroke();
  }
}
