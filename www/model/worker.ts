// The nets and searches, off the main thread. `calls` declares each call once; the client takes its name, arguments,
// updates and answer from here.
//
// The page sends { id, call, args }. The worker answers with any number of { id, update }, then with one { id, value }
// or { id, failure }. { cancel: id } ends a running call whose answer is no longer needed.

import init, { Model, SolutionSearch, SolveMap, luck } from "../pkg/worker/pathlight.js";
import { LoadError, loadError } from "./loading.ts";
import type { Futures } from "../core/change/home.ts";
import type { Failure } from "../core/change/model.ts";
import type { Ball, Puzzle, TriedProposal, Turn } from "../pkg/worker/pathlight.js";

export type Calls = typeof calls;

export interface Weights {
  readonly url: string;
  readonly size: number;
  readonly sha256: string;
}

/** How long a search runs before it sends its results and handles messages, ms. */
const SLICE = 100;

let model: Model;
/** The last turn, which continues where it was. */
let turn: { key: string; handle: Turn; tried: TriedProposal[]; over: boolean } | null = null;
let started: Promise<unknown> | null = null;

/** A long call is a generator: each yielded value is an update, after which messages are handled. */
const calls = {
  /** Loads the weights, and returns how they were trained. Updates: the fraction loaded, 0..1. */
  async *load(wasm: string, weights: Weights) {
    started = fetched(wasm)
      .then((response) => init({ module_or_path: response }))
      .catch(async (error) => Promise.reject(await loadError(wasm, error, "damaged")));
    // It is awaited last; ignore its rejection until then.
    started.catch(() => {});
    const bytes = new Uint8Array(weights.size);
    try {
      yield* filled(bytes, await fetched(weights.url));
      await started;
      // A page loaded neither over HTTPS nor from this machine has no hashes; the wasm still checks the file's format.
      const hash = crypto.subtle ? hex(await crypto.subtle.digest("SHA-256", bytes)) : weights.sha256;
      if (hash !== weights.sha256) throw new Error("other bytes");
      model = new Model(bytes, weights.sha256);
    } catch (error) {
      throw error instanceof LoadError ? error : await loadError(weights.url, error, "damaged");
    }
    return model.card();
  },

  /** The maps that the nets imagine for a puzzle, and whether they were trained on it. */
  imagine: (puzzle: Puzzle) => ({ maps: model.imagine(puzzle), practised: model.hasSeen(puzzle) }),

  imagineBall: (puzzle: Puzzle, ball: Ball) => model.imagineBall(puzzle, ball) ?? null,

  /** What the model imagines before its first ball: candidates at even steps from the likeliest to the least likely. */
  futures: (puzzle: Puzzle, count: number): Futures | null => {
    const all = model.candidates(puzzle)?.toSorted((one, other) => other.probability - one.probability);
    const ball = model.propose(puzzle, 0, 1)[0]?.ball;
    const imagined = ball && model.imagineBall(puzzle, ball);
    if (!all?.length || !imagined) return null;
    const some = Array.from({ length: count }, (_, index) => all[Math.floor((index * all.length) / count)]!);
    return { futures: some.map(({ probability, object }) => ({ probability, path: object })), ball, imagined };
  },

  /** The balls that the model considers before it chooses its first. */
  candidates: (puzzle: Puzzle) => model.candidates(puzzle) ?? [],

  /** The first balls of the model's turn, each tried only when it is asked for. */
  *turn(puzzle: Puzzle, count: number) {
    const key = JSON.stringify(puzzle);
    if (turn?.key !== key) {
      turn?.handle.free();
      turn = { key, handle: model.turn(puzzle, 0), tried: [], over: false };
    }
    const mine = turn;
    while (turn === mine && !mine.over && mine.tried.length < count) {
      const next = mine.handle.attempt();
      if (next) mine.tried.push(next);
      mine.over = !next || next.ending.solved;
      yield undefined;
    }
    return mine.tried.slice(0, count);
  },

  /** Tries a ball of the radius in each cell of the scene. Updates: the outcomes so far. */
  *solutions(puzzle: Puzzle, radius: number) {
    const map = new SolveMap(puzzle, radius);
    try {
      for (let goesOn = true; goesOn;) {
        const end = performance.now() + SLICE;
        while (goesOn && performance.now() < end) goesOn = map.advance();
        yield { radius, outcomes: map.outcomes(), progress: map.progress() };
      }
    } finally {
      map.free();
    }
  },

  /** Tries balls of all places and radii. Updates: the results so far. */
  *search(puzzle: Puzzle) {
    const search = new SolutionSearch(puzzle);
    try {
      for (let goesOn = true; goesOn;) {
        const end = performance.now() + SLICE;
        while (goesOn && performance.now() < end) goesOn = search.advance();
        yield search.found();
      }
    } finally {
      search.free();
    }
  },

  luck: (puzzle: Puzzle, ball: Ball) => luck(puzzle, ball),
};

/** Running calls that have not been cancelled. */
const running = new Set<number>();

addEventListener("message", async ({ data: { id, call, args, cancel } }) => {
  if (cancel !== undefined) return void running.delete(cancel);
  running.add(id);
  try {
    postMessage({ id, value: await answer(id, call, args) });
  } catch (error) {
    postMessage({ id, failure: failureOf(error) });
  } finally {
    running.delete(id);
  }
});

async function answer(id: number, name: keyof Calls, args: unknown[]): Promise<unknown> {
  // Searches need no weights, but all calls need the wasm.
  if (name !== "load") await started;
  const call: (...args: any[]) => any = calls[name];
  const steps = call(...args);
  if (typeof steps?.next !== "function") return steps;
  while (running.has(id)) {
    const { done, value } = await steps.next();
    if (done) return value;
    if (value !== undefined) postMessage({ id, update: value });
    await letMessagesIn();
  }
  return steps.return();
}

function hex(bytes: ArrayBuffer): string {
  return Array.from(new Uint8Array(bytes), (byte) => byte.toString(16).padStart(2, "0")).join("");
}

async function fetched(url: string): Promise<Response> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${response.status} ${response.statusText}`);
  return response;
}

/** Fills the bytes from a response, and yields the fraction loaded. */
async function* filled(bytes: Uint8Array, { body }: Response): AsyncGenerator<number> {
  // Safari's streams cannot be iterated.
  const reader = body!.getReader();
  let arrived = 0;
  try {
    for (let chunk = await reader.read(); !chunk.done; chunk = await reader.read()) {
      if (arrived + chunk.value.length > bytes.length) throw new Error("too long");
      bytes.set(chunk.value, arrived);
      arrived += chunk.value.length;
      yield arrived / bytes.length;
    }
  } finally {
    // If the call was cancelled or the file is too long, do not download the rest.
    await reader.cancel().catch(() => {});
  }
}

function failureOf(error: any): Failure {
  if (error instanceof LoadError) return error.failure;
  // After a panic in Rust or a trap, the memory of the instance is in an unknown state.
  const crashed = error?.code === "panic" || error instanceof WebAssembly.RuntimeError;
  return { code: crashed ? "crashed" : "broken", reason: error?.message ?? String(error) };
}

const channel = new MessageChannel();
const waiting: (() => void)[] = [];
channel.port1.onmessage = () => waiting.shift()?.();

/** Sends a message to itself, because browsers delay nested timeouts by 4 ms. */
function letMessagesIn(): Promise<void> {
  return new Promise((resolve) => {
    waiting.push(resolve);
    channel.port2.postMessage(null);
  });
}
