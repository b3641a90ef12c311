// The worker's client: answers, updates, aborted calls, crashes.

import assert from "node:assert/strict";
import { test } from "node:test";
import { ModelClient, WorkerError } from "../../www/model/client.ts";
import { FakeWorker } from "./fake-worker.ts";
import type { Failure } from "../../www/core/change/model.ts";

function started() {
  const workers: FakeWorker[] = [];
  const crashes: Failure[] = [];
  const client = new ModelClient(
    () => FakeWorker.in(workers),
    "worker.js",
    (failure) => crashes.push(failure),
  );
  client.start();
  return { client, workers, crashes };
}

const CALL = ["luck", ["00000:000", [1, 2, 3]]] as ["luck", [string, [number, number, number]]];
const never = new AbortController().signal;

test("answers and updates come to the call that asked", async () => {
  const { client, workers } = started();
  const updates: unknown[] = [];
  const one = client.call("solutions", ["00000:000", 5], never, (update) => updates.push(update));
  const other = client.call(...CALL, never);
  workers[0]!.say({ id: 2, value: "second" });
  workers[0]!.say({ id: 1, update: "part" });
  workers[0]!.say({ id: 1, value: "first" });
  assert.deepEqual([await one, await other, updates], ["first", "second", ["part"]]);
});

test("an aborted call rejects at once, is cancelled, and hears no late update", async () => {
  const { client, workers } = started();
  const abort = new AbortController();
  const updates: unknown[] = [];
  const call = client.call("solutions", ["00000:000", 5], abort.signal, (update) => updates.push(update));
  abort.abort();
  await assert.rejects(call, { name: "AbortError" });
  workers[0]!.say({ id: 1, update: "late" });
  assert.deepEqual([updates, workers[0]!.received.at(-1)], [[], { cancel: 1 }]);
  await assert.rejects(client.call(...CALL, abort.signal), { name: "AbortError" });
});

test("a crash rejects every open call and is told once; a new worker answers again", async () => {
  const { client, workers, crashes } = started();
  const calls = [client.call(...CALL, never), client.call(...CALL, never)];
  workers[0]!.say({ id: 1, failure: { code: "crashed", reason: "trap" } });
  for (const call of calls) await assert.rejects(call, WorkerError);
  assert.deepEqual([crashes, workers[0]!.terminated], [[{ code: "crashed", reason: "trap" }], true]);
  // Whoever asks meanwhile is told the same, not that something is broken.
  await assert.rejects(client.call(...CALL, never), (error: WorkerError) => error.failure.code === "crashed");
  client.start();
  const again = client.call(...CALL, never);
  workers[0]!.say({ id: 3, value: "of the old worker" });
  workers[1]!.say({ id: 3, value: "new" });
  assert.equal(await again, "new");
});
