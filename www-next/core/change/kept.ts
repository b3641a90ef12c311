// What the browser keeps, as one document: attempts by puzzle, and what the person has chosen.

import { sameBall } from "../puzzle.ts";
import { ATTEMPT_LIMIT } from "../../pkg/constants.ts";
import type { AttemptLine } from "../../pkg/page/pathlight.js";
import type { State } from "../state.ts";

export type Language = "en" | "de";
export type Theme = "light" | "dark";

export interface Kept extends Choices {
  readonly version: 1;
  /** The player's attempts by the key of their puzzle, in order. */
  readonly attempts: Readonly<Record<string, readonly AttemptLine[]>>;
}

export interface Choices {
  /** Show the model's guess while the ball is placed. */
  readonly guess: boolean;
  /** Drop without the model. */
  readonly alone: boolean;
  /** Null: as the device has it. */
  readonly language: Language | null;
  readonly theme: Theme | null;
}

export const NOTHING_KEPT: Kept = { version: 1, attempts: {}, guess: true, alone: false, language: null, theme: null };

export function choose(state: State, choices: Partial<Choices>): State {
  return { ...state, kept: { ...state.kept, ...choices } };
}

/** Another tab has kept something. */
export function mergeKept(state: State, theirs: Kept): State {
  const kept = merged(theirs, state.kept);
  // The round that is shown may have another number now.
  const moved = kept.attempts[state.puzzle.key]?.length !== state.kept.attempts[state.puzzle.key]?.length;
  return { ...state, kept, run: moved ? null : state.run };
}

/** The first history, then what only the second knows; choices are those of the first. */
export function merged(one: Kept, other: Kept): Kept {
  const attempts = { ...one.attempts };
  for (const [key, lines] of Object.entries(other.attempts)) attempts[key] = mergedLines(attempts[key] ?? [], lines);
  return { ...one, attempts };
}

/** No attempt is lost, but beyond the limit; then those that solved come before others. */
function mergedLines(one: readonly AttemptLine[], other: readonly AttemptLine[]): readonly AttemptLine[] {
  const added = other.filter((line) => !one.some(({ ball }) => sameBall(ball, line.ball)));
  const all = [...one, ...added];
  if (all.length <= ATTEMPT_LIMIT) return all;
  let spare = all.length - ATTEMPT_LIMIT;
  const isDropped = all.toReversed().map((line) => line.status !== "solved" && spare > 0 && spare-- > 0);
  return all.filter((_, index) => !isDropped[all.length - 1 - index]).slice(0, ATTEMPT_LIMIT);
}
