// What pointer, wheel and keys do in the scene: place the ball, unless the panel has another tool.

import { cancel, drag, nudge, press, release } from "../core/change/placement.ts";
import type { Point } from "../core/change/placement.ts";
import type { State } from "../core/state.ts";

/** Each function leads from one state to the next; points are px of the scene. */
export interface Tool {
  /** A pointer goes down, within whose reach something may be grabbed, px. */
  press(state: State, pointer: number, point: Point, reach: { readonly knob: number; readonly ball: number }): State;
  drag(state: State, pointer: number, point: Point): State;
  release(state: State, pointer: number): State;
  /** The browser takes the pointer away: nothing has happened. */
  cancel(state: State, pointer: number): State;
  /** An arrow key, or a key or the wheel that changes the size. Moves of one gesture are undone together. */
  nudge(state: State, dx: number, dy: number, dr: number, gesture: string): State;
}

const BALL: Tool = { press, drag, release, cancel, nudge };

export function toolOf(_: State): Tool {
  return BALL;
}
