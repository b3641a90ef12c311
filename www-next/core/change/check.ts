// "Check the answer": all solutions of one radius over the scene.

import { FIRST_RADIUS } from "./placement.ts";
import { MAX_RADIUS, MIN_RADIUS } from "../../pkg/constants.ts";
import type { State } from "../state.ts";

export interface Check {
  readonly radius: number;
}

export function toggleCheck(state: State): State {
  return { ...state, check: state.check ? null : { radius: state.placement.ball?.[2] ?? FIRST_RADIUS } };
}

export function setCheckRadius(state: State, radius: number): State {
  return { ...state, check: { radius: Math.min(Math.max(Math.round(radius), MIN_RADIUS), MAX_RADIUS) } };
}
