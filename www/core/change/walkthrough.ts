// The walkthrough: how the model chooses its ball, in six steps. The last step plays that ball.

import { shownPanel } from "../derived/hidden.ts";
import { introShown } from "../derived/home.ts";
import { play } from "./run.ts";
import type { MapName } from "../../pkg/page/pathlight.js";
import type { State } from "../state.ts";

export const STEPS = ["base", "target", "action", "placement", "imagined", "run"] as const;
export type Step = (typeof STEPS)[number];

/** The maps that each step shows over the scene. */
export const STEP_LAYERS: Record<Step, readonly MapName[]> = {
  base: ["base"],
  target: ["target"],
  action: ["action"],
  placement: ["placement", "success"],
  imagined: [],
  run: [],
};

/** Goes to a step; null shows everything together. An earlier run is not drawn over the maps of a step. */
export function goTo(state: State, step: Step | null): State {
  const run = step === null ? state.run : null;
  return arrived({ ...state, run, touring: false, route: { ...state.route, step } });
}

/** Goes forward by some steps. Before the first step is everything together. */
export function go(state: State, by: number): State {
  const index = stepIndex(state) + by;
  return goTo(state, STEPS[Math.min(Math.max(index, -1), STEPS.length - 1)] ?? null);
}

/** Returns -1 for everything together. */
export function stepIndex({ route: { step } }: State): number {
  return step ? STEPS.indexOf(step) : -1;
}

/** Starts the tour, from the first step after everything together or the last step; or stops it. */
export function toggleTour(state: State): State {
  if (state.touring) return { ...state, touring: false };
  const isBetween = stepIndex(state) >= 0 && state.route.step !== "run";
  return { ...(isBetween ? state : goTo(state, "base")), touring: true };
}

/** Moves on once the current step has been seen. */
export function tourOn(state: State): State {
  return state.route.step === "run" ? { ...state, touring: false } : { ...go(state, 1), touring: true };
}

export function atLastStep(state: State): boolean {
  return state.route.step === "run" && shownPanel(state) === "imagine";
}

/**
 * Plays the model's first ball where that is due, once it is known. Elsewhere stops what only the walkthrough plays.
 */
export function arrived(state: State): State {
  if (introShown(state)) return state;
  const plays = state.run?.round === null && state.run.balls[0]!.of_model;
  if (plays === atLastStep(state)) return state;
  const first = atLastStep(state) ? state.answers.turn[0] : undefined;
  const still = plays || atLastStep(state) ? { ...state, run: null } : state;
  return first ? play(still, [{ ball: first.ball, of_model: true }], null, false) : still;
}
