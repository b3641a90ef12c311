// The worker: fetches the weights, imagines, plays the model's turn, and searches for all solutions, off the page's
// thread, by the API. messages.js describes what it is sent and what it answers.

import { load as loadPathlight } from "../api/pathlight.js";

/** @typedef {import("./messages.js").Calls} Calls */
/** @typedef {(update: import("./messages.js").Update) => void} SendUpdate */
/** @typedef {() => boolean} IsCancelled */

/** How long a search runs before it sends what it has found and lets messages in, ms. */
const SLICE = 100;
/** A path of a scene alone has a point each so many steps. */
const WATCHED_STEPS = 4;

/**
 * @type {{ [Name in keyof Calls]: (args: Calls[Name]["args"], sendUpdate: SendUpdate, isCancelled: IsCancelled) =>
 *   Calls[Name]["value"] | Promise<Calls[Name]["value"]> }}
 */
const calls = {
  start,
  load,
  imagine,
  imagineBall,
  consider,
  propose,
  turn,
  watch,
  search,
  luck,
  attemptLines,
  verify,
  solve,
};

/** @type {import("../api/pathlight.js").Pathlight} */
let pathlight;
/** @type {Promise<void>} */
let started;
/** The requests that run and have not been cancelled. */
const running = new Set();

addEventListener("message", async ({ data }) => {
  const { id, call, args, cancel } = /** @type {import("./messages.js").Request & import("./messages.js").Cancel} */ (
    data
  );
  if (cancel !== undefined) {
    running.delete(cancel);
    return;
  }
  running.add(id);
  try {
    if (call !== "start") await started;
    const value = await calls[call](
      args,
      (update) => postMessage({ id, update }),
      () => !running.has(id),
    );
    postMessage({ id, value });
  } catch (error) {
    postMessage({ id, error: failureOf(error) });
  } finally {
    running.delete(id);
  }
});

/**
 * @param {any} error
 * @returns {import("./messages.js").Failure}
 */
function failureOf(error) {
  // After a panic in Rust or a trap the memory of the instance is in no known state.
  const crashed = error?.code === "panic" || error instanceof WebAssembly.RuntimeError;
  const code = crashed ? "crashed" : (error?.code ?? "broken");
  return { code, message: error?.message ?? String(error) };
}

/** @param {Calls["start"]["args"]} args */
function start({ module }) {
  started = loadPathlight({ wasm: module, weights: null }).then((loaded) => void (pathlight = loaded));
  return started;
}

/**
 * @param {Calls["load"]["args"]} args
 * @param {SendUpdate} sendUpdate
 */
async function load({ name }, sendUpdate) {
  const loaded = await pathlight.loadModel(name, (progress) => sendUpdate({ progress }));
  return { ...loaded, card: /** @type {import("../api/pathlight.js").ModelCard} */ (pathlight.card) };
}

/** @param {Calls["imagine"]["args"]} args */
function imagine({ played }) {
  const seen = pathlight.hasSeen(played);
  const begin = performance.now();
  const maps = pathlight.imagine(played);
  return { maps, seen, milliseconds: performance.now() - begin };
}

/** @param {Calls["imagineBall"]["args"]} args */
function imagineBall({ played, ball }) {
  return pathlight.imagineBall(played, ball);
}

/** @param {Calls["consider"]["args"]} args */
function consider({ played, seed }) {
  const candidates = pathlight.candidates(played);
  const [chosen] = candidates ? pathlight.propose(played, { seed, count: 1 }) : [];
  return candidates && chosen ? { candidates, chosen } : null;
}

/**
 * Lists the balls of a turn, each with what becomes of it. A model that learns from its attempts knows the next ball
 * only when the one before has been tried, and its list ends with the ball that solves.
 * @param {Calls["propose"]["args"]} args
 * @param {SendUpdate} _
 * @param {IsCancelled} isCancelled
 */
