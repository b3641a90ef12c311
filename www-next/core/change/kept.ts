// What the browser keeps, as one document: attempts by puzzle, and what the person has chosen.

import { sameBall } from "../puzzle.ts";
import { ATTEMPT_LIMIT } from "../../pkg/constants.ts";
import type { AttemptLine, CustomScene } from "../../pkg/page/pathlight.js";
import type { State } from "../state.ts";

export type Language = "en" | "de";
export type Theme = "light" | "dark";

export interface Kept extends Choices {
  readonly version: 1;
  /** The player's attempts by the key of their puzzle, in order. */
  readonly attempts: Readonly<Record<string, readonly AttemptLine[]>>;
  /** When all before was forgotten last, ms since 1970. */
  readonly forgotten: number;
  /** The custom puzzles by their key. */
  readonly puzzles: Readonly<Record<string, KeptPuzzle>>;
}

/** A custom puzzle; of two versions the later counts. */
export interface KeptPuzzle {
  /** Null: deleted. */
  readonly scene: CustomScene | null;
  /** When it was kept or deleted, ms since 1970. */
  readonly changed: number;
}

export interface Choices {
  /** Show the model's guess while the ball is placed. */
  readonly guess: boolean;
  /** Drop without the model. */
  readonly alone: boolean;
  /** Show what the model imagines of the scene while it is changed. */
  readonly live: boolean;
  /** Null: as the device has it. */
  readonly language: Language | null;
  readonly theme: Theme | null;
}

export const NOTHING_KEPT: Kept = {
  version: 1,
  attempts: {},
  puzzles: {},
  forgotten: 0,
  guess: true,
  alone: false,
  live: true,
  language: null,
  theme: null,
};

export function choose(state: State, choices: Partial<Choices>): State {
  return { ...state, kept: { ...state.kept, ...choices } };
}

/** Keeps custom puzzles by their keys, or deletes them. */
export function keepPuzzles(
  state: State,
  scenes: Readonly<Record<string, CustomScene | null>>,
  changed: number,
): State {
  const entries = Object.entries(scenes).map(([key, scene]) => [key, { scene, changed }] as const);
  return { ...state, kept: { ...state.kept, puzzles: { ...state.kept.puzzles, ...Object.fromEntries(entries) } } };
}

/** Another tab has kept something. */
export function mergeKept(state: State, theirs: Kept): State {
  const kept = merged(theirs, state.kept);
  // The round that is shown may have another number now.
  const moved = kept.attempts[state.puzzle.key]?.length !== state.kept.attempts[state.puzzle.key]?.length;
  return { ...state, kept, run: moved ? null : state.run };
}

/** Attempts from a file. */
export function addAttempts(state: State, attempts: Kept["attempts"]): State {
  return mergeKept(state, merged(state.kept, { ...state.kept, attempts }));
}

/** The first history, then what only the second knows; choices are those of the first. What was forgotten stays so. */
export function merged(one: Kept, other: Kept): Kept {
  if (one.forgotten !== other.forgotten) {
    const { attempts, forgotten } = one.forgotten > other.forgotten ? one : other;
    return { ...one, attempts, forgotten };
  }
  const attempts = { ...one.attempts };
  for (const [key, lines] of Object.entries(other.attempts)) attempts[key] = mergedLines(attempts[key] ?? [], lines);
  const puzzles = { ...one.puzzles };
  for (const [key, puzzle] of Object.entries(other.puzzles))
    if (!(puzzles[key] && puzzles[key].changed >= puzzle.changed)) puzzles[key] = puzzle;
  return { ...one, attempts, puzzles };
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
