// What "Watch it learn" knows of the puzzles that were played, and which ball is shown when. Without browser and wasm.

import type { Reminder, TriedProposal } from "pathlight";

/** A puzzle that was played twice; null if no ball solved it. */
export interface Played {
  readonly task: string;
  /** The number of the ball that solved it with the memory, and without. */
  readonly learned: number | null;
  readonly fresh: number | null;
  /** The earlier puzzle that helped to solve it with the memory. */
  readonly reminder: Reminder | null;
}

/** When a ball is shown, s; the number counts from 1. */
export interface ShownTry {
  readonly number: number;
  readonly start: number;
  readonly end: number;
}

/** Balls before the last that are shown. */
const MOST_SHOWN = 5;
/** How long the last ball is shown, and how long all before it together at most, s. */
const LAST = 1.1;
const BEFORE = 1;
/** How long one of them is shown at most, s. */
const ONE = 0.4;
/** Puzzles of which the trend is the geometric mean. */
const WINDOW = 5;
/** Most steps that are shown of a ball before the last. */
const MOST_STEPS = 420;
/** Steps at the end of a solution in which nothing moves. */
const WAITING = 150;

/** Which balls are shown, and when: the last at length, a few before it in short. */
export function shownTries(count: number): ShownTry[] {
  const before = Math.min(count - 1, MOST_SHOWN);
  const each = before > 0 ? Math.min(BEFORE / before, ONE) : 0;
  const shown = Array.from({ length: Math.max(before, 0) }, (_, index) => ({
    number: 1 + Math.round((index * (count - 1)) / before),
    start: index * each,
    end: (index + 1) * each,
  }));
  return count ? [...shown, { number: count, start: before * each, end: before * each + LAST }] : [];
}

/** How long the balls at a puzzle are shown, s. */
export const duration = (count: number): number => shownTries(count).at(-1)?.end ?? 0;

/** The ball that is shown at a time, the step of its run, and whether it is the last at its end; null without balls. */
export function momentOf(
  tries: readonly TriedProposal[],
  time: number,
): { number: number; step: number; isOver: boolean } | null {
  const all = shownTries(tries.length);
  const shown = all.find(({ end }) => time < end) ?? all.at(-1);
  if (!shown) return null;
  const { ending } = tries[shown.number - 1]!;
  const isLast = shown.number === tries.length;
  const steps = isLast ? ending.steps - (ending.solved ? WAITING : 0) : Math.min(ending.steps, MOST_STEPS);
  const part = Math.min((time - shown.start) / (shown.end - shown.start), 1);
  return { number: shown.number, step: steps * part, isOver: isLast && part === 1 };
}

export function solvedAt(tries: readonly TriedProposal[]): number | null {
  return tries.at(-1)?.ending.solved ? tries.length : null;
}

export function playedOf(task: string, learned: readonly TriedProposal[], fresh: readonly TriedProposal[]): Played {
  const reminder = learned.at(-1)?.reminder ?? null;
  const helped = solvedAt(learned) !== null && reminder?.solved && reminder.task && reminder.change >= 0;
  return { task, learned: solvedAt(learned), fresh: solvedAt(fresh), reminder: helped ? reminder : null };
}

/** For each puzzle the geometric mean of its balls and of those of the few before it. */
export function trend(counts: readonly number[]): number[] {
  return counts.map((_, index) => {
    const latest = counts.slice(Math.max(index + 1 - WINDOW, 0), index + 1);
    return Math.exp(latest.reduce((sum, count) => sum + Math.log(count), 0) / latest.length);
  });
}
