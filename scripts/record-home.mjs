// Records what the home page shows before any weights are there: node scripts/record-home.mjs writes assets/home.json
// (needs www/pkg). Nothing in it is drawn by hand: all of it comes from the first model of assets/model.json, from the
// simulator, and from assets/results.json.

import { readFile, writeFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { load } from "../www/api/index.js";
import { SCENE_TASK } from "../www/home/home-tasks.js";

const ASSETS = new URL("../assets/", import.meta.url);
const OUT = new URL("home.json", ASSETS);
/** How many futures fan out. */
const FUTURES = 40;
/** Steps between two recorded poses. */
const POSE_STEPS = 4;
/** How many of the puzzles that a model does not solve are named. */
const UNSOLVED = 30;

/** @typedef {import("../www/api/index.js").Pathlight} Pathlight */
/** @typedef {import("../www/home/recording.js").Recording} Recording */

/** Returns the recording: the same for the same weights and the same simulator. */
export async function recordHome() {
  const { models } = JSON.parse(await readFile(new URL("model.json", ASSETS), "utf8"));
  const pathlight = await load({ weights: new URL(models[0].file, ASSETS) });
  /** @type {Recording} */
  const recording = {
    scene: recordScene(pathlight, SCENE_TASK, models[0].name),
    kinds: Object.fromEntries(
      pathlight.templates().map(({ id, tasks: [first] }) => [id, likeliestPath(pathlight, first)]),
    ),
    paths: Object.fromEntries(
      pathlight.templates().map(({ tasks }) => {
        const task = easiestNew(pathlight, tasks);
        return [task, likeliestPath(pathlight, task)];
      }),
    ),
    unsolved: await unsolvedTasks(pathlight),
  };
  pathlight.free();
  return recording;
}

/**
 * The futures that a model imagines, the ball that it picks, and what really becomes of that ball.
 * @param {Pathlight} pathlight
 * @param {string} task
 * @param {string} model its name
 * @returns {Recording["scene"]}
 */
export function recordScene(pathlight, task, model) {
  const { body1, body2, bodies } = pathlight.scene(task);
  const [{ ball }] = pathlight.propose(task, { count: 1 });
  const imagined = required(pathlight.imagineBall(task, ball));
  // From the likeliest to the least likely, evenly.
  const candidates = required(pathlight.candidates(task)).toSorted((one, other) => other.probability - one.probability);
  const futures = Array.from(
    { length: FUTURES },
    (_, index) => candidates[Math.floor((index * candidates.length) / FUTURES)],
  );
  const rollout = pathlight.simulate(task, ball);
  const { steps, simulator, digest } = pathlight.attemptLine(task, ball);
  const columns = rollout.bodies.length;
  /** @type {(step: number) => number[]} */
  const poseAt = (step) => Array.from(rollout.poses.subarray(step * columns * 3, (step + 1) * columns * 3));
  const frames = Array.from({ length: Math.ceil(steps / POSE_STEPS) + 1 }, (_, index) =>
    Math.min(index * POSE_STEPS, steps),
  );
  const object = rollout.bodies.indexOf(body1);
  const errors = Array.from(imagined.steps).flatMap((step, sample) => {
    if (step > steps) return [];
    const at = (step * columns + object) * 3;
    return Math.hypot(
      rollout.poses[at] - imagined.object[2 * sample],
      rollout.poses[at + 1] - imagined.object[2 * sample + 1],
    );
  });
  return {
    task,
    model,
    simulator,
    digest,
    steps,
    solved: rollout.solved,
    body1,
    body2,
    bodies: bodies.map(({ x, y, angle, role, parts }) => ({
      pose: pose([x, y, angle]),
      role,
      parts: parts.map(roundedShape),
    })),
    futures: futures.map(({ probability, object: path }) => ({
      probability: hundredths(probability),
      path: Array.from(path, Math.round),
    })),
    ball,
    imagined: {
      steps: Array.from(imagined.steps),
      object: Array.from(imagined.object, tenths),
      ball: Array.from(imagined.ball, tenths),
      errors: Array.from(imagined.errors, tenths),
      probability: hundredths(imagined.probability),
    },
    real: {
      bodies: Array.from(rollout.bodies),
      every: POSE_STEPS,
      poses: frames.map((step) => pose(poseAt(step))),
      touched: rollout.touching.indexOf(1, steps - rollout.final_touch),
    },
    miss: tenths(errors.reduce((sum, error) => sum + error, 0) / errors.length),
  };
}

/**
 * @param {import("../www/home/recording.js").Shape} shape
 * @returns {import("../www/home/recording.js").Shape}
 */
function roundedShape(shape) {
  if ("circle" in shape) return { circle: tenths(shape.circle) };
  return { polygon: shape.polygon.map(([x, y]) => [tenths(x), tenths(y)]) };
}

/**
 * The path of the green object that a model takes to be the likeliest of those that solve a task.
 * @param {Pathlight} pathlight
 * @param {string} task
 */
function likeliestPath(pathlight, task) {
  const [{ ball }] = pathlight.propose(task, { count: 1 });
  const { x, y } = pathlight.scene(task).bodies[pathlight.scene(task).body1];
  return [x, y, ...required(pathlight.imagineBall(task, ball)).object].map(Math.round);
}

/**
 * The easiest of some tasks that is new to the model.
 * @param {Pathlight} pathlight
 * @param {string[]} tasks
 */
function easiestNew(pathlight, tasks) {
  const rate = (/** @type {string} */ task) => pathlight.difficulty(task).solve_rate;
  return tasks.filter((task) => !pathlight.hasSeen(task)).sort((one, other) => rate(other) - rate(one))[0];
}

/**
 * The easiest puzzles that each model does not solve in a hundred attempts, the easiest first.
 * @param {Pathlight} pathlight
 */
async function unsolvedTasks(pathlight) {
  const { models } = JSON.parse(await readFile(new URL("results.json", ASSETS), "utf8"));
  const rate = (/** @type {string} */ task) => pathlight.difficulty(task).solve_rate;
  return Object.fromEntries(
    models.map(
      (/** @type {import("../www/model/results.js").ModelResults} */ { name, tasks, first_solved: { online } }) => [
        name,
        tasks
          .filter((_, index) => online[index] === null)
          .toSorted((one, other) => rate(other) - rate(one))
          .slice(0, UNSOLVED),
      ],
    ),
  );
}

/**
 * Poses of bodies, x, y and angle of each: tenths of a px, thousandths of a radian.
 * @param {number[]} values
 */
function pose(values) {
  return values.map((value, index) => (index % 3 === 2 ? Math.round(value * 1000) / 1000 : tenths(value)));
}

/** @param {number} value */
function tenths(value) {
  return Math.round(value * 10) / 10;
}

/** @param {number} value */
function hundredths(value) {
  return Math.round(value * 100) / 100;
}

/**
 * @template T
 * @param {T | null} value
 */
function required(value) {
  if (value === null) throw new Error("The first model has no dynamics net, so it imagines no futures.");
  return value;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const text = `${JSON.stringify(await recordHome())}\n`;
  await writeFile(OUT, text);
  console.log(`${fileURLToPath(OUT)}: ${text.length} bytes`);
}
