// What a model remembers, as the browser keeps it: one entry for each puzzle, a ball once, and not more than there is
// room for.

import assert from "node:assert/strict";
import { test } from "node:test";
import { BrowserStore } from "../../www/storage/browser-store.js";
import { KeptMemory } from "../../www/storage/kept-memory.js";
import { Progress } from "../../www/storage/progress.js";

const MODEL = "within-0";
const fresh = () => new KeptMemory(new BrowserStore(false));

/** A memory of the wasm's that ends with attempts at a puzzle, each with a ball of its own. */
function json(task, count, rest = {}) {
  const attempts = Array.from({ length: count }, (_, x) => ({ ball: [x, 100, 8], chance: 0.02, solved: false }));
  return JSON.stringify({ version: 1, weights: "ab", forgotten: 0, puzzles: [{ task, attempts, ...rest }] });
}

/** @param {KeptMemory} memory */
const keys = (memory) => memory.puzzles(MODEL).map(({ key }) => key);

test("a puzzle that is played again has one entry, and each ball once", () => {
  const memory = fresh();
  for (const [key, count] of [
    ["a", 1],
    ["b", 2],
    ["a", 3],
  ])
    memory.add(MODEL, { key: String(key), name: null }, json(key, Number(count)));
  assert.deepEqual(
    memory.puzzles(MODEL).map(({ key, attempts }) => [key, attempts.length]),
    [
      ["b", 2],
      ["a", 3],
    ],
  );
  assert.deepEqual(memory.puzzles("cross-0"), []);
});

test("the puzzle that is played is left out", () => {
  const memory = fresh();
  assert.equal(memory.without(MODEL, "a").json, null);
  memory.add(MODEL, { key: "a", name: null }, json("a", 1));
  assert.equal(memory.without(MODEL, "a").json, null);
  memory.add(MODEL, { key: "b", name: "Mine" }, json("b", 1));
  const { puzzles, json: others } = memory.without(MODEL, "a");
  assert.deepEqual(
    puzzles.map(({ name }) => name),
    ["Mine"],
  );
  const { version, weights, puzzles: given } = JSON.parse(others ?? "");
  assert.deepEqual([version, weights, given.length], [1, "ab", 1]);
});

test("the oldest puzzles go when there are too many attempts, or too long scenes", () => {
  const many = fresh();
  for (let place = 0; place < 80; place++) many.add(MODEL, { key: `${place}`, name: null }, json("a", 100));
  const attempts = many.puzzles(MODEL).reduce((sum, { attempts }) => sum + attempts.length, 0);
  assert.ok(attempts > 3000 && attempts <= 4000, `${attempts} attempts`);
  assert.equal(keys(many).at(-1), "79");
  const long = fresh();
  for (const key of ["a", "b", "c"])
    long.add(MODEL, { key, name: null }, json(undefined, 1, { scene: "x".repeat(90_000) }));
  assert.deepEqual(keys(long), ["b", "c"]);
});

test("forgetting is for one model", () => {
  const memory = fresh();
  for (const model of [MODEL, "cross-0"]) memory.add(model, { key: "a", name: null }, json("a", 1));
  memory.forget(MODEL);
  assert.deepEqual(keys(memory), []);
  assert.equal(memory.puzzles("cross-0").length, 1);
});

test("who forgets all progress forgets a memory that the browser has not stored", () => {
  const progress = new Progress(false);
  let changes = 0;
  progress.memory.addEventListener("change", () => changes++);
  progress.memory.add(MODEL, { key: "a", name: null }, json("a", 1));
  progress.clear();
  assert.deepEqual(keys(progress.memory), []);
  assert.equal(changes, 2);
});
