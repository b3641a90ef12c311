// The model: whether its weights are there, and what the worker has answered about the open puzzle. An answer about
// another puzzle comes too late and changes nothing.

import type {
  Ball,
  FoundSolutions,
  ImaginedBall,
  Luck,
  Maps,
  ModelCard,
  TriedProposal,
} from "../../pkg/page/pathlight.js";
import type { Futures } from "./home.ts";
import type { State } from "../state.ts";

export type Model =
  | { readonly kind: "off" }
  /** `arrived`: the fraction of the weights, 0..1. */
  | { readonly kind: "loading"; readonly arrived: number }
  | { readonly kind: "ready"; readonly name: string; readonly card: ModelCard }
  | { readonly kind: "failed"; readonly failure: Failure };

/** Why the model is not there; the text has the words and the remedy. */
export interface Failure {
  readonly code: "offline" | "missing" | "damaged" | "crashed" | "broken";
  /** For whoever reports it. */
  readonly reason: string;
}

export interface Answers {
  readonly maps: Maps | null;
  /** What it imagines before its first ball, for the home page. */
  readonly futures: Futures | null;
  /** Was the model trained on this very puzzle? Null while that is unknown. */
  readonly practised: boolean | null;
  /** The balls of the model's turn so far; it stops at the one that solves. */
  readonly turn: readonly TriedProposal[];
  readonly guess: { readonly of: Ball; readonly imagined: ImaginedBall } | null;
  readonly solutions: Solutions | null;
  /** What the search for an easy ball has found so far. */
  readonly found: FoundSolutions | null;
  readonly luck: { readonly of: Ball; readonly found: Luck } | null;
}

/** Where balls of a radius solve, as far as it has been tried. */
export interface Solutions {
  readonly radius: number;
  readonly outcomes: Uint8Array;
  /** 0..1 */
  readonly progress: number;
}

export const MODEL_OFF: Model = { kind: "off" };
export const NO_ANSWERS: Answers = {
  maps: null,
  futures: null,
  practised: null,
  turn: [],
  guess: null,
  solutions: null,
  found: null,
  luck: null,
};

export function setModel(state: State, model: Model): State {
  return { ...state, model };
}

/** Loads the weights: for the first time, or after a failure. */
export function startModel(state: State): State {
  const { kind } = state.model;
  return kind === "off" || kind === "failed" ? { ...state, model: { kind: "loading", arrived: 0 } } : state;
}

export function answered(state: State, key: string, answers: Partial<Answers>): State {
  return key === state.puzzle.key ? { ...state, answers: { ...state.answers, ...answers } } : state;
}
