// Derived for the home page: the show in its scene, the kinds of puzzles, and puzzles to start with.

import { IMAGINE, PICK } from "../change/home.ts";
import { meanDistance } from "./duel.ts";
import { ended } from "./run.ts";
import { kindOf } from "./next.ts";
import type { Futures } from "../change/home.ts";
import type { Benchmark } from "./next.ts";
import type { State } from "../state.ts";
import type { Kept } from "../change/kept.ts";

export type Phase = "imagine" | "pick" | "real" | "result";

/** Whether the home page is shown: the link names no puzzle, and a task of the benchmark is open in the picture. */
export function isHome({ route, puzzle }: State): boolean {
  return route.task === null && puzzle.about.id !== null;
}

/** Whether the show is on: nobody has placed a ball. */
export function introShown(state: State): boolean {
  return isHome(state) && state.intro !== null && state.placement.ball === null && (state.run?.round ?? null) === null;
}

export function introPhase(state: State): Phase {
  if (state.run) return ended(state) ? "result" : "real";
  return state.intro!.time < IMAGINE ? "imagine" : "pick";
}

/** Fraction of the first phase in which a single future grows. Futures start one after another. */
const GROWING = 0.55;
/** Opacity of the least and the most likely future. */
const FAINT = 0.16;
const STRONG = 0.75;

/** The paths that the show draws over the scene, in the painter's form. */
export function introPaths(state: State): {
  hints: { object: Float32Array; opacity: number }[];
  imagined: { of: Futures["ball"]; object: Float32Array; ball: Float32Array; errors: Float32Array } | null;
} {
  const { intro, answers, run } = state;
  if (!intro || !answers.futures) return { hints: [], imagined: null };
  const { futures, ball, imagined } = answers.futures;
  const most = Math.max(...futures.map(({ probability }) => probability), 0.01);
  const picked = (intro.time - IMAGINE) / PICK;
  const fade = run ? 0 : Math.min(Math.max(1 - picked / 0.6, 0), 1);
  const hints = futures.map(({ path, probability }, index) => {
    const begin = (1 - GROWING) * (1 - (index + 1) / futures.length);
    const grown = (intro.time / IMAGINE - begin) / GROWING;
    return { object: partOf(path, grown), opacity: (FAINT + ((STRONG - FAINT) * probability) / most) * fade };
  });
  const floats = (values: ArrayLike<number>) => Float32Array.from(values);
  const paths = { object: floats(imagined.object), ball: floats(imagined.ball), errors: floats(imagined.errors) };
  return { hints: hints.filter(({ opacity }) => opacity > 0), imagined: picked > 0 ? { of: ball, ...paths } : null };
}

/** Returns the beginning of a path. */
function partOf(path: ArrayLike<number>, fraction: number): Float32Array {
  const end = Math.min(Math.max(fraction, 0), 1) * (path.length / 2 - 1);
  const whole = 2 * Math.floor(end);
  const part = Array.from(path).slice(0, whole + 2);
  const rest = end - whole / 2;
  if (rest > 0) for (const at of [whole, whole + 1]) part.push(path[at]! + rest * (path[at + 2]! - path[at]!));
  return Float32Array.from(part);
}

/** Distance of the model's guess from the real path, px; null until both are known. */
export function introMiss({ puzzle, answers }: State): { solved: boolean; off: number } | null {
  if (!answers.futures) return null;
  const { ball, imagined } = answers.futures;
  const { paths, ending } = puzzle.rollout(ball);
  return { solved: ending.solved, off: meanDistance(paths!.object, imagined.object) };
}

/** A kind of puzzles. Its tasks are those new to the model, the easiest first. */
export interface Kind {
  readonly id: string;
  readonly tasks: readonly string[];
}

/** The kinds, sorted by their easiest puzzle. */
export function kindsOf({ tasks, rates, unseen }: Benchmark): Kind[] {
  const rate = new Map(tasks.map((task, index) => [task, rates[index]!]));
  const easiest = tasks.filter((task) => unseen.has(task)).sort((one, other) => rate.get(other)! - rate.get(one)!);
  const ids = new Set(easiest.map(kindOf));
  return [...ids].map((id) => ({ id, tasks: easiest.filter((task) => kindOf(task) === id) }));
}

export interface Standing {
  /** The next puzzle, and its number within the kind, from 1. */
  readonly task: string;
  readonly number: number;
  /** The puzzles of the kind that have been played, in order: number, and whether solved. */
  readonly played: readonly { readonly number: number; readonly solved: boolean }[];
}

/** A person's progress in a kind. */
export function standing({ tasks }: Kind, attempts: Kept["attempts"]): Standing {
  const solved = (task: string) => attempts[task]?.some(({ status }) => status === "solved") ?? false;
  const next = tasks.findIndex((task) => !solved(task));
  const played = tasks.flatMap((task, index) =>
    task in attempts ? [{ number: index + 1, solved: solved(task) }] : [],
  );
  const index = Math.max(next, 0);
  return { task: tasks[index]!, number: index + 1, played };
}

export type Difficulty = "easy" | "medium" | "hard";

/** Rates a puzzle by the share of balls that solve it. */
export function difficulty(rate: number): Difficulty {
  return rate >= 0.02 ? "easy" : rate >= 0.004 ? "medium" : "hard";
}

/** Of how many balls one solves, on average; `isRarer`: of even more. */
export interface Rarity {
  readonly balls: number;
  readonly isRarer: boolean;
}

/** Beyond this many, the number is not told exactly. */
const RAREST = 500;

export function rarity(rate: number): Rarity {
  const isRarer = rate * RAREST <= 1;
  return { balls: isRarer ? RAREST : Math.round(1 / rate), isRarer };
}

/** A puzzle of the day is not too hard: at least this share of balls solves it. */
const LEAST_RATE = 0.01;
/** A prime, so that kinds alternate and no puzzle repeats before all have been shown. */
const STRIDE = 7919;

/** The puzzle of a day, counted in days since 1970: the same for everyone, without a server, and new to the model. */
export function taskOfDay({ tasks, rates, unseen }: Benchmark, day: number): string {
  const possible = tasks.filter((task, index) => unseen.has(task) && rates[index]! >= LEAST_RATE);
  return possible[(day * STRIDE) % possible.length]!;
}

/** The easiest puzzle that neither the first model nor the person has solved; null while none is known. */
export function unsolvedTask({ recorded, kept }: State): string | null {
  const tasks = recorded?.unsolved ?? [];
  const solved = (task: string) => kept.attempts[task]?.some(({ status }) => status === "solved");
  return tasks.find((task) => !solved(task)) ?? tasks[0] ?? null;
}

export interface Progress {
  readonly tried: number;
  readonly solved: number;
  readonly attempts: number;
}

export function progress({ kept }: Pick<State, "kept">): Progress {
  const lists = Object.values(kept.attempts);
  const solved = lists.filter((lines) => lines.some(({ status }) => status === "solved")).length;
  return { tried: lists.length, solved, attempts: lists.reduce((sum, { length }) => sum + length, 0) };
}
