// The worker itself, in Node: long calls send updates and answer, and a cancel ends them.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";

const TASK = "00007:008";
const sent = [];
const channels = [];
let receive;
let nextId = 1;

before(async () => {
  Object.assign(globalThis, {
    MessageChannel: class extends MessageChannel {
      constructor() {
        super();
        channels.push(this);
      }
    },
    addEventListener: (_, listener) => (receive = (data) => listener({ data })),
    postMessage: (message) => sent.push(message),
  });
  await import("../../www/model/worker.js");
  const wasm = await readFile(new URL("../../www/pkg/pathlight_bg.wasm", import.meta.url));
  // The sources have no weights beside them, and the calls below need none.
  await request("load", await WebAssembly.compile(wasm), null);
  assert.equal(last().error.code, "no_weights");
});

// An open channel would keep Node from ending.
after(() => channels.forEach(({ port1 }) => port1.close()));

const last = () => sent[sent.length - 1];
const request = (call, ...args) => receive({ id: nextId++, call, args });
const updatesOf = (id) => sent.filter((message) => message.id === id && message.update !== undefined);

test("a call is answered with its value", async () => {
  await request("luck", TASK, [20, 240, 5]);
  assert.deepEqual(Object.keys(last().value).sort(), ["solved", "valid"]);
});

test("a bad argument is answered with a code", async () => {
  await request("watch", "7:8");
  assert.equal(last().error.code, "bad_task");
});

test("a list is answered as a whole, without updates", async () => {
  const id = nextId;
  await request("attemptLines", TASK, [
    [20, 240, 5],
    [30, 240, 5],
  ]);
  const lines = last().value;
  assert.equal(lines.length, 2);
  await request("verify", lines);
  assert.deepEqual(last().value, [{ verdict: "same" }, { verdict: "same" }]);
  assert.equal(updatesOf(id).length + updatesOf(id + 1).length, 0);
});

test("a map of all places ends with all of them", async () => {
  const id = nextId;
  await request("solve", TASK, 32);
  assert.equal(updatesOf(id).at(-1).update.progress, 1);
  assert.deepEqual(last(), { id, value: undefined });
});

test("a search that is cancelled sends nothing more", async () => {
  const id = nextId;
  const search = request("search", TASK);
  while (updatesOf(id).length === 0) await new Promise((resolve) => setImmediate(resolve));
  receive({ cancel: id });
  const count = updatesOf(id).length;
  await search;
  assert.equal(updatesOf(id).length, count);
  assert.ok(last().id === id && last().value === undefined);
});
