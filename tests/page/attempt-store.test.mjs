// The kept attempts where the browser takes no more, or another tab writes too.

import assert from "node:assert/strict";
import { test } from "node:test";
import { AttemptStore } from "../../www/storage/attempt-store.js";
import { BrowserStore } from "../../www/storage/browser-store.js";
import { formatAttempts } from "../../www/storage/attempt-lines.js";

const TASK = "00007:008";
const KEY = `attempts.${TASK}`;

/** @type {(x: number) => import("../../www/storage/attempt-lines.js").KeptAttempt} */
const attempt = (x) => ({
  puzzle: TASK,
  by: "player",
  number: x,
  ball: [x, 100, 8],
  ending: { solved: false, steps: 900, longest_touch: 0, final_touch: 0 },
  simulator: 3,
});

test("what the browser had not taken is added to what another tab has written meanwhile", () => {
  const entries = new Map();
  let full = true;
  Object.assign(globalThis, {
    localStorage: {
      getItem: (/** @type {string} */ key) => entries.get(key) ?? null,
      setItem(/** @type {string} */ key, /** @type {string} */ text) {
        if (full) throw new DOMException("full", "QuotaExceededError");
        entries.set(key, text);
      },
      removeItem: (/** @type {string} */ key) => entries.delete(key),
    },
  });
  const store = new BrowserStore(true);
  const attempts = new AttemptStore(store, () => null);
  attempts.write(TASK, [attempt(1)]);
  assert.deepEqual(store.unwritten, [KEY]);

  entries.set(`pathlight.${KEY}`, formatAttempts([attempt(2), attempt(3)]));
  attempts.refresh(KEY);
  const balls = () => attempts.in(TASK).map(({ ball }) => ball[0]);
  assert.deepEqual(balls(), [2, 3, 1], "also while there is no room");

  full = false;
  attempts.write(TASK, [...attempts.in(TASK), attempt(4)]);
  const stored = new AttemptStore(new BrowserStore(true), () => null);
  assert.deepEqual(
    stored.in(TASK).map(({ ball }) => ball[0]),
    [2, 3, 1, 4],
  );
});
