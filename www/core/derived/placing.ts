// Derived from the ball being placed: whether it is valid, and what the model imagines for it.

import { atLastStep } from "../change/walkthrough.ts";
import { isHidden, shownPanel } from "./hidden.ts";
import { sameBall } from "../puzzle.ts";
import type { Ball, Body, InvalidBall } from "../../pkg/page/pathlight.js";
import type { Answers } from "../change/model.ts";
import type { State } from "../state.ts";

export function fault({ puzzle, placement: { ball } }: State): InvalidBall | null {
  return ball && puzzle.whyInvalid(ball);
}

/** The green object and its goal. */
export function goal({ puzzle: { scene } }: State): [object: Body, target: Body] {
  return [scene.bodies[scene.body1]!, scene.bodies[scene.body2]!];
}

/**
 * The ball to ask the model about: the one being placed, or the player's ball in the run; at the end of the
 * walkthrough, the model's.
 */
export function questioned(state: State): Ball | null {
  if (state.run) return state.run.balls.find(({ of_model }) => of_model === atLastStep(state))?.ball ?? null;
  return fault(state) ? null : state.placement.ball;
}

/** Whether the answer is used anywhere. */
export function wantsGuess(state: State): boolean {
  return (state.kept.guess && !isHidden(state, "guess")) || shownPanel(state) === "predict" || atLastStep(state);
}

/** What the model imagines for that ball; while it is dragged, for its position a moment ago. */
export function guess(state: State): Answers["guess"] {
  const asked = questioned(state);
  const { guess } = state.answers;
  return asked && guess && (state.placement.drag || sameBall(asked, guess.of)) ? guess : null;
}

/** The solutions of the selected radius, as far as they are known. */
export function solutions({ check, answers }: State): Answers["solutions"] {
  return check && answers.solutions?.radius === check.radius ? answers.solutions : null;
}
