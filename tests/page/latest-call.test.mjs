// The newest question counts: those in between are left out, and a failure leaves out none that waits.

import assert from "node:assert/strict";
import { test } from "node:test";
import { LatestCall } from "../../www/model/latest-call.js";

/** A LatestCall with what it has asked and heard; `settle` answers the oldest open question. */
function asking() {
  const log = [];
  const open = [];
  const calls = new LatestCall(
    (question, signal) => {
      log.push(`ask ${question}`);
      return new Promise((resolve, reject) => open.push({ resolve, reject, signal }));
    },
    (answer, question) => log.push(`${answer} to ${question}`),
    (message) => log.push(`failed: ${message}`),
  );
  const settle = async (how) => {
    how(open.shift());
    await new Promise((resolve) => setImmediate(resolve));
  };
  return { calls, log, open, settle };
}

const answers = ({ resolve }) => resolve("answer");
const fails = ({ reject }) => reject(new Error("no answer"));

test("of the questions that come meanwhile the last is asked", async () => {
  const { calls, log, settle } = asking();
  for (const question of [1, 2, 3]) calls.ask(question);
  await settle(answers);
  await settle(answers);
  assert.deepEqual(log, ["ask 1", "answer to 1", "ask 3", "answer to 3"]);
  calls.ask(4);
  assert.equal(log.at(-1), "ask 4");
});

test("a question that waits is asked when the one before fails", async () => {
  const { calls, log, settle } = asking();
  calls.ask(1);
  calls.ask(2);
  await settle(fails);
  assert.deepEqual(log, ["ask 1", "ask 2"]);
  await settle(answers);
  assert.equal(log.at(-1), "answer to 2");
});

test("a failure of the newest question is told, and the next one is asked", async () => {
  const { calls, log, settle } = asking();
  calls.ask(1);
  await settle(fails);
  calls.ask(2);
  assert.deepEqual(log, ["ask 1", "failed: no answer", "ask 2"]);
});

test("after a stop neither answer nor failure is told, and another question is asked at once", async () => {
  for (const end of [answers, fails]) {
    const { calls, log, open, settle } = asking();
    calls.ask(1);
    calls.ask(2);
    calls.stop();
    assert.ok(open[0].signal.aborted);
    calls.ask(3);
    await settle(end);
    await settle(answers);
    assert.deepEqual(log, ["ask 1", "ask 3", "answer to 3"]);
  }
});
