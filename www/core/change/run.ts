// The run that the scene plays: a duel, in which the player's ball and the model's run over each other, and its
// playback.

import { attempts, attemptLimitReached, awaitsModel, modelSolvedAt, playerSolvedAt } from "../derived/duel.ts";
import { shownSolution } from "../derived/check.ts";
import { isAlone } from "../derived/hidden.ts";
import { lastStep } from "../derived/run.ts";
import { sameBall } from "../puzzle.ts";
import { leaveLastStep } from "./placement.ts";
import { STEPS_PER_SECOND } from "../../pkg/constants.ts";
import type { ShownRollout } from "../../pkg/page/pathlight.js";
import type { State } from "../state.ts";

export const SPEEDS = [0.25, 1, 4] as const;

export interface Run {
  /** The balls of the run, drawn over each other, the player's first. */
  readonly balls: readonly ShownRollout[];
  /** Number of the player's ball, from 1; null if the run shows no attempt of theirs. */
  readonly round: number | null;
  /** Steps since the start; fractions interpolate between steps. */
  readonly step: number;
  readonly playing: boolean;
  /** Whether the run plays for the first time: its outcome is hidden until the end. */
  readonly fresh: boolean;
}

/**
 * Drops the player's ball and the model's of the same number, for which it waits; with `alone`, only the player's. A
 * ball that was tried before is shown again.
 */
export function drop(state: State, alone = false): State {
  const { ball } = state.placement;
  if (!ball || state.run || state.puzzle.whyInvalid(ball)) return state;
  // The solution that the search has placed is no attempt of the player's.
  if (sameBall(ball, shownSolution(state))) return play(state, [{ ball, of_model: false }], null, false);
  const made = attempts(state);
  const before = made.findIndex((line) => sameBall(line.ball, ball));
  if (before >= 0) return alone ? play(state, [{ ball, of_model: false }], before + 1, false) : show(state, before + 1);
  if (attemptLimitReached(state)) return state;
  if (!alone && awaitsModel(state)) return { ...state, placement: { ...state.placement, drag: null, dropped: true } };
  const { line } = state.puzzle.rollout(ball);
  const kept = { ...state.kept, attempts: { ...state.kept.attempts, [state.puzzle.key]: [...made, line] } };
  const dropped = { ...state, kept };
  if (alone) return play(dropped, [{ ball, of_model: false }], made.length + 1, true);
  return showRound(dropped, made.length + 1, false, true);
}

/** Continues a waiting drop once the answer is there or will not come. */
export function goOn(state: State): State {
  return state.placement.dropped ? drop(state) : state;
}

/**
 * Shows a round of the list again; with `unveiled`, shows the model's ball even if the player has not solved the
 * puzzle.
 */
export function show(state: State, round: number, unveiled = false): State {
  return showRound(state, round, unveiled, false);
}

function showRound(state: State, round: number, unveiled: boolean, fresh: boolean): State {
  const player = attempts(state)[round - 1]?.ball ?? null;
  const model = isAlone(state) ? null : modelBall(state, round, unveiled, fresh);
  const balls = [player && { ball: player, of_model: false }, model && { ball: model, of_model: true }];
  return play(
    leaveLastStep(state),
    balls.filter((ball) => ball !== null),
    round,
    fresh,
  );
}

/** The model's ball of a round. Its solution plays once, then is hidden until the player has solved or asks. */
function modelBall(state: State, round: number, unveiled: boolean, fresh: boolean): ShownRollout["ball"] {
  const tried = state.answers.turn[round - 1];
  if (!tried) return null;
  const isVeiled = tried.ending.solved && !fresh && !unveiled && playerSolvedAt(state) === null;
  return isVeiled && modelSolvedAt(state) === round ? null : tried.ball;
}

/** Plays balls over each other from the start; under reduced motion, shows only their end. */
export function play(state: State, balls: readonly ShownRollout[], round: number | null, fresh: boolean): State {
  if (balls.length === 0) return state;
  const placement = { ...state.placement, drag: null, gesture: null, dropped: false };
  const run: Run = { balls, round, step: 0, playing: true, fresh };
  const started = { ...state, placement, run };
  return state.device.stillness ? seek(started, Infinity) : started;
}

/** Returns to placing, with the ball where it was. */
export function again(state: State): State {
  return state.run ? leaveLastStep({ ...state, run: null }) : state;
}

export function togglePlaying(state: State): State {
  return withRun(state, (run, last) => ({ playing: !run.playing, step: run.step >= last ? 0 : run.step }));
}

/** Pauses at a step. */
export function seek(state: State, step: number): State {
  return withRun(state, (run, last) => at(run, Math.min(Math.max(step, 0), last), last, false));
}

export function stepBy(state: State, steps: number): State {
  return state.run ? seek(state, Math.floor(state.run.step) + steps) : state;
}

export function setSpeed(state: State, speed: number): State {
  return { ...state, speed };
}

/** Advances time. */
export function advance(state: State, milliseconds: number): State {
  if (!state.run?.playing) return state;
  const steps = (milliseconds / 1000) * STEPS_PER_SECOND * state.speed;
  return withRun(state, (run, last) => at(run, Math.min(run.step + steps, last), last, run.step + steps < last));
}

function at(run: Run, step: number, last: number, playing: boolean): Partial<Run> {
  return { step, playing, fresh: run.fresh && step < last };
}

function withRun(state: State, change: (run: Run, last: number) => Partial<Run>): State {
  const { run } = state;
  return run ? { ...state, run: { ...run, ...change(run, lastStep(state)) } } : state;
}
