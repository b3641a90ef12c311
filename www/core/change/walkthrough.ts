// The walkthrough: how the model comes to its ball, in six steps. The last plays that ball.

import { shownPanel } from "../derived/hidden.ts";
import { introShown } from "../derived/home.ts";
import { play } from "./run.ts";
import type { MapName } from "../../pkg/page/pathlight.js";
import type { State } from "../state.ts";

export const STEPS = ["base", "target", "action", "placement", "imagined", "run"] as const;
export type Step = (typeof STEPS)[number];

/** The maps that each step lays over the scene. */
export const STEP_LAYERS: Record<Step, readonly MapName[]> = {
  base: ["base"],
  target: ["target"],
  action: ["action"],
  placement: ["placement", "success"],
  imagined: [],
  run: [],
};

/** Goes to a step; null: all together. What ran before does not lie over what a step imagines. */
export function goTo(state: State, step: Step | null): State {
  const run = step === null ? state.run : null;
  return arrived({ ...state, run, touring: false, route: { ...state.route, step } });
}

/** Goes some steps further; before the first are all together. */
export function go(state: State, by: number): State {
  const index = stepIndex(state) + by;
  return goTo(state, STEPS[Math.min(Math.max(index, -1), STEPS.length - 1)] ?? null);
}

/** -1 for all together. */
export function stepIndex({ route: { step } }: State): number {
  return step ? STEPS.indexOf(step) : -1;
}

/** Goes on by itself, from the first step after all together or the last; or stops. */
export function toggleTour(state: State): State {
  if (state.touring) return { ...state, touring: false };
  const isBetween = stepIndex(state) >= 0 && state.route.step !== "run";
  return { ...(isBetween ? state : goTo(state, "base")), touring: true };
}

/** The present step has been seen. */
export function tourOn(state: State): State {
  return state.route.step === "run" ? { ...state, touring: false } : { ...go(state, 1), touring: true };
}

export function atLastStep(state: State): boolean {
  return state.route.step === "run" && shownPanel(state) === "imagine";
}

/**
 * Plays the model's first ball where that is due, once it is known; elsewhere nothing that only the walkthrough plays.
 */
export function arrived(state: State): State {
  if (introShown(state)) return state;
  const plays = state.run?.round === null && state.run.balls[0]!.of_model;
  if (plays === atLastStep(state)) return state;
  const first = atLastStep(state) ? state.answers.turn[0] : undefined;
  const still = plays || atLastStep(state) ? { ...state, run: null } : state;
  return first ? play(still, [{ ball: first.ball, of_model: true }], null, false) : still;
}
