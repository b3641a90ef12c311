// What pointer, wheel and keys do in the scene: place the ball, unless the panel has another tool.

import { shownPanel } from "../core/derived/hidden.ts";
import * as ball from "../core/change/placement.ts";
import * as bodies from "../core/change/make.ts";
import { cancelSketch, dragSketch, nudgeSketch, pressSketch, releaseSketch } from "../core/change/sketch.ts";
import { fits } from "../simulator.ts";
import { makingKey } from "./keys.ts";
import type { KeyFacts } from "./keys.ts";
import type { Point } from "../core/change/placement.ts";
import type { State } from "../core/state.ts";

/** Each function maps one state to the next; points are in px of the scene. */
export interface Tool {
  /** Handles a pointer going down; `reach` is the distance within which it grabs something, px. */
  press(state: State, pointer: number, point: Point, reach: { readonly knob: number; readonly ball: number }): State;
  drag(state: State, pointer: number, point: Point): State;
  release(state: State, pointer: number): State;
  /** Restores the state if the browser takes the pointer away. */
  cancel(state: State, pointer: number): State;
  /** Handles an arrow key, or a key or the wheel that changes the size. Moves of one gesture are undone together. */
  nudge(state: State, dx: number, dy: number, dr: number, gesture: string): State;
  undo(state: State): State;
  redo(state: State): State;
  /** Whether the person is handling something, so that wheel and swipes act on the scene. */
  holds(state: State): boolean;
  /** Handles a key that only this tool supports; null if it does not support the key. */
  key?(state: State, facts: KeyFacts, gesture: string): State | null;
}

const BALL: Tool = { ...ball, holds: ({ placement }) => placement.ball !== null };

/** Draws the path of the green object; away from it, places the ball. */
const SKETCH: Tool = {
  press: pressSketch,
  drag: dragSketch,
  release: releaseSketch,
  cancel: cancelSketch,
  nudge: nudgeSketch,
  undo: ball.undo,
  redo: ball.redo,
  holds: () => true,
};

const BODIES: Tool = {
  ...bodies,
  holds: () => true,
  key(state, facts, gesture) {
    const asked = makingKey(facts);
    switch (asked?.kind) {
      case "select":
        return bodies.selectNext(state, asked.by);
      case "turn":
        return bodies.turnBy(state, asked.degrees, gesture);
      case "duplicate":
        return bodies.duplicate(state, fits);
      case "remove":
        return bodies.remove(state);
      case "leave":
        return bodies.select(state, null);
      default:
        return null;
    }
  },
};

export function toolOf(state: State): Tool {
  const panel = shownPanel(state);
  return panel === "make" ? BODIES : panel === "predict" ? SKETCH : BALL;
}

/** The point that a pointer holds, which a finger covers. */
export function heldPoint({ placement: { drag, ball }, sketch }: State): Point | null {
  if (sketch.drawing) return sketch.line.at(-1)!;
  return drag && ball && (drag.grip === "rim" ? [ball[0] + ball[2], ball[1]] : [ball[0], ball[1]]);
}
