// Records the scene that the home page shows before any weights are loaded: node scripts/record-home.mjs writes
// assets/home.json (needs `make package`). Nothing in it is made by hand: all data comes from the first model of
// assets/model.json, and from assets/results.json.

import { readFile, writeFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";

const ASSETS = new URL("../assets/", import.meta.url);
const PACKAGE = new URL("../target/package/pathlight.js", import.meta.url).href;
const OUT = new URL("home.json", ASSETS);
/**
 * The puzzle at the top. It is new to the first model, which imagines it well but misses on its first ball. The player
 * can therefore win, and has not seen the answer.
 */
const TASK = "00013:193";
/** How many futures fan out. */
const FUTURES = 40;
/** How many of the puzzles that the model does not solve are recorded. */
const UNSOLVED = 30;

/** @typedef {import("../www/api/index.ts").Pathlight} Pathlight */

/** Returns the recording, a `Recorded` of www/core/change/home.ts. The same weights give the same recording. */
export async function recordHome() {
  const { load } = await import(PACKAGE);
  const { models } = await read("model.json");
  const pathlight = await load({ weights: new URL(models[0].file, ASSETS) });
  const paths = pathlight.templates().map(({ tasks }) => {
    const task = easiestNew(pathlight, tasks);
    return [task, likeliestPath(pathlight, task)];
  });
  const recording = {
    scene: recordScene(pathlight),
    paths: Object.fromEntries(paths),
    unsolved: await unsolvedTasks(pathlight),
  };
  pathlight.free();
  return recording;
}

/**
 * Returns the futures that the model imagines, and the ball that it picks.
 * @param {Pathlight} pathlight
 */
function recordScene(pathlight) {
  const [{ ball }] = pathlight.propose(TASK, { count: 1 });
  const { object, ball: path, errors, probability } = required(pathlight.imagineBall(TASK, ball));
  // Evenly spaced from the likeliest to the least likely.
  const candidates = required(pathlight.candidates(TASK)).toSorted((one, other) => other.probability - one.probability);
  const futures = Array.from(
    { length: FUTURES },
    (_, index) => candidates[Math.floor((index * candidates.length) / FUTURES)],
  );
  return {
    task: TASK,
    futures: futures.map(({ probability, object }) => ({
      probability: hundredths(probability),
      path: Array.from(object, Math.round),
    })),
    ball,
    imagined: {
      object: Array.from(object, tenths),
      ball: Array.from(path, tenths),
      errors: Array.from(errors, tenths),
      probability: hundredths(probability),
    },
  };
}

/**
 * Returns the path of the green object that the model imagines for its best ball: x, y, x, y, … px.
 * @param {Pathlight} pathlight
 * @param {string} task
 */
function likeliestPath(pathlight, task) {
  const [{ ball }] = pathlight.propose(task, { count: 1 });
  const { x, y } = pathlight.scene(task).bodies[pathlight.scene(task).body1];
  return [x, y, ...required(pathlight.imagineBall(task, ball)).object].map(Math.round);
}

/**
 * Returns the easiest of the tasks that are new to the model.
 * @param {Pathlight} pathlight
 * @param {string[]} tasks
 */
function easiestNew(pathlight, tasks) {
  return easiestFirst(
    pathlight,
    tasks.filter((task) => !pathlight.hasSeen(task)),
  )[0];
}

/**
 * Returns the easiest puzzles that the model does not solve in a hundred attempts.
 * @param {Pathlight} pathlight
 */
async function unsolvedTasks(pathlight) {
  const [{ tasks, first_solved }] = (await read("results.json")).models;
  const unsolved = tasks.filter((_, index) => first_solved.online[index] === null);
  return easiestFirst(pathlight, unsolved).slice(0, UNSOLVED);
}

/**
 * @param {Pathlight} pathlight
 * @param {string[]} tasks
 */
function easiestFirst(pathlight, tasks) {
  const rate = (/** @type {string} */ task) => pathlight.difficulty(task).solve_rate;
  return tasks.toSorted((one, other) => rate(other) - rate(one));
}

/** @param {string} file */
async function read(file) {
  return JSON.parse(await readFile(new URL(file, ASSETS), "utf8"));
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
  if (value === null) throw new Error("the first model has no dynamics net: publish one that has");
  return value;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const text = `${JSON.stringify(await recordHome())}\n`;
  await writeFile(OUT, text);
  console.log(`${fileURLToPath(OUT)}: ${text.length} bytes`);
}
