// The route: what the address names. `actions.ts` opens its puzzle.

import { NO_ANSWERS } from "./model.ts";
import { NO_BALL, place } from "./placement.ts";
import type { Ball, MapName } from "../../pkg/page/pathlight.js";
import type { Puzzle } from "../puzzle.ts";
import type { State } from "../state.ts";

/** The panels beside the scene, in the order of their tabs; view/panels.ts shows them. */
export const PANELS = ["play", "make"] as const;
export type Panel = (typeof PANELS)[number];

export interface Route {
  /** "00007:008"; null: none is named. */
  readonly task: string | null;
  /** A custom scene as text (core/scene-link.ts); null: a task is open. */
  readonly scene: string | null;
  readonly panel: Panel;
  /** The maps over the scene. */
  readonly layers: readonly MapName[];
}

/** A route as a link has it, with the ball to place. */
export interface Link extends Route {
  readonly ball: Ball | null;
}

export const START: Link = { task: null, scene: null, panel: "play", layers: [], ball: null };

/** Goes elsewhere within the open puzzle. A ball that the link does not name stays where it is. */
export function routed(state: State, { ball, ...route }: Link): State {
  const there = { ...state, route, notice: null };
  return ball ? place(there, ball, null) : there;
}

/** Goes to another puzzle, which has been opened. */
export function opened(state: State, { ball, ...route }: Link, puzzle: Puzzle): State {
  const there = {
    ...state,
    route,
    puzzle,
    placement: NO_BALL,
    run: null,
    answers: NO_ANSWERS,
    check: null,
    make: null,
  };
  return { ...(ball ? place(there, ball, null) : there), notice: null };
}

export function openPanel(state: State, panel: Panel): State {
  return { ...state, route: { ...state.route, panel } };
}

/** Lays a map over the scene, or takes it away. */
export function toggleLayer(state: State, name: MapName): State {
  const { layers } = state.route;
  const others = layers.filter((layer) => layer !== name);
  return { ...state, route: { ...state.route, layers: others.length < layers.length ? others : [...others, name] } };
}
