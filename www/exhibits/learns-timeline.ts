// The played puzzles of "Watch it learn", and which ball is shown when. Independent of browser and wasm.

import type { Reminder, TriedProposal } from "pathlight";

/** A puzzle that was played twice. Numbers are null if no ball solved it. */
export interface Played {
  readonly task: string;
  /** Number of the ball that solved it with the memory, and without. */
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

/** Maximum number of balls shown before the last. */
const MOST_SHOWN = 5;
/** How long the last ball is shown, and the maximum for all earlier ones together, s. */
const LAST = 1.1;
const BEFORE = 1;
/** Maximum time that one of them is shown, s. */
const ONE = 0.4;
/** Number of puzzles in the geometric mean of the trend. */
const WINDOW = 5;
/** Maximum number of steps shown of a ball before the last. */
const MOST_STEPS = 420;
/** Steps at the end of a solution in which nothing moves. */
const WAITING = 150;

/** Chooses which balls are shown, and when: the last at length, a few earlier ones briefly. */
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

/** How long the balls of a puzzle are shown, s. */
export const duration = (count: number): number => shownTries(count).at(-1)?.end ?? 0;

/** The ball shown at a time, the step of its run, and whether it is the last at its end; null without balls. */
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

/** For each puzzle, the geometric mean of its ball count and those of the few puzzles before it. */
export function trend(counts: readonly number[]): number[] {
  return counts.map((_, index) => {
    const latest = counts.slice(Math.max(index + 1 - WINDOW, 0), index + 1);
    return Math.exp(latest.reduce((sum, count) => sum + Math.log(count), 0) / latest.length);
  });
}
