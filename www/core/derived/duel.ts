// Derived from the attempts of player and model: the list, the verdict, and the next action of the large button.

import { ATTEMPT_LIMIT } from "../../pkg/constants.ts";
import { guess } from "./placing.ts";
import { canGoOn, endsLesson, isAlone, shownPanel } from "./hidden.ts";
import { introShown } from "./home.ts";
import { ended, rollouts } from "./run.ts";
import { sameBall } from "../puzzle.ts";
import type { AttemptLine, Luck, RolloutFacts } from "../../pkg/page/pathlight.js";
import type { State } from "../state.ts";

/**
 * How a round ended: `won` before the model; `draw` with the same number of balls; `late` after the model; `lost`, the
 * model solved with this ball and the player did not; `behind`, the model had solved before; `neither`; `solved` and
 * `missed` alone; `after`, a miss of a player who had already solved.
 */
export type Outcome = "won" | "draw" | "late" | "lost" | "behind" | "neither" | "solved" | "missed" | "after";

export interface Verdict {
  readonly outcome: Outcome;
  readonly round: number;
  /** Number of the ball with which the model solved, if it has. */
  readonly modelAt: number | null;
  /** Facts of the player's rollout. */
  readonly facts: RolloutFacts;
  /** Chance that the model gave the ball, 0..1, and mean distance of its guess from the real path, px. */
  readonly guessed: { readonly chance: number; readonly off: number } | null;
  /** Whether green went exactly as it does without a ball. */
  readonly changedNothing: boolean;
  /** How many of the balls next to a solution also solve. */
  readonly luck: (Luck & { readonly kind: LuckKind }) | null;
}

/** How much of a solution was luck: the fewer of the balls next to it solve, the more. */
export type LuckKind = "plan" | "some" | "mostly";

/** A row of the list. */
export interface Round {
  readonly number: number;
  readonly player: AttemptLine;
  /** Null if the model has not dropped its ball of this number, or had already solved. */
  readonly model: { readonly solved: boolean } | null;
}

/** Actions of the large button; `try` and `make` go from making a puzzle to trying it, and back. */
export type Action = "start" | "drop" | "run" | "pause" | "play" | "again" | "back" | "next" | "try" | "make";

export function attempts({ kept, puzzle }: State): readonly AttemptLine[] {
  return kept.attempts[puzzle.key] ?? [];
}

export function attemptLimitReached(state: State): boolean {
  return attempts(state).length >= ATTEMPT_LIMIT;
}

/** Whether the model is about to choose its ball of the next round. */
export function awaitsModel(state: State): boolean {
  const { model, answers } = state;
  return !isAlone(state) && model.kind === "ready" && answers.turnUpTo <= attempts(state).length;
}

/** Attempts whose outcome may be shown: all but one that plays for the first time. */
export function toldAttempts(state: State): readonly AttemptLine[] {
  const made = attempts(state);
  return state.run?.fresh ? made.slice(0, (state.run.round ?? 1) - 1) : made;
}

/** Number of the player's first ball that solved, if it may be shown. */
export function playerSolvedAt(state: State): number | null {
  return numberOf(toldAttempts(state).findIndex(({ status }) => status === "solved"));
}

/** Number of the model's ball that solved, within the number of balls that the player has had. */
export function modelSolvedAt(state: State): number | null {
  if (isAlone(state)) return null;
  const told = state.answers.turn.slice(0, toldAttempts(state).length);
  return numberOf(told.findIndex(({ ending }) => ending.solved));
}

export function rounds(state: State): Round[] {
  const { turn } = state.answers;
  return toldAttempts(state).map((player, index) => {
    const tried = isAlone(state) ? undefined : turn[index];
    return { number: index + 1, player, model: tried ? { solved: tried.ending.solved } : null };
  });
}

/** Null until the run has ended. */
export function verdict(state: State): Verdict | null {
  const {
    run,
    answers: { luck },
  } = state;
  const [facts] = rollouts(state);
  const ball = facts?.line.ball;
  if (!run || run.round === null || !facts || !ball || run.balls[0]!.of_model || !ended(state)) return null;
  const { round } = run;
  const imagined = guess(state)?.imagined;
  const off = imagined && facts.paths ? meanDistance(imagined.object, facts.paths.object) : null;
  return {
    outcome: outcomeOf(state, round, facts.ending.solved),
    round,
    modelAt: modelSolvedBy(state, round),
    facts,
    guessed: imagined && off !== null ? { chance: imagined.probability, off } : null,
    changedNothing: isPathWithoutBall(state, facts),
    luck: luck && sameBall(luck.of, ball) ? { ...luck.found, kind: luckKind(luck.found) } : null,
  };
}

function luckKind({ solved, valid }: Luck): LuckKind {
  return solved > 0.6 * valid ? "plan" : solved > 0.25 * valid ? "some" : "mostly";
}

function isPathWithoutBall({ puzzle }: State, { paths }: RolloutFacts): boolean {
  const alone = puzzle.rollout(null).paths;
  return Boolean(paths && alone && paths.object.every((place, at) => place === alone.object[at]));
}

/** Number of the model's ball that solved, if it was dropped by a round. */
function modelSolvedBy(state: State, round: number): number | null {
  const modelAt = modelSolvedAt(state);
  return modelAt !== null && modelAt <= round ? modelAt : null;
}

/** How a round ended in which the player's ball solved or did not. */
export function outcomeOf(state: State, round: number, solved: boolean): Outcome {
  const solvedAt = playerSolvedAt(state);
  const modelAt = modelSolvedBy(state, round);
  if (!solved && solvedAt !== null && solvedAt < round) return "after";
  const isDuel = !isAlone(state) && (modelAt !== null || state.answers.turn.length >= round);
  if (!isDuel) return solved ? "solved" : "missed";
  if (solved) return modelAt === null ? "won" : modelAt === round ? "draw" : "late";
  return modelAt === null ? "neither" : modelAt === round ? "lost" : "behind";
}

/** Number of misses since the last solution. */
export function missesInARow(state: State): number {
  const told = toldAttempts(state);
  return told.length - 1 - told.findLastIndex(({ status }) => status === "solved");
}

/** The next action of the large button. */
export function nextStep(state: State): Action {
  if (introShown(state)) return "start";
  const panel = shownPanel(state);
  if (!state.run) return panel === "make" ? "try" : panel === "predict" ? "run" : "drop";
  if (!ended(state)) return state.run.playing ? "pause" : "play";
  if (panel === "make") return "make";
  if (state.run.round === null) return "back";
  return playerSolvedAt(state) !== null && canGoOn(state) && !endsLesson(state) ? "next" : "again";
}

function numberOf(index: number): number | null {
  return index < 0 ? null : index + 1;
}

/** Mean distance of two paths x, y, x, y, … */
export function meanDistance(one: ArrayLike<number>, other: ArrayLike<number>): number {
  let sum = 0;
  for (let at = 0; at < one.length; at += 2) sum += Math.hypot(one[at]! - other[at]!, one[at + 1]! - other[at + 1]!);
  return sum / (one.length / 2);
}
