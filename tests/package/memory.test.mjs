// The model with a memory: from Node through the installed package, and natively through `pathlight agent`, to the bit
// the same. Errors of memories that cannot be used.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createInterface } from "node:readline";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { entryOf, makeProject, root } from "./project.mjs";

const project = makeProject();
const { load } = await import(entryOf(project));
const pathlight = await load();
const binary = join(root, "target/release/pathlight");
/** A few puzzles of two kinds that it has never seen, in turn. */
const TASKS = pathlight
  .fold("within", 0)
  .test.filter((task) => task.startsWith("00007"))
  .slice(0, 4)
  .flatMap((task, index) => [
    task,
    pathlight.fold("within", 0).test.filter((other) => other.startsWith("00013"))[index],
  ]);

/** A ball that may be placed in all of them. */
const BALL = /** @type {const} */ ([10, 250, 4]);

/** Plays a puzzle. Returns its tries. */
const play = (task, memory) => [...pathlight.turn(task, { memory })];
const ballsOf = (tries) => tries.map(({ ball }) => String(ball));
const digestOf = (text) => createHash("sha256").update(text).digest("hex");

/**
 * A program that answers each line with one.
 * @param {string[]} args
 */
function partner(args) {
  const child = spawn(binary, args, { cwd: root, stdio: ["pipe", "pipe", "inherit"] });
  const answers = createInterface({ input: child.stdout })[Symbol.asyncIterator]();
  return {
    ask: async (line) => {
      child.stdin.write(`${JSON.stringify(line)}\n`);
      return JSON.parse((await answers.next()).value);
    },
    end: () => new Promise((resolve) => child.once("exit", resolve) && child.stdin.end()),
  };
}

/** The balls that the native program tries at the puzzles, each with its reminder, and the memory that it writes. */
async function playNatively(tasks) {
  const folder = mkdtempSync(join(tmpdir(), "pathlight-memory-"));
  const file = join(folder, "memory.json");
  const agent = partner(["agent", "--agent", "online-by-balls", "--memory", file]);
  const simulator = partner(["simulate", "--batch", "-", "--paths"]);
  const tries = [];
  for (const task of tasks) {
    let answer = await agent.ask({ task, remember: true });
    while (answer.ball) {
      tries.push([String(answer.ball), answer.reminder?.change]);
      const { status, paths } = await simulator.ask({ task, ball: answer.ball });
      answer = await agent.ask({ status, paths });
    }
  }
  await Promise.all([agent.end(), simulator.end()]);
  const memory = readFileSync(file, "utf8");
  rmSync(folder, { recursive: true });
  return { tries, memory };
}

test("a carried run is the same to the bit natively and in wasm, also if its memory is saved in the middle", async (context) => {
  const native = await playNatively(TASKS);
  const memory = pathlight.memory();
  const tries = TASKS.flatMap((task) => play(task, memory));
  assert.deepEqual(
    tries.map(({ ball, reminder }) => [String(ball), reminder?.change]),
    native.tries,
  );
  assert.ok(
    tries.some(({ reminder }) => reminder?.solved),
    "it was reminded of something",
  );
  assert.equal(memory.toJson(), native.memory);
  assert.equal(memory.attempts(), tries.length);

  const first = pathlight.memory();
  for (const task of TASKS.slice(0, 3)) play(task, first);
  const second = pathlight.memory(first.toJson());
  for (const task of TASKS.slice(3)) play(task, second);
  assert.equal(digestOf(second.toJson()), digestOf(native.memory));
  context.diagnostic(`SHA-256 of the memory of ${tries.length} attempts: ${digestOf(native.memory)}`);
});

test("what a person tried counts, until all is forgotten", () => {
  // Two puzzles that are much alike. Any model tries another ball first, and three solutions outweigh its chances.
  const [task, next] = [TASKS[0], TASKS[2]];
  const memory = pathlight.memory();
  const before = ballsOf(play(next, memory));
  assert.notEqual(before[0], String(BALL));
  memory.forget();
  assert.deepEqual([memory.attempts(), memory.puzzles()], [0, []]);
  for (let time = 0; time < 3; time++) {
    memory.remember(task, BALL, true);
  }
  const [{ number, task: remembered, attempts }] = memory.puzzles();
  assert.deepEqual([number, remembered], [1, task]);
  assert.deepEqual(
    attempts.map(({ ball, solved }) => [ball, solved]),
    Array(3).fill([BALL, true]),
  );
  const [{ ball, reminder }] = play(next, memory);
  assert.deepEqual(ball, BALL);
  assert.deepEqual([reminder?.puzzle, reminder?.task, reminder?.ball], [1, task, BALL]);
  memory.forget();
  assert.deepEqual(ballsOf(play(next, memory)), before);
});

test("a turn that is left in the middle for another puzzle goes on under its own name", () => {
  const missed = TASKS.find((task) => !pathlight.turn(task).next().value?.ending.solved);
  assert.ok(missed, "a puzzle that the model misses at first");
  const [other] = TASKS.filter((task) => task !== missed);
  const memory = pathlight.memory();
  const turn = pathlight.turn(missed, { memory });
  turn.next();
  memory.remember(other, BALL, false);
  turn.next();
  turn.return();
  assert.deepEqual(
    memory.puzzles().map(({ task }) => task),
    [missed, other, missed],
  );
});

test("a custom scene is remembered as its scene", () => {
  const memory = pathlight.memory();
  const custom = pathlight.customScene(TASKS[0]);
  memory.remember(custom, BALL, false);
  const [{ task, scene }] = memory.puzzles();
  assert.deepEqual([task, scene?.bodies.length], [undefined, custom.bodies.length]);
  assert.equal(pathlight.memory(memory.toJson()).toJson(), memory.toJson());
});

test("a memory that cannot be used is refused in a sentence with a code", async () => {
  const memory = pathlight.memory();
  memory.remember(TASKS[0], BALL, false);
  const json = memory.toJson();
  for (const [text, says] of [
    ["", /not a memory, or it is damaged/],
    [json.slice(0, -9), /not a memory, or it is damaged/],
    [json.replace('"version":1', '"version":2'), /has format 2/],
    [json.replace(/"weights":"./, '"weights":"x'), /learned with other weights/],
    [json.replace(TASKS[0], "00007:999"), /puzzle 1 of this memory is damaged/],
    [json.replace("250.0", "2500.0"), /attempt 1 at puzzle 1/],
  ])
    assert.throws(() => pathlight.memory(/** @type {string} */ (text)), { code: "bad_memory", message: says });
  for (const wrong of [JSON.parse(json), 5, new Uint8Array(3)])
    assert.throws(() => pathlight.memory(/** @type {any} */ (wrong)), { code: "bad_memory", message: /text/ });
  assert.throws(() => pathlight.turn(TASKS[0], { memory: /** @type {any} */ (json) }).next(), { code: "bad_memory" });
  const refused = { code: "invalid_ball" };
  assert.throws(() => memory.remember(TASKS[0], [1, 1, 30], true), refused);
  assert.throws(() => memory.remember("7:8", [1, 1, 30], true), { code: "bad_task" });
  assert.equal(memory.toJson(), json, "nothing has changed");
  const other = await load({ weights: new Uint8Array(readFileSync(join(root, "assets/cross-0.safetensors"))) });
  assert.throws(() => other.turn(TASKS[0], { memory }).next(), { code: "bad_memory", message: /other weights/ });
});
