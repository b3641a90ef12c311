// The worker: fetches the weights, imagines, plays the model's turn and searches for solutions by the API, off the
// page's thread. `calls` declares each call once; WorkerClient takes its name, arguments, updates and answer from here.
//
// The page sends { id, call, args }, and the worker answers with any number of { id, update }, then with one
// { id, value } or { id, error }. { cancel: id } ends a call that is still running; nobody waits for its answer.

import { cleanUp } from "../api/clean-up.js";
import { load as loadPathlight } from "../api/index.js";

/** @typedef {import("../pkg/pathlight.js").Ball} Ball */
/** @typedef {import("../pkg/pathlight.js").Puzzle} Puzzle */
/** @typedef {import("../pkg/pathlight.js").Proposal} Proposal */

/** @typedef {typeof calls} Calls */
/**
 * The model that is loaded, the names of all models, and the SHA-256 of its weights if the list has it.
 * @typedef {{ name: string, names: string[], sha256?: string, card: import("../pkg/pathlight.js").ModelCard }}
 *   LoadedModel
 */
/**
 * An error for the person. Codes that the page knows: "no_model" (no model of this name), "crashed" (the wasm trapped,
 * so the worker must not be used again). Others come from the API, and only choose the words in which the page says
 * them.
 * @typedef {{ code: string, message: string }} Failure
 */

/** @typedef {ReturnType<Calls["imagine"]>} Imagined */
/** @typedef {NonNullable<ReturnType<Calls["consider"]>>} Considered */
/** @typedef {ReturnType<Calls["watch"]>} Watched */

/** How long a search runs before it sends what it has found and lets messages in, ms. */
const SLICE = 100;
/** A path of a scene alone has a point every this many steps. */
const WATCHED_STEPS = 4;

/**
 * A call takes its arguments and returns its answer. A long one is a generator: each value that it yields is sent as an
 * update, then messages are let in, and a cancel ends it. Only the first seven need weights.
 */
const calls = {
  /**
   * The maps of the nets. `seen`: was the model trained on this scene?
   * @param {Puzzle} puzzle
   */
  imagine(puzzle) {
    const seen = pathlight.hasSeen(puzzle);
    const begin = performance.now();
    const maps = pathlight.imagine(puzzle);
    return { maps, seen, milliseconds: performance.now() - begin };
  },

  /**
   * What the model imagines for a ball; null if the weights have no dynamics net.
   * @param {Puzzle} puzzle
   * @param {Ball} ball
   */
  imagineBall: (puzzle, ball) => pathlight.imagineBall(puzzle, ball),

  /**
   * The balls that the model considers, and the one that it tries first; null if the weights have no dynamics net.
   * @param {Puzzle} puzzle
   */
  consider(puzzle) {
    const candidates = pathlight.candidates(puzzle);
    const [chosen] = candidates ? pathlight.propose(puzzle, { count: 1 }) : [];
    return candidates && chosen ? { candidates, chosen } : null;
  },

  /**
   * Lists the balls of a turn, each with its outcome. A model that learns from its attempts knows the next ball only
   * when the one before has been tried, and its list ends with the ball that solves.
   * @param {Puzzle} puzzle
   */
  propose: (puzzle) =>
    pathlight.card?.dynamics
      ? eachOf(pathlight.turn(puzzle), (attempt) => attempt)
      : eachOf(pathlight.propose(puzzle), (proposal) => simulated(puzzle, proposal)),

  /**
   * Tries the model's balls in order until one solves; each attempt is an update.
   * @param {Puzzle} puzzle
   */
  turn: (puzzle) => pathlight.turn(puzzle),

  /**
   * Plays a puzzle with what the model remembers of earlier ones; each attempt is an update. Returns its tries, and
   * what it remembers after them.
   * @param {Puzzle} puzzle
   * @param {string | null} remembered as JSON; null for nothing
   */
  *learn(puzzle, remembered) {
    const memory = pathlight.memory(remembered ?? undefined);
    const tries = [];
    try {
      for (const attempt of pathlight.turn(puzzle, { memory })) {
        tries.push(attempt);
        yield attempt;
      }
      return { tries, memory: memory.toJson() };
    } finally {
      cleanUp(() => memory.free());
    }
  },

  /**
   * Adds an attempt of the person's to what the model remembers. Returns what it remembers then.
   * @param {Puzzle} puzzle
   * @param {Ball} ball
   * @param {boolean} solved
   * @param {string | null} remembered as JSON; null for nothing
   */
  remember(puzzle, ball, solved, remembered) {
    const memory = pathlight.memory(remembered ?? undefined);
    try {
      memory.remember(puzzle, ball, solved);
      return memory.toJson();
    } finally {
      cleanUp(() => memory.free());
    }
  },

  /**
   * Runs the scene without a ball. Returns where the green object was, x, y, x, y, … in px, every few steps and at the
   * end, and whether the scene solved itself.
   * @param {Puzzle} puzzle
   */
  watch(puzzle) {
    const { steps, bodies, poses, solved } = pathlight.simulate(puzzle);
    const { body1 } = pathlight.scene(puzzle);
    const place = bodies.indexOf(body1);
    const points = [];
    for (let step = 0; ; step = Math.min(step + WATCHED_STEPS, steps)) {
      const at = (step * bodies.length + place) * 3;
      points.push(poses[at], poses[at + 1]);
      if (step === steps) return { path: Float32Array.from(points), solved };
    }
  },

  /**
   * Searches for solutions; what it has found is an update.
   * @param {Puzzle} puzzle
   */
  search: (puzzle) => inSlices(pathlight.solutionSearch(puzzle), ({ found }) => found()),

  /**
   * How many of the balls beside a ball solve.
   * @param {Puzzle} puzzle
   * @param {Ball} ball
   */
  luck: (puzzle, ball) => pathlight.luck(puzzle, ball),

  /**
   * Simulates balls. Returns a line with a digest for each.
   * @param {Puzzle} puzzle
   * @param {Ball[]} balls
   */
  attemptLines: (puzzle, balls) => eachOf(balls, (ball) => pathlight.attemptLine(puzzle, ball)),

  /**
   * Simulates the attempts of such lines again.
   * @param {unknown[]} lines
   */
  verify: (lines) => eachOf(lines, (line) => pathlight.verifyAttempt(line)),

  /**
   * Maps where a ball of a radius (px) solves. The map is an update: the outcome of each cell, and the fraction of the
   * cells that has been tried.
   * @param {Puzzle} puzzle
   * @param {number} radius
   */
  solve: (puzzle, radius) =>
    inSlices(pathlight.solveMap(puzzle, radius), ({ progress, outcomes }) => ({ outcomes: outcomes(), progress })),
};

