// Times a puzzle that is played with a memory of 10,000 attempts at puzzles of its kind, natively and in wasm, beside
// one that is played without a memory: node benches/memory.mjs [ATTEMPTS]
//
// All attempts are in like scenes, which costs most. Timed are the first ball, for which the model reads the scene and
// recalls the attempts, and the mean of all balls of a puzzle, twenty at most; in wasm with their simulation. The times
// are those of the processor, because a machine may be busy with something else.
// It needs `make package`.

import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createInterface } from "node:readline";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { load } from "../target/package/pathlight.js";

const ATTEMPTS = Number(process.argv[2] ?? 10_000);
const KIND = "00015";
/** Puzzles that are timed, and balls of each. */
const PUZZLES = 5;
const BALLS = 20;
const PER_PUZZLE = 100;

const root = fileURLToPath(new URL("..", import.meta.url));
const pathlight = await load({ weights: join(root, "assets/cross-0.safetensors") });
const tasks = pathlight.templates().find(({ id }) => id === KIND)?.tasks ?? [];
const timed = tasks.slice(-PUZZLES);
/** Ticks of the clock of /proc in a second. */
const TICKS = 100;
const median = (/** @type {number[]} */ values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];
const ms = (/** @type {number} */ value) => `${value.toFixed(value < 10 ? 1 : 0)} ms`;

/** Returns a memory of many attempts at earlier puzzles of the kind. */
function longMemory() {
  const empty = JSON.parse(pathlight.memory().toJson());
  const puzzles = Array.from({ length: Math.ceil(ATTEMPTS / PER_PUZZLE) }, (_, index) => {
    const task = tasks[index % (tasks.length - PUZZLES)];
    const balls = pathlight.propose(task, { count: PER_PUZZLE }).map(({ ball }) => ball);
    return { task, attempts: balls.map((ball, number) => ({ ball, chance: 0.05, solved: number === 99 })) };
  });
  return JSON.stringify({ ...empty, puzzles });
}

/** The processor's time of this process, or of another, ms. */
const ownTime = () => process.cpuUsage().user / 1000;
const timeOf = (/** @type {number | undefined} */ pid) => {
  const fields = readFileSync(`/proc/${pid}/stat`, "utf8").split(") ")[1].split(" ");
  return (1000 * Number(fields[11])) / TICKS;
};

/**
 * Times the balls of puzzles.
 * @param {() => number} now ms
 * @param {(task: string) => AsyncGenerator<unknown>} play
 */
async function timesOf(now, play) {
  const [firsts, means] = [[], []];
  for (const task of timed) {
    const start = now();
    const balls = play(task);
    await balls.next();
    firsts.push(now() - start);
    let count = 1;
    while (count < BALLS && !(await balls.next()).done) count += 1;
    means.push((now() - start) / count);
    await balls.return(undefined);
  }
  return [median(firsts), median(means)];
}

/** @param {string | null} json */
async function inWasm(json) {
  const start = ownTime();
  const memory = json === null ? null : pathlight.memory(json);
  const read = ownTime() - start;
  const times = await timesOf(ownTime, async function* (task) {
    yield* pathlight.turn(task, { memory });
  });
  memory?.free();
  return [read, ...times];
}

/** @param {string | null} json */
async function natively(json) {
  const folder = mkdtempSync(join(tmpdir(), "pathlight-memory-"));
  const file = join(folder, "memory.json");
  if (json !== null) writeFileSync(file, json);
  const args = [
    "agent",
    "--setup",
    "cross",
    "--agent",
    "online-by-balls",
    ...(json === null ? [] : ["--memory", file]),
  ];
  const child = spawn(join(root, "target/release/pathlight"), args, { stdio: ["pipe", "pipe", "inherit"] });
  const now = () => timeOf(child.pid);
  const answers = createInterface({ input: child.stdout })[Symbol.asyncIterator]();
  const ask = async (/** @type {object} */ line) => {
    child.stdin.write(`${JSON.stringify(line)}\n`);
    return JSON.parse((await answers.next()).value);
  };
  // Its answer comes once the memory is read.
  await ask({ task: tasks[0] });
  const read = now();
  const times = await timesOf(now, async function* (task) {
    for (let answer = await ask({ task, remember: json !== null }); answer.ball;) {
      yield answer;
      answer = await ask({ status: "not_solved" });
    }
  });
  child.stdin.end();
  await new Promise((resolve) => child.once("exit", resolve));
  rmSync(folder, { recursive: true });
  return [read, ...times];
}

const json = longMemory();
console.log(
  `A memory of ${ATTEMPTS} attempts, ${(json.length / 1e6).toFixed(1)} MB of JSON; it keeps ${pathlight.memory(json).attempts()}.`,
);
console.log(
  `| engine | memory | weights and memory are read in | first ball | mean of at most ${BALLS} balls |\n| --- | --- | ---: | ---: | ---: |`,
);
for (const [engine, times] of /** @type {const} */ ([
  ["wasm in Node", inWasm],
  ["native", natively],
])) {
  for (const [name, memory] of /** @type {const} */ ([
    ["none", null],
    ["long", json],
  ])) {
    const row = (await times(memory)).map(ms);
    console.log(
      `| ${engine} | ${name} | ${engine === "native" || memory !== null ? row[0] : "–"} | ${row[1]} | ${row[2]} |`,
    );
  }
}
