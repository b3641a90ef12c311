// Derived from the run that the scene plays.

import type { RolloutFacts } from "../../pkg/page/pathlight.js";
import type { State } from "../state.ts";

/** The rollouts of the balls in the run, the player's first. */
export function rollouts({ puzzle, run }: State): RolloutFacts[] {
  return (run?.balls ?? []).map(({ ball }) => puzzle.rollout(ball));
}

/** The last step at which anything changes in any rollout. */
export function lastStep(state: State): number {
  return Math.max(0, ...rollouts(state).map(({ last }) => last));
}

export function ended(state: State): boolean {
  return state.run !== null && state.run.step >= lastStep(state);
}
