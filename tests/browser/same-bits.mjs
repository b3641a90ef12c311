// What every engine has to compute the same to the bit: rollouts of all templates, half of them with balls that touch
// much, and the proposals of a model. Knows the native program and Node; in a browser `computeInPage` runs in the page.

import { spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import { binary } from "./harness.mjs";
import { load } from "./package.mjs";

/** @typedef {[x: number, y: number, r: number]} Ball */
/**
 * @typedef {{ attempts: { task: string, ball: Ball }[], tasks: string[] }} Sample attempts to simulate, and tasks to
 *   propose for
 */
/**
 * @typedef {{ digests: string[], proposals: string[] }} Computed a digest for each attempt, and the balls for each
 *   task, in order
 */

/** The first model, which the page and the native program take too. */
const WEIGHTS = new URL("../../assets/within-0.safetensors", import.meta.url);
/** Balls that are drawn for each that touches much. */
const DRAWN = 8;
/** Proposals of a task that are compared. */
const COUNT = 100;

/**
 * Attempts at some tasks of each template; every other ball is that of several which moves the bodies farthest from
 * where they go by themselves.
 * @param {number} perTemplate
 * @param {number} proposedTasks
 * @returns {Promise<Sample>}
 */
export async function sampleOf(perTemplate, proposedTasks) {
  const pathlight = await load({ weights: null });
  const random = numbers(16);
  const attempts = pathlight.templates().flatMap(({ tasks }) =>
    Array.from({ length: perTemplate }, (_, index) => {
      const task = tasks[Math.floor((index * tasks.length) / perTemplate)];
      const balls = Array.from({ length: index % 2 ? DRAWN : 1 }, () => validBall(pathlight, task, random));
      const alone = pathlight.simulate(task);
      const moved = balls.map((ball) => displacement(alone, pathlight.simulate(task, ball)));
      return { task, ball: balls[moved.indexOf(Math.max(...moved))] };
    }),
  );
  const { test } = pathlight.fold("within", 0);
  return {
    attempts,
    tasks: Array.from({ length: proposedTasks }, (_, index) => test[Math.floor((index * test.length) / proposedTasks)]),
  };
}

/** @returns {Ball} */
function validBall(pathlight, task, random) {
  for (;;) {
    const [x, y, r] = [256, 256, 1].map((range) => random.next().value * range);
    const ball = /** @type {Ball} */ ([Math.floor(x), Math.floor(y), 2 + Math.floor(r * 31)]);
    if (pathlight.whyInvalid(task, ball) === undefined) return ball;
  }
}

/** How far the bodies end from where they end without a ball, px. */
function displacement(alone, { bodies, poses, steps }) {
  const last = (rollout, count, index) => rollout.poses.subarray((rollout.steps * count + index) * 3).slice(0, 2);
  return alone.bodies.reduce((sum, body, index) => {
    const [x, y] = last(alone, alone.bodies.length, index);
    const [newX, newY] = last({ poses, steps }, bodies.length, bodies.indexOf(body));
    return sum + Math.hypot(newX - x, newY - y);
  }, 0);
}

/** Numbers in 0..1 that are the same each time (Park and Miller's generator). */
function* numbers(seed) {
  for (let state = seed; ;) {
    state = (state * 48271) % 2147483647;
    yield state / 2147483647;
  }
}

/**
 * @param {Sample} sample
 * @returns {Promise<Computed>}
 */
export async function computeInNode({ attempts, tasks }) {
  const pathlight = await load({ weights: WEIGHTS });
  return {
    digests: attempts.map(({ task, ball }) => pathlight.attemptLine(task, ball).digest),
    proposals: tasks.map((task) => String(pathlight.propose(task, { count: COUNT }).map(({ ball }) => ball))),
  };
}

/**
 * @param {Sample} sample
 * @param {{ threads?: number, emulator?: string[] }} [machine] by default this one with all its threads; an emulator is
 *   a command before the program's
 * @returns {Computed}
 */
export function computeNatively({ attempts, tasks }, { threads, emulator = [] } = {}) {
  const env = { ...process.env, ...(threads && { RAYON_NUM_THREADS: String(threads) }) };
  const lines = (args, input = "") => {
    const [command, ...words] = [...emulator, binary, ...args];
    const { stdout, stderr, status } = spawnSync(command, words, {
      input,
      env,
      encoding: "utf8",
      maxBuffer: 1e9,
      cwd: new URL("../..", import.meta.url),
    });
    if (status !== 0) throw new Error(stderr);
    return stdout
      .trim()
      .split("\n")
      .map((line) => JSON.parse(line));
  };
  const simulated = lines(
    ["simulate", "--batch", "-", "--verifiable"],
    attempts.map((attempt) => `${JSON.stringify(attempt)}\n`).join(""),
  );
  const proposed = tasks.length
    ? lines(["propose", "--attempts", String(COUNT), ...tasks.flatMap((task) => ["--task", task])])
    : [];
  return {
    digests: simulated.map(({ digest }) => digest),
    proposals: tasks.map((task) => String(proposed.find((line) => line.task === task).balls)),
  };
}

/**
 * Runs in a page of the server of the package, whose module it imports by its address.
 * @param {Sample} sample
 * @returns {Promise<Computed>}
 */
export async function computeInPage({ attempts, tasks }) {
  const { load } = await import(new URL("pathlight.js", location.href).href);
  const pathlight = await load(tasks.length ? {} : { weights: null });
  return {
    digests: attempts.map(({ task, ball }) => pathlight.attemptLine(task, ball).digest),
    proposals: tasks.map((task) => String(pathlight.propose(task, { count: 100 }).map(({ ball }) => ball))),
  };
}

/**
 * Cuts a sample into pieces that a page computes without blocking for long.
 * @param {Sample} sample
 * @param {number} [size] attempts in each
 * @returns {Sample[]}
 */
export function pieces({ attempts, tasks }, size = 100) {
  const cut = [];
  for (let at = 0; at < attempts.length; at += size) cut.push({ attempts: attempts.slice(at, at + size), tasks: [] });
  for (const task of tasks) cut.push({ attempts: [], tasks: [task] });
  return cut;
}

/** @param {Computed[]} computed */
export function joined(computed) {
  return {
    digests: computed.flatMap(({ digests }) => digests),
    proposals: computed.flatMap(({ proposals }) => proposals),
  };
}

/** One digest of all, to report. @param {Computed} computed */
export function digestOf(computed) {
  return createHash("sha256").update(JSON.stringify(computed)).digest("hex").slice(0, 16);
}
