// The home page: its recording, and the show in its scene. Futures fan out, the model picks one, and its ball falls.
// The show ends as soon as the person places a ball; from then on it is their puzzle.

import { introShown, isHome } from "../derived/home.ts";
import { NO_BALL } from "./placement.ts";
import { advance, play } from "./run.ts";
import type { Ball, ImaginedBall } from "../../pkg/page/pathlight.js";
import type { Route } from "./route.ts";
import type { Puzzle } from "../puzzle.ts";
import type { State } from "../state.ts";

/** assets/home.json, written by scripts/record-home.mjs: shown until the weights are loaded. */
export interface Recorded {
  readonly scene: { readonly task: string } & Futures;
  /** The imagined path of the green object by task, for one task of each kind: x, y, x, y, … px. */
  readonly paths: Readonly<Record<string, readonly number[]>>;
  /** Puzzles that the first model does not solve in a hundred attempts, the easiest first. */
  readonly unsolved: readonly string[];
}

/** What the model imagines for a puzzle before it drops its first ball. */
export interface Futures {
  /** Imagined paths of the green object, the likeliest first. */
  readonly futures: readonly { readonly probability: number; readonly path: ArrayLike<number> }[];
  /** The ball that the model picks. */
  readonly ball: Ball;
  readonly imagined: Readonly<Record<"object" | "ball" | "errors", ArrayLike<number>>> &
    Pick<ImaginedBall, "probability">;
}

export interface Intro {
  /** Time since the start of the show, ms. The fall takes its time from the run. */
  readonly time: number;
  readonly playing: boolean;
  /** How often the show has been played to its end. */
  readonly rounds: number;
}

/** Durations of fanning out, picking a future, and showing the end, ms. */
export const IMAGINE = 2600;
export const PICK = 1800;
const RESULT = 4000;
/** Maximum number of rounds: an idle page should not keep a computer busy. */
const MOST_ROUNDS = 3;

const BEGIN: Intro = { time: 0, playing: true, rounds: 0 };

export function introOf({ task }: Pick<Route, "task">, { about }: Puzzle): Intro | null {
  return task === null && about.id !== null ? BEGIN : null;
}

export function setRecorded(state: State, recorded: Recorded): State {
  return { ...state, recorded };
}

/** Starts the show again on the home page. */
export function showAgain(state: State): State {
  return isHome(state) ? { ...state, placement: NO_BALL, run: null, intro: BEGIN } : state;
}

/** Ends the show when the person takes over. */
export function endIntro(state: State): State {
  return { ...state, intro: null, run: null };
}

export function toggleIntro(state: State): State {
  const { intro } = state;
  if (!intro) return state;
  const playing = !intro.playing;
  const isOver = playing && intro.rounds >= MOST_ROUNDS;
  if (isOver) return { ...state, run: null, intro: BEGIN };
  const run = state.run && { ...state.run, playing };
  return { ...state, run, intro: { ...intro, playing } };
}

/** Advances time for the run and the show. */
export function tick(state: State, milliseconds: number): State {
  return advanceIntro(advance(state, milliseconds), milliseconds);
}

function advanceIntro(state: State, milliseconds: number): State {
  const { intro, answers, run } = state;
  if (!intro?.playing || !introShown(state) || !answers.futures || run?.playing) return state;
  const time = intro.time + milliseconds;
  const fallen = { ...state, intro: { ...intro, time: IMAGINE + PICK } };
  if (state.device.stillness)
    return run ? { ...state, intro: { ...intro, playing: false, rounds: MOST_ROUNDS } } : fall(fallen);
  if (!run) return time < IMAGINE + PICK ? { ...state, intro: { ...intro, time } } : fall(fallen);
  if (time < IMAGINE + PICK + RESULT) return { ...state, intro: { ...intro, time } };
  const rounds = intro.rounds + 1;
  if (rounds === MOST_ROUNDS) return { ...state, intro: { time, playing: false, rounds } };
  return { ...state, run: null, intro: { ...BEGIN, rounds } };
}

function fall(state: State): State {
  return play(state, [{ ball: state.answers.futures!.ball, of_model: true }], null, false);
}

/** Whether time must advance in another frame. */
export function moves(state: State): boolean {
  if (state.run?.playing) return true;
  return isHome(state) && state.intro?.playing === true && introShown(state) && state.answers.futures !== null;
}
