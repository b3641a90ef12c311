// The person's result, as it is sent on.

import { modelSolvedAt, outcomeOf, playerSolvedAt, toldAttempts } from "./duel.ts";
import { isAlone } from "./hidden.ts";
import type { State } from "../state.ts";

export interface Result {
  /** Number of the ball that solved, and of the model's ball that did; null if none has. */
  readonly solvedAt: number | null;
  readonly modelAt: number | null;
  /** Number of balls that the model has dropped. */
  readonly modelBalls: number;
  /** Whether the person needed fewer balls than the model. */
  readonly isWon: boolean;
  /** The person's balls as signs: misses, then the solution. */
  readonly marks: string;
}

/** More misses than these are counted, not drawn. */
const MOST_MARKS = 20;

export function result(state: State): Result {
  const solvedAt = playerSolvedAt(state);
  const misses = (solvedAt ?? 1) - 1;
  const { length } = isAlone(state) ? [] : state.answers.turn;
  return {
    solvedAt,
    modelAt: modelSolvedAt(state),
    modelBalls: Math.min(length, toldAttempts(state).length),
    isWon: solvedAt !== null && outcomeOf(state, solvedAt, true) === "won",
    marks: `${misses > MOST_MARKS ? `${misses} × 🔴 ` : "🔴".repeat(misses)}🟢`,
  };
}