async function propose({ played, seed }, _, isCancelled) {
  const proposals = [];
  for (const proposal of pathlight.card?.dynamics
    ? pathlight.turn(played, { seed })
    : simulated(played, pathlight.propose(played, { seed }))) {
    proposals.push(proposal);
    await yieldToMessages();
    if (isCancelled()) break;
  }
  return proposals;
}

/**
 * @param {import("./messages.js").Played} played
 * @param {import("./messages.js").Proposal[]} proposals
 */
function* simulated(played, proposals) {
  for (const proposal of proposals) {
    const { solved, steps, longest_touch, final_touch } = pathlight.simulate(played, proposal.ball);
    yield { ...proposal, ending: { solved, steps, longest_touch, final_touch } };
  }
}

/**
 * Tries the model's balls in order, and sends each attempt.
 * @param {Calls["turn"]["args"]} args
 * @param {SendUpdate} sendUpdate
 * @param {IsCancelled} isCancelled
 */
async function turn({ played, seed }, sendUpdate, isCancelled) {
  for (const attempt of pathlight.turn(played, { seed })) {
    sendUpdate({ attempt });
    await yieldToMessages();
    if (isCancelled()) return;
  }
}

/** @param {Calls["watch"]["args"]} args */
function watch({ played }) {
  const { steps, bodies, poses, solved } = pathlight.simulate(played);
  const { body1 } = pathlight.scene(played);
  const place = bodies.indexOf(body1);
  const points = [];
  for (let step = 0; ; step = Math.min(step + WATCHED_STEPS, steps)) {
    const at = (step * bodies.length + place) * 3;
    points.push(poses[at], poses[at + 1]);
    if (step === steps) return { path: Float32Array.from(points), solved };
  }
}

/**
 * Searches for solutions, and sends what it has found.
 * @param {Calls["search"]["args"]} args
 * @param {SendUpdate} sendUpdate
 * @param {IsCancelled} isCancelled
 */
async function search({ played }, sendUpdate, isCancelled) {
  let end = performance.now() + SLICE;
  /** @type {() => import("./messages.js").FoundSolutions | undefined} */
  let latest = () => undefined;
  for (const { found } of pathlight.solutionSearch(played)) {
    latest = found;
    if (performance.now() < end) continue;
    sendUpdate({ found: found() });
    await yieldToMessages();
    if (isCancelled()) return;
    end = performance.now() + SLICE;
  }
  sendUpdate({ found: latest() });
}

/** @param {Calls["luck"]["args"]} args */
function luck({ played, ball }) {
  return pathlight.luck(played, ball);
}

/**
 * @param {Calls["attemptLines"]["args"]} args
 * @param {SendUpdate} _
 * @param {IsCancelled} isCancelled
 */
async function attemptLines({ played, balls }, _, isCancelled) {
  const lines = [];
  for (const ball of balls) {
    lines.push(pathlight.attemptLine(played, ball));
    await yieldToMessages();
    if (isCancelled()) break;
  }
  return lines;
}

/**
 * @param {Calls["verify"]["args"]} args
 * @param {SendUpdate} _
 * @param {IsCancelled} isCancelled
 */
async function verify({ lines }, _, isCancelled) {
  const verifications = [];
  for (const line of lines) {
    verifications.push(pathlight.verifyAttempt(line));
    await yieldToMessages();
    if (isCancelled()) break;
  }
  return verifications;
}

/**
 * Maps where a ball of a radius solves, and sends the map as it grows.
 * @param {Calls["solve"]["args"]} args
 * @param {SendUpdate} sendUpdate
 * @param {IsCancelled} isCancelled
 */
async function solve({ played, radius }, sendUpdate, isCancelled) {
  let end = performance.now() + SLICE;
  for (const { progress, outcomes } of pathlight.solveMap(played, radius)) {
    if (progress < 1 && performance.now() < end) continue;
    sendUpdate({ map: { outcomes: outcomes(), progress } });
    await yieldToMessages();
    if (isCancelled()) return;
    end = performance.now() + SLICE;
  }
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
