// Scores a prediction: the drawn path and the model's, each compared with the real one.

import { shownPanel } from "./hidden.ts";
import { overlap } from "./imagined.ts";
import { goal, guess } from "./placing.ts";
import { ended } from "./run.ts";
import type { Ball } from "../../pkg/page/pathlight.js";
import type { State } from "../state.ts";

/** Agreement, 0..1; the model's is null while it has imagined nothing. */
export interface Prediction {
  readonly you: number;
  readonly model: number | null;
}

/** Returns null until the predicted scene has run. */
export function prediction(state: State): Prediction | null {
  const { sketch, run, puzzle } = state;
  if (shownPanel(state) !== "predict" || sketch.line.length < 2) return null;
  if (!ended(state) || run!.balls[0]!.of_model) return null;
  const { ball } = run!.balls[0]!;
  const real = puzzle.pathMasks(ball).object;
  const model = modelMask(state, ball);
  return {
    you: overlap(puzzle.sketchMask(Float64Array.from(sketch.line.flat())), real),
    model: model && overlap(model, real),
  };
}

/** With a ball, the path that the model imagines for it; without one, its base path. */
function modelMask(state: State, ball: Ball | null): Float32Array | null {
  if (!ball) return state.answers.maps?.base ?? null;
  const imagined = guess(state)?.imagined;
  const [{ x, y }] = goal(state);
  return imagined ? state.puzzle.sketchMask(Float64Array.of(x, y, ...imagined.object)) : null;
}
