// The document that the browser keeps: attempts by puzzle, and the person's choices.

import { ATTEMPT_LIMIT } from "../../pkg/constants.ts";
import type { AttemptLine, CustomScene, Setup } from "../../pkg/page/pathlight.js";
import type { Language } from "../../text/languages.ts";
import type { State } from "../state.ts";

export type Theme = "light" | "dark";

export interface Kept extends Choices {
  readonly version: 1;
  /** The player's attempts by the key of their puzzle, in order. */
  readonly attempts: Attempts;
  /** When everything was last forgotten, ms since 1970: older attempts do not come back from another tab. */
  readonly forgotten: number;
  /** Custom puzzles by their key. */
  readonly puzzles: Readonly<Record<string, KeptPuzzle>>;
}

/** A custom puzzle. Of two versions, the later one counts. */
export interface KeptPuzzle {
  /** Null if deleted. */
  readonly scene: CustomScene | null;
  /** When it was kept or deleted, ms since 1970. */
  readonly changed: number;
}

export type Attempts = Readonly<Record<string, readonly AttemptLine[]>>;

export interface Choices {
  /** Show the model's guess while the ball is placed. */
  readonly guess: boolean;
  /** Drop without the model. */
  readonly alone: boolean;
  /** Which model plays. */
  readonly model: Setup;
  /** Show the model's maps of the scene while it is being changed. */
  readonly live: boolean;
  /** Null to follow the device. */
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
  model: "within",
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

/** Merges what another tab has kept. */
export function mergeKept(state: State, theirs: Kept): State {
  return withKept(state, merged(theirs, state.kept));
}

/** Adds the attempts of a file to those kept. */
export function openAttempts(state: State, attempts: Attempts): State {
  return withKept(state, merged(state.kept, { ...state.kept, attempts }));
}

export function attemptCount(attempts: Attempts): number {
  return Object.values(attempts).reduce((sum, lines) => sum + lines.length, 0);
}

/** Replaces what is kept, and ends the run if the attempts changed: its round may have another number. */
function withKept(state: State, kept: Kept): State {
  const moved = kept.attempts[state.puzzle.key]?.length !== state.kept.attempts[state.puzzle.key]?.length;
  return { ...state, kept, run: moved ? null : state.run };
}

/** Merges two documents: histories, first before second; choices of the first. Forgotten attempts stay forgotten. */
export function merged(one: Kept, other: Kept): Kept {
  const puzzles = { ...one.puzzles };
  for (const [key, puzzle] of Object.entries(other.puzzles))
    if (!(puzzles[key] && puzzles[key].changed >= puzzle.changed)) puzzles[key] = puzzle;
  if (one.forgotten !== other.forgotten) {
    const { attempts, forgotten } = one.forgotten > other.forgotten ? one : other;
    return { ...one, attempts, forgotten, puzzles };
  }
  const attempts = { ...one.attempts };
  for (const [key, lines] of Object.entries(other.attempts)) attempts[key] = mergedLines(attempts[key] ?? [], lines);
  return { ...one, attempts, puzzles };
}

/** Keeps all attempts up to the limit. Beyond it, attempts that solved come first. */
function mergedLines(one: readonly AttemptLine[], other: readonly AttemptLine[]): readonly AttemptLine[] {
  const balls = new Set<string>();
  // Keep the first attempt with each ball: a file may have it twice.
  const all = [...one, ...other].filter(({ ball }) => balls.size < balls.add(String(ball)).size);
  if (all.length <= ATTEMPT_LIMIT) return all;
  let spare = all.length - ATTEMPT_LIMIT;
  const isDropped = all.toReversed().map((line) => line.status !== "solved" && spare > 0 && spare-- > 0);
  return all.filter((_, index) => !isDropped[all.length - 1 - index]).slice(0, ATTEMPT_LIMIT);
}
