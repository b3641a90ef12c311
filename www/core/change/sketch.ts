// Predicting: a person draws the path of the green object, starting at the object, and lets the scene run. Elsewhere in
// the scene the pointer places the ball, as in Play.

import { cancel, drag, gestureOf, nudge, placing, press, recording, release } from "./placement.ts";
import { drop, play } from "./run.ts";
import { MIN_RADIUS, SCENE_SIZE } from "../../pkg/constants.ts";
import { goal } from "../derived/placing.ts";
import type { Ball } from "../../pkg/page/pathlight.js";
import type { Point } from "./placement.ts";
import type { State } from "../state.ts";

export interface Sketch {
  /** Points from the middle of the object to the end of the line, px. */
  readonly line: readonly Point[];
  /** The pointer that draws, and the state to restore if the browser takes that pointer away. */
  readonly drawing: { readonly pointer: number; readonly before: Pick<State, "placement" | "run" | "sketch"> } | null;
}

export const NO_SKETCH: Sketch = { line: [], drawing: null };

/** Minimum length of a piece of a line, px. */
const PIECE = 2;
/** More points than a day of drawing needs. */
const MOST_POINTS = 4000;
/** How many times further an arrow key draws than it moves a ball. */
const STRIDE = 5;

/** Continues the line from the object or from its end; elsewhere places the ball. */
export function pressSketch(state: State, pointer: number, point: Point, reach: { knob: number; ball: number }): State {
  const { line, drawing } = state.sketch;
  if (drawing || state.placement.drag) return state;
  const isNear = ([x, y]: Point) => Math.hypot(point[0] - x, point[1] - y) < Math.max(reach.knob, PIECE * 4);
  const goesOn = line.length > 0 && isNear(line.at(-1)!);
  const isAtObject = isNear(start(state)) || [MIN_RADIUS, reach.knob].some((r) => overlapsObject(state, [...point, r]));
  if (!goesOn && !isAtObject) return press(state, pointer, point, reach);
  const before = { placement: state.placement, run: state.run, sketch: state.sketch };
  return sketching(state, { line: goesOn ? line : [start(state)], drawing: { pointer, before } }, gestureOf(pointer));
}

export function dragSketch(state: State, pointer: number, point: Point): State {
  return state.sketch.drawing?.pointer === pointer ? extended(state, point) : drag(state, pointer, point);
}

export function releaseSketch(state: State, pointer: number): State {
  if (state.sketch.drawing?.pointer !== pointer) return release(state, pointer);
  return { ...placing(state, { gesture: null }), sketch: { ...state.sketch, drawing: null } };
}

export function cancelSketch(state: State, pointer: number): State {
  const { drawing } = state.sketch;
  if (drawing?.pointer !== pointer) return cancel(state, pointer);
  return { ...state, ...drawing.before };
}

/** Draws by arrow keys. Other keys and the wheel resize the ball. */
export function nudgeSketch(state: State, dx: number, dy: number, dr: number, gesture: string): State {
  if (dr !== 0) return state.placement.ball ? nudge(state, 0, 0, dr, gesture) : state;
  const line = state.sketch.line.length > 0 ? state.sketch.line : [start(state)];
  const [x, y] = line.at(-1)!;
  return extended(sketching(state, { line, drawing: null }, gesture), [x + STRIDE * dx, y + STRIDE * dy]);
}

export function wipe(state: State): State {
  return sketching(state, NO_SKETCH, null);
}

/** Runs the scene, with the ball if there is one: an attempt, but not a duel. */
export function letRun(state: State): State {
  if (!canRun(state)) return state;
  return state.placement.ball ? drop(state, true) : play(state, [{ ball: null, of_model: false }], null, false);
}

export function canRun({ sketch, placement: { ball }, puzzle }: State): boolean {
  return sketch.line.length > 1 && (ball === null || puzzle.whyInvalid(ball) === null);
}

function extended(state: State, [x, y]: Point): State {
  const { line } = state.sketch;
  const next: Point = [Math.min(Math.max(x, 0), SCENE_SIZE), Math.min(Math.max(y, 0), SCENE_SIZE)];
  const [lastX, lastY] = line.at(-1)!;
  if (line.length >= MOST_POINTS || Math.hypot(next[0] - lastX, next[1] - lastY) < PIECE) return state;
  return { ...state, sketch: { ...state.sketch, line: [...line, next] } };
}

/** Changes the prediction, which ends the run. */
function sketching(state: State, sketch: Sketch, gesture: string | null): State {
  return { ...placing(recording(state, gesture), {}), sketch };
}

function start(state: State): Point {
  const [object] = goal(state);
  return [object.x, object.y];
}

function overlapsObject({ puzzle }: State, ball: Ball): boolean {
  const fault = puzzle.whyInvalid(ball);
  return fault?.kind === "overlaps" && fault.body === puzzle.scene.body1;
}
