// Which puzzle comes next.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { neighbour, nextTask, taskOf } from "../../www/core/derived/next.ts";
import { fold, initSync } from "../../www/pkg/page/pathlight.js";
import { benchmark as shipped } from "../../www/simulator.ts";

const tasks = ["00000:000", "00000:001", "00001:000", "00001:001", "00002:000"];
const benchmark = {
  tasks,
  rates: Float64Array.of(0.5, 0.4, 0.38, 0.1, 0.42),
  unseen: new Set(["00000:001", "00001:000", "00001:001", "00002:000"]),
};
const never = () => false;

test("it is new to person and model, of another kind, and a little harder", () => {
  assert.equal(nextTask(benchmark, "00000:000", never), "00002:000");
  assert.equal(
    nextTask(benchmark, "00000:000", (task) => task === "00002:000"),
    "00001:000",
  );
});

test("without a puzzle it is the easiest that is new", () => {
  assert.equal(nextTask(benchmark, null, never), "00002:000");
});

test("once all are tried there is still a next one", () => {
  assert.notEqual(
    nextTask(benchmark, "00000:000", () => true),
    "00000:000",
  );
});

test("the list of all is a ring; a lesson ends", () => {
  const by = (from: string | null, places: number, wraps = true) => neighbour(benchmark.tasks, from, places, wraps);
  assert.deepEqual([by("00002:000", 1), by("00000:000", -1), by(null, 1)], ["00000:000", "00002:000", "00000:001"]);
  assert.deepEqual([by("00002:000", 1, false), by("00000:000", -1, false)], [undefined, undefined]);
  assert.equal(by("00000:000", 1, false), "00000:001");
});

test("a puzzle is found by its number, however it is written", () => {
  for (const text of ["00007:008", "7:8", " 7 8 ", "00007.008"]) assert.equal(taskOf(text), "00007:008", text);
  for (const text of ["", "7", "funnel", "7:8:9"]) assert.equal(taskOf(text), null, text);
});

test("what is new to a model are the test tasks of its fold", () => {
  initSync({ module: readFileSync("www/pkg/page/pathlight_bg.wasm") });
  for (const setup of ["within", "cross"] as const)
    assert.deepEqual([...shipped(setup).unseen].sort(), fold(setup, 0).test);
});
