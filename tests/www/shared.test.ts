// The worker that puzzles share: it is loaded once, told to all, and ends with the last of them.

import assert from "node:assert/strict";
import { test } from "node:test";
import { SharedModel } from "../../www/model/shared.ts";
import { FakeWorker } from "./fake-worker.ts";
import type { Model } from "../../www/core/change/model.ts";

const FILES = { worker: "worker.js", wasm: "https://a.test/w.wasm", weights: {} };
const settled = () => new Promise((resolve) => setImmediate(resolve));

function following(model: SharedModel) {
  const told: Model["kind"][] = [];
  const leaving = new AbortController();
  void model.follow(({ kind }) => told.push(kind), leaving.signal);
  return { told, leave: () => leaving.abort() };
}

test("the weights are loaded once, and whoever comes later has them at once", async () => {
  const workers: FakeWorker[] = [];
  const model = new SharedModel(FILES, "within", () => FakeWorker.in(workers));
  const first = following(model);
  void model.start();
  void model.start();
  workers[0]!.say({ id: 1, value: {} });
  await settled();
  const second = following(model);
  void model.start();
  assert.deepEqual([workers.length, first.told, second.told], [1, ["loading", "ready"], ["ready"]]);
});

test("after a failure it can be started again, for all", async () => {
  const workers: FakeWorker[] = [];
  const model = new SharedModel(FILES, "within", () => FakeWorker.in(workers));
  const puzzles = [following(model), following(model)];
  void model.start();
  workers[0]!.say({ id: 1, failure: { code: "crashed", reason: "trap" } });
  await settled();
  void model.start();
  for (const { told } of puzzles) assert.deepEqual(told, ["loading", "failed", "loading"]);
  assert.equal(workers.length, 2);
});

test("the worker ends with the last puzzle, and a later one starts another", async () => {
  const workers: FakeWorker[] = [];
  const model = new SharedModel(FILES, "within", () => FakeWorker.in(workers));
  const puzzles = [following(model), following(model)];
  void model.start();
  puzzles[0]!.leave();
  await settled();
  assert.equal(workers[0]!.terminated, false);
  puzzles[1]!.leave();
  await settled();
  assert.equal(workers[0]!.terminated, true);
  const later = following(model);
  void model.start();
  assert.deepEqual([workers.length, later.told], [2, ["loading"]]);
});
