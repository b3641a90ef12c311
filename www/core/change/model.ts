// The model: whether its weights are there, and what the worker has answered about the open puzzle. An answer about
// another puzzle comes too late and changes nothing.

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
  /** `arrived`: the fraction of the weights, 0..1. */
  | { readonly kind: "loading"; readonly arrived: number }
  | { readonly kind: "ready"; readonly name: string; readonly card: ModelCard }
  | { readonly kind: "failed"; readonly failure: Failure };

/**
 * `unreachable`: no answer; `missing`: no such file; `page`: a web page in its place; `damaged`: other bytes;
 * `forbidden`: the page's rules forbid wasm; `old`: the browser has no SIMD; `worker`: the file is there, but may not
 * run; `crashed`: a defect of ours; `broken`: all else.
 */
export type FailureCode =
  "offline" | "unreachable" | "missing" | "page" | "damaged" | "forbidden" | "old" | "worker" | "crashed" | "broken";

/** Why the model is not there; the text has the words and the remedy. */
export interface Failure {
  readonly code: FailureCode;
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
  /** As many balls have been asked for; fewer came if the model has no more. */
  readonly turnUpTo: number;
  /** The balls that it considered before it chose its first, as its walkthrough shows them; null until it is asked. */
  readonly candidates: readonly Candidate[] | null;
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
/** What only the model can answer. */
const NOT_ASKED = { maps: null, futures: null, practised: null, turn: [], turnUpTo: 0, candidates: null, guess: null };
export const NO_ANSWERS: Answers = { ...NOT_ASKED, solutions: null, found: null, luck: null };

export function setModel(state: State, model: Model): State {
  return goOn({ ...state, model });
}

/** Another model plays from now on. */
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
