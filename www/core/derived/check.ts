// Derived from the check, as far as it has run.

import { sameBall } from "../puzzle.ts";
import { solutions } from "./placing.ts";
import type { Ball, FoundSolutions } from "../../pkg/page/pathlight.js";
import type { State } from "../state.ts";

/** Outcome of a place where a ball solves, as numbered by the wasm. */
const SOLVED = 3;

/** Results of the search for an easy ball, until the person continues. */
export function searched({ check, answers: { found }, placement }: State): FoundSolutions | null {
  if (!check || !found) return null;
  const isOver = found.progress === 1;
  return (isOver ? !found.easiest || sameBall(placement.ball, found.easiest) : check.seeking) ? found : null;
}

/** The ball that the search has placed. */
export function shownSolution({ answers: { found } }: State): Ball | null {
  return found?.progress === 1 ? found.easiest : null;
}

/** The share of places where a ball works. */
export function working(state: State): number {
  const outcomes = solutions(state)?.outcomes ?? new Uint8Array(1);
  return outcomes.reduce((sum, outcome) => sum + Number(outcome === SOLVED), 0) / outcomes.length;
}

/** The share of the model's placement map on places where a ball works; null while either is unknown. */
export function agreement(state: State): number | null {
  const found = solutions(state);
  const map = state.answers.maps?.placement;
  if (!found || found.progress < 1 || !map) return null;
  const total = map.reduce((sum, value) => sum + value, 0);
  const right = map.reduce((sum, value, place) => sum + (found.outcomes[place] === SOLVED ? value : 0), 0);
  return total > 0 ? right / total : null;
}