/** @type {import("../api/index.js").Pathlight} */
let pathlight;
/** @type {Promise<import("../api/index.js").Pathlight>} */
let started;
/** The requests that run and have not been cancelled. */
const running = new Set();

/**
 * Starts the wasm, then loads the weights of a name in assets/model.json; null stands for the first.
 * @param {WebAssembly.Module} module
 * @param {string | null} name
 * @param {import("../api/files.js").OnProgress} onProgress
 * @returns {Promise<LoadedModel>}
 */
async function load(module, name, onProgress) {
  started = loadPathlight({ wasm: module, weights: null });
  pathlight = await started;
  const loaded = await pathlight.loadModel(name, onProgress);
  return { ...loaded, card: /** @type {import("../api/index.js").ModelCard} */ (pathlight.card) };
}

addEventListener("message", async ({ data: { id, call, args, cancel } }) => {
  if (cancel !== undefined) {
    running.delete(cancel);
    return;
  }
  const sendUpdate = (/** @type {unknown} */ update) => postMessage({ id, update });
  running.add(id);
  try {
    const value = call === "load" ? await load(args[0], args[1], sendUpdate) : await answer(id, call, args, sendUpdate);
    postMessage({ id, value });
  } catch (error) {
    postMessage({ id, error: failureOf(error) });
  } finally {
    running.delete(id);
  }
});

/**
 * @param {number} id
 * @param {keyof Calls} call
 * @param {any} args
 * @param {(update: unknown) => void} sendUpdate
 */
async function answer(id, call, args, sendUpdate) {
  // Some calls need no weights, but all need the wasm.
  await started;
  const answer = /** @type {(...args: any) => any} */ (calls[call])(...args);
  if (typeof answer?.next !== "function") return answer;
  while (running.has(id)) {
    const { done, value } = answer.next();
    if (done) return value;
    if (value !== undefined) sendUpdate(value);
    await yieldToMessages();
  }
  answer.return();
}

/**
 * @param {any} error
 * @returns {Failure}
 */
function failureOf(error) {
  // After a panic in Rust or a trap the memory of the instance is in no known state.
  const crashed = error?.code === "panic" || error instanceof WebAssembly.RuntimeError;
  const code = crashed ? "crashed" : (error?.code ?? "broken");
  return { code, message: error?.message ?? String(error) };
}

/**
 * Returns what a function makes of each item; may be left after each.
 * @template Item, Result
 * @param {Iterable<Item>} items
 * @param {(item: Item) => Result} map
 * @returns {Generator<undefined, Result[]>}
 */
function* eachOf(items, map) {
  const results = [];
  for (const item of items) {
    results.push(map(item));
    yield undefined;
  }
  return results;
}

/**
 * Takes the steps of a search, and yields what a function makes of the latest once in a while, and of the last.
 * @template Step, Update
 * @param {Iterable<Step>} steps
 * @param {(step: Step) => Update} updateOf
 * @returns {Generator<Update, void>}
 */
function* inSlices(steps, updateOf) {
  let end = performance.now() + SLICE;
  /** @type {Step | undefined} */
  let latest;
  for (const step of steps) {
    latest = step;
    if (performance.now() < end) continue;
    yield updateOf(step);
    end = performance.now() + SLICE;
  }
  if (latest !== undefined) yield updateOf(latest);
}

/**
 * @param {Puzzle} puzzle
 * @param {Proposal} proposal
 */
function simulated(puzzle, proposal) {
  const { solved, steps, longest_touch, final_touch } = pathlight.simulate(puzzle, proposal.ball);
  return { ...proposal, ending: { solved, steps, longest_touch, final_touch } };
}

const channel = new MessageChannel();
/** @type {(() => void)[]} Those that wait for a message to the channel, in order. */
const waiting = [];
channel.port1.onmessage = () => waiting.shift()?.();

/** Lets waiting messages in. Sends a message to itself, because browsers delay nested timeouts by 4 ms. */
function yieldToMessages() {
  return new Promise((/** @type {(value: void) => void} */ resolve) => {
    waiting.push(resolve);
    channel.port2.postMessage(null);
  });
}
