// Placing the ball: by pointer, wheel, keys, fields and links, with undo and redo.

import { NO_HISTORY, recorded, travelled } from "../undo.ts";
import { sameBall } from "../puzzle.ts";
import { MAX_RADIUS, MIN_RADIUS, SCENE_SIZE } from "../../pkg/constants.ts";
import type { Ball } from "../../pkg/page/pathlight.js";
import type { History } from "../undo.ts";
import type { State } from "../state.ts";

export type Point = readonly [x: number, y: number];

/** What undo returns to: the ball, and the line of a prediction. */
export interface Placed {
  readonly ball: Ball | null;
  readonly line: readonly Point[];
}

export interface Placement extends History<Placed> {
  readonly ball: Ball | null;
  readonly drag: Drag | null;
  /** Whether the ball has been dropped and waits for the model's ball. */
  readonly dropped: boolean;
}

/** A ball held by a pointer: by its centre, at an offset from the pointer, or by the knob on its rim. */
export interface Drag {
  readonly pointer: number;
  readonly grip: "centre" | "rim";
  readonly dx: number;
  readonly dy: number;
  /** The state to restore if the browser takes the pointer away. */
  readonly before: Pick<State, "placement" | "run">;
}

export const NO_BALL: Placement = { ...NO_HISTORY, ball: null, drag: null, dropped: false };
export const FIRST_RADIUS = 12;
/** Position at which the first key press places the ball. */
export const FIRST_BALL: Ball = [SCENE_SIZE / 2, SCENE_SIZE - 40, FIRST_RADIUS];

/** Places the ball, rounded and within the scene, or takes it away. Invalid placements are allowed and reported. */
export function place(state: State, to: Ball | null, gesture: string | null): State {
  const ball = to && within(to);
  return sameBall(ball, state.placement.ball) ? state : placing(recording(state, gesture), { ball });
}

/** Records ball and line before a change of either. */
export function recording(state: State, gesture: string | null): State {
  return { ...state, placement: { ...state.placement, ...recorded(state.placement, placed(state), gesture) } };
}

const placed = ({ placement: { ball }, sketch: { line } }: State): Placed => ({ ball, line });

/** Places the ball that a link names, if any; the route keeps the form of the link. */
export function placeLinked(state: State, ball: Ball | null): State {
  return ball ? { ...place(state, ball, null), route: state.route } : state;
}

export function nudge(state: State, dx: number, dy: number, dr: number, gesture: string): State {
  const { ball } = state.placement;
  return place(state, ball ? [ball[0] + dx, ball[1] + dy, ball[2] + dr] : FIRST_BALL, gesture);
}

export function resize(state: State, r: number, gesture: string): State {
  const [x, y] = state.placement.ball ?? FIRST_BALL;
  return place(state, [x, y, r], gesture);
}

export function undo(state: State): State {
  return travel(state, "past");
}

export function redo(state: State): State {
  return travel(state, "future");
}

/** Also ends a drag, which would otherwise move the ball back at once. */
function travel(state: State, to: "past" | "future"): State {
  const there = travelled(state.placement, to, placed(state));
  if (!there) return state;
  const { value, ...lists } = there;
  const placement = { ...lists, ball: value.ball, drag: null };
  return { ...placing(state, placement), sketch: { line: value.line, drawing: null } };
}

/** Handles a pointer going down: it grabs the knob or ball within its reach (px), or places the ball and grabs it. */
export function press(state: State, pointer: number, [x, y]: Point, reach: { knob: number; ball: number }): State {
  const { ball, drag } = state.placement;
  // Only the first pointer moves the ball: a palm or a second finger changes nothing.
  if (drag) return state;
  const before = { placement: state.placement, run: state.run };
  const toCentre = ball ? Math.hypot(x - ball[0], y - ball[1]) : Infinity;
  const toKnob = ball ? Math.hypot(x - ball[0] - ball[2], y - ball[1]) : Infinity;
  const held = (grip: Drag["grip"], dx: number, dy: number) => ({ drag: { pointer, grip, dx, dy, before } });
  if (ball && toKnob < reach.knob && toKnob < toCentre) return placing(state, { ...held("rim", 0, 0), gesture: null });
  if (ball && toCentre <= Math.max(ball[2], reach.ball))
    return placing(state, { ...held("centre", ball[0] - x, ball[1] - y), gesture: null });
  const moved = place(placing(state, { gesture: null }), [x, y, ball?.[2] ?? FIRST_RADIUS], gestureOf(pointer));
  return placing(moved, held("centre", 0, 0));
}

export function drag(state: State, pointer: number, [x, y]: Point): State {
  const { drag, ball } = state.placement;
  if (drag?.pointer !== pointer || !ball) return state;
  if (drag.grip === "centre") return place(state, [x + drag.dx, y + drag.dy, ball[2]], gestureOf(pointer));
  return place(state, [ball[0], ball[1], Math.hypot(x - ball[0], y - ball[1])], gestureOf(pointer));
}

/** Releases the pointer. An invalid ball moves to a free place nearby. */
export function release(state: State, pointer: number): State {
  const { drag, ball } = state.placement;
  if (drag?.pointer !== pointer) return state;
  const free = ball && state.puzzle.whyInvalid(ball) ? state.puzzle.nearestPlace(ball) : null;
  const settled = free ? place(state, free, gestureOf(pointer)) : state;
  return placing(settled, { drag: null, gesture: null });
}

/** Restores the state if the browser takes the pointer away to scroll. */
export function cancel(state: State, pointer: number): State {
  const { drag } = state.placement;
  return drag?.pointer === pointer ? { ...state, ...drag.before } : state;
}

/** Changes the placement, which ends the run. */
export function placing(state: State, change: Partial<Placement>): State {
  const placement = { ...state.placement, dropped: false, ...change };
  return leaveLastStep({ ...state, run: null, touring: false, placement });
}

/** Leaves the last step of the walkthrough when the person returns to their own ball. */
export function leaveLastStep(state: State): State {
  return state.route.step === "run" ? { ...state, route: { ...state.route, step: null } } : state;
}

export function gestureOf(pointer: number): string {
  return `pointer ${pointer}`;
}

function within([x, y, r]: Ball): Ball {
  return [clamp(x, 0, SCENE_SIZE - 1), clamp(y, 0, SCENE_SIZE - 1), clamp(r, MIN_RADIUS, MAX_RADIUS)];
}

function clamp(value: number, least: number, most: number): number {
  return Math.min(Math.max(Math.round(value), least), most);
}
