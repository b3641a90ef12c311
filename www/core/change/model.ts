// The model: the loading state of its weights, and the worker's answers about the open puzzle. An answer about another
// puzzle is too late and is ignored.

import { goOn } from "./run.ts";
import { arrived } from "./walkthrough.ts";
import type {
  Ball,
  Candidate,
  FoundSolutions,
  ImaginedBall,
  Luck,
  Maps,
  ModelCard,
  Setup,
  TriedProposal,
} from "../../pkg/page/pathlight.js";
import type { Futures } from "./home.ts";
import type { State } from "../state.ts";

export type Model =
  | { readonly kind: "off" }
  /** `arrived`: the loaded fraction of the weights, 0..1. */
  | { readonly kind: "loading"; readonly arrived: number }
  | { readonly kind: "ready"; readonly name: string; readonly card: ModelCard }
  | { readonly kind: "failed"; readonly failure: Failure };

/**
 * `unreachable`: no answer; `missing`: no such file; `page`: a web page instead; `damaged`: other bytes; `forbidden`:
 * the page's rules forbid wasm; `old`: the browser has no SIMD; `worker`: the file exists, but may not run; `crashed`:
 * a bug of ours; `broken`: anything else.
 */
export type FailureCode =
  "offline" | "unreachable" | "missing" | "page" | "damaged" | "forbidden" | "old" | "worker" | "crashed" | "broken";

/** Why the model is missing; the text has the words and the remedy. */
export interface Failure {
  readonly code: FailureCode;
  /** Details for a bug report. */
  readonly reason: string;
}

export interface Answers {
  readonly maps: Maps | null;
  /** What the model imagines before its first ball, for the home page. */
  readonly futures: Futures | null;
  /** Whether the model was trained on this very puzzle; null while unknown. */
  readonly practised: boolean | null;
  /** The balls of the model's turn so far; it stops at the one that solves. */
  readonly turn: readonly TriedProposal[];
  /** Number of balls asked for; the turn has fewer if the model has no more. */
  readonly turnUpTo: number;
  /** The balls that the model considered before it chose its first, for its walkthrough; null until asked for. */
  readonly candidates: readonly Candidate[] | null;
  readonly guess: { readonly of: Ball; readonly imagined: ImaginedBall } | null;
  readonly solutions: Solutions | null;
  /** Results of the search for an easy ball so far. */
  readonly found: FoundSolutions | null;
  readonly luck: { readonly of: Ball; readonly found: Luck } | null;
}

/** Where balls of a radius solve, as far as tried. */
export interface Solutions {
  readonly radius: number;
  readonly outcomes: Uint8Array;
  /** Fraction tried, 0..1. */
  readonly progress: number;
}

export const MODEL_OFF: Model = { kind: "off" };
/** Answers that only the model can give. */
const NOT_ASKED = { maps: null, futures: null, practised: null, turn: [], turnUpTo: 0, candidates: null, guess: null };
export const NO_ANSWERS: Answers = { ...NOT_ASKED, solutions: null, found: null, luck: null };

export function setModel(state: State, model: Model): State {
  return goOn({ ...state, model });
}

/** Changes the model that plays. */
export function chooseModel(state: State, setup: Setup): State {
  if (setup === state.kept.model) return state;
  const answers = { ...state.answers, ...NOT_ASKED };
  return { ...state, kept: { ...state.kept, model: setup }, model: { kind: "loading", arrived: 0 }, answers };
}

/** Loads the weights: for the first time, or after a failure. */
export function startModel(state: State): State {
  const { kind } = state.model;
  return kind === "off" || kind === "failed" ? { ...state, model: { kind: "loading", arrived: 0 } } : state;
}

export function answered(state: State, key: string, answers: Partial<Answers>): State {
  if (key !== state.puzzle.key) return state;
  return arrived(goOn({ ...state, answers: { ...state.answers, ...answers } }));
}
