// "Check the answer": all solutions of one radius over the scene, and the search for an easy solution.

import { answered } from "./model.ts";
import { FIRST_RADIUS, place } from "./placement.ts";
import { MAX_RADIUS, MIN_RADIUS } from "../../pkg/constants.ts";
import type { FoundSolutions } from "../../pkg/page/pathlight.js";
import type { State } from "../state.ts";

export interface Check {
  readonly radius: number;
  /** Whether an easy ball is being searched for, to be placed. */
  readonly seeking: boolean;
}

export function toggleCheck(state: State): State {
  const radius = state.placement.ball?.[2] ?? FIRST_RADIUS;
  return { ...state, check: state.check ? null : { radius, seeking: false } };
}

export function setCheckRadius(state: State, radius: number): State {
  const within = Math.min(Math.max(Math.round(radius), MIN_RADIUS), MAX_RADIUS);
  return { ...state, check: { seeking: false, ...state.check, radius: within } };
}

/** Starts or stops the search for an easy ball. */
export function toggleSeeking(state: State): State {
  const { check } = state;
  return check ? { ...state, check: { ...check, seeking: !check.seeking } } : state;
}

/** Places the easiest ball once the search has ended. */
export function sought(state: State, key: string, found: FoundSolutions): State {
  if (key !== state.puzzle.key || !state.check?.seeking) return state;
  const known = answered(state, key, { found });
  if (found.progress < 1) return known;
  const over = { ...known, check: { ...state.check, seeking: false } };
  if (!found.easiest) return over;
  const shown = { ...over, check: { ...over.check, radius: found.easiest[2] } };
  return place(shown, found.easiest, null);
}
