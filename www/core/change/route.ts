// The route: what a link names, and the parts of a link. `opening.ts` opens its puzzle.

import { NO_ANSWERS } from "./model.ts";
import { introOf } from "./home.ts";
import { NO_SKETCH } from "./sketch.ts";
import { arrived } from "./walkthrough.ts";
import { NO_BALL, placeLinked } from "./placement.ts";
import { shownLayers } from "../derived/imagined.ts";
import type { Ball, MapName } from "../../pkg/page/pathlight.js";
import type { Step } from "./walkthrough.ts";
import type { Puzzle } from "../puzzle.ts";
import type { State } from "../state.ts";
import type { Text } from "../../text/languages.ts";

/** A panel next to the scene: the texts name it on its tab, and view/panels.ts shows it. */
export type Panel = keyof Text["tabs"];

/** All panels, in the order of their tabs. */
export const panelsOf = ({ tabs }: Text): Panel[] => Object.keys(tabs) as Panel[];

/** A part that a lesson may hide: the ways to other puzzles, the model's guess, the model altogether, a panel. */
export type Hideable = "puzzles" | "guess" | "model" | Panel;

export const hideable = (text: Text): Hideable[] => ["puzzles", "guess", "model", ...panelsOf(text)];

export interface Route {
  /** "00007:008"; null for the home page or a custom scene. */
  readonly task: string | null;
  /** A custom scene as text (core/scene-text.ts); null if a task is open. */
  readonly scene: string | null;
  readonly panel: Panel;
  /** The maps over the scene. */
  readonly layers: readonly MapName[];
  /** "presentation" shows the scene and one sentence in large type. */
  readonly view: "presentation" | null;
  /** Number of the ball with which the sender of the link solved the puzzle. */
  readonly challenge: number | null;
  /** The puzzles of a lesson, in order; the ways to other puzzles lead through them. */
  readonly lesson: readonly string[];
  readonly hide: readonly Hideable[];
  /** The step of the walkthrough; null shows everything that the model imagines. */
  readonly step: Step | null;
}

/** A route as in a link, with the ball to place. */
export interface Link extends Route {
  readonly ball: Ball | null;
}

export const START: Link = {
  task: null,
  scene: null,
  panel: "play",
  layers: [],
  step: null,
  view: null,
  challenge: null,
  lesson: [],
  hide: [],
  ball: null,
};

/** The link from here to another task or scene. */
export function linkTo({ route }: State, named: Partial<Pick<Route, "task" | "scene">>): Link {
  // The last step of the walkthrough would play the model's ball at once.
  const step = route.step === "run" ? null : route.step;
  return { ...route, task: null, scene: null, step, challenge: null, ball: null, ...named };
}

/** Moves within the open puzzle. The ball stays where it is unless the link names one. */
export function routed(state: State, { ball, ...route }: Link): State {
  return arrived(placeLinked({ ...state, route, notice: null, dialog: null }, ball));
}

/** Moves to another puzzle, which has been opened. */
export function opened(state: State, { ball, ...route }: Link, puzzle: Puzzle): State {
  const first = { placement: NO_BALL, run: null, answers: NO_ANSWERS, check: null, sketch: NO_SKETCH, make: null };
  const there = { ...state, route, puzzle, ...first };
  const home = { intro: introOf(route, puzzle), dialog: null, notice: null };
  return { ...placeLinked(there, ball), ...home };
}

/** Opens a panel. Predict and Make need the scene as it was before a run; the others go on with the run. */
export function openPanel(state: State, panel: Panel): State {
  const { panel: from } = state.route;
  const isOther = panel !== from && [from, panel].some((one) => one === "predict" || one === "make");
  return arrived({ ...state, run: isOther ? null : state.run, touring: false, route: { ...state.route, panel } });
}

/** Starts or ends the presentation. */
export function present(state: State, view: Route["view"]): State {
  return { ...state, route: { ...state.route, view }, dialog: null };
}

/** Shows or hides a map over the scene, starting from the maps of the current step of the walkthrough. */
export function toggleLayer(state: State, name: MapName): State {
  const layers = shownLayers(state);
  const others = layers.filter((layer) => layer !== name);
  const now = others.length < layers.length ? others : [...others, name];
  return arrived({ ...state, touring: false, route: { ...state.route, layers: now, step: null } });
}
