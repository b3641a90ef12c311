// Calls of the worker: answers, updates, failures and aborts.

import assert from "node:assert/strict";
import { getEventListeners } from "node:events";
import { test } from "node:test";
import { LOADED, MODULE, settled, workers } from "./fake-worker.mjs";
import { WorkerClient } from "../../www/model/worker-client.js";
import { useLanguage } from "../../www/text/text.js";

const TASK = "00007:008";

/** A client whose model is loaded, and its worker. */
async function ready() {
  const client = new WorkerClient(MODULE);
  client.start(null);
  const worker = /** @type {import("./fake-worker.mjs").FakeWorker} */ (workers.at(-1));
  worker.answer("load", { value: LOADED });
  await settled();
  assert.equal(client.status, "ready");
  return { client, worker };
}

test("the progress of the weights is told until the model is there", async () => {
  const client = new WorkerClient(MODULE);
  const seen = [];
  client.addEventListener("change", () => seen.push([client.status, client.progress]));
  client.start("cross-0");
  const [worker] = workers.slice(-1);
  assert.deepEqual(worker.sent[0].args, [MODULE, "cross-0"]);
  for (const update of [0, null, 0.5]) worker.answer("load", { update });
  worker.answer("load", { value: LOADED });
  await settled();
  assert.deepEqual(seen, [
    ["loading", null],
    ["loading", 0],
    ["loading", null],
    ["loading", 0.5],
    ["ready", null],
  ]);
});

test("a call sends its arguments, hears updates, and resolves", async () => {
  const { client, worker } = await ready();
  const { signal } = new AbortController();
  const updates = [];
  const call = client.call("solve", [TASK, 12], signal, (map) => updates.push(map.progress));
  assert.deepEqual(worker.sent.at(-1).args, [TASK, 12]);
  worker.answer("solve", { update: { progress: 0.5, outcomes: new Uint8Array() } });
  worker.answer("solve", { value: undefined });
  assert.equal(await call, undefined);
  assert.deepEqual(updates, [0.5]);
});

test("an error of the worker rejects its call with the code", async () => {
  const { client, worker } = await ready();
  const call = client.call("luck", [TASK, [1, 2, 3]], new AbortController().signal);
  worker.answer("luck", { error: { code: "invalid_ball", message: "No room." } });
  await assert.rejects(call, { code: "invalid_ball", message: "No room." });
});

test("a page in another language says an error by its code", async () => {
  await useLanguage("de");
  try {
    const client = new WorkerClient(MODULE);
    client.start("within-7");
    workers.at(-1)?.answer("load", { error: { code: "no_model", message: "There is no model “within-7” here." } });
    await settled();
    assert.deepEqual(client.failure, { code: "no_model", message: "Dieses Modell gibt es hier nicht." });
  } finally {
    await useLanguage("en");
  }
});

test("an abort cancels the call, and late messages are not heard", async () => {
  const { client, worker } = await ready();
  const call = new AbortController();
  const updates = [];
  const turn = client.call("turn", [TASK], call.signal, (attempt) => updates.push(attempt));
  const { id } = worker.sent.at(-1);
  call.abort(new Error("left"));
  await assert.rejects(turn, { message: "left" });
  assert.deepEqual(worker.sent.at(-1), { cancel: id });
  worker.answer("turn", { update: {} });
  worker.answer("turn", { value: undefined });
  assert.deepEqual(updates, []);
  await assert.rejects(client.call("turn", [TASK], call.signal), { message: "left" });
});

test("calls that have ended leave nothing behind on their signal", async () => {
  const { client, worker } = await ready();
  const { signal } = new AbortController();
  for (let time = 0; time < 3; time += 1) {
    const imagined = client.call("imagine", [TASK], signal);
    worker.answer("imagine", time === 1 ? { error: { code: "broken", message: "Once." } } : { value: {} });
    await imagined.catch(() => {});
  }
  assert.equal(getEventListeners(signal, "abort").length, 0);
});

test("a crash rejects all open calls with a sentence, and those that follow", async () => {
  const { client, worker } = await ready();
  const { signal } = new AbortController();
  const calls = [client.call("imagine", [TASK], signal), client.call("watch", [TASK], signal)];
  worker.answer("watch", { error: { code: "crashed", message: "unreachable" } });
  for (const call of [...calls, client.call("watch", [TASK], signal)])
    await assert.rejects(call, { message: "The model has stopped (unreachable)." });
  assert.deepEqual([client.status, client.failure?.code, client.alive], ["failed", "crashed", false]);
  assert.ok(worker.terminated);
});
