// How fast the moments of a run are played.

import assert from "node:assert/strict";
import { test } from "node:test";
import { paceAt, quietEnd } from "../../www/play/pace.js";

const MOMENTS = { quiet: /** @type {[number, number][]} */ ([[100, 400]]), deciding: 500 };

test("a stretch in which nothing moves is played fast, after a moment of rest, and can be skipped", () => {
  assert.equal(paceAt(MOMENTS, 50), 1);
  assert.equal(paceAt(MOMENTS, 110), 1);
  assert.ok(paceAt(MOMENTS, 200) > 2);
  assert.equal(quietEnd(MOMENTS, 200), 400);
  assert.equal(paceAt(MOMENTS, 400), 1);
  assert.equal(quietEnd(MOMENTS, 450), null);
});

test("the touch that decides is slow, shortly before and after", () => {
  assert.deepEqual(
    [480, 495, 505, 520].map((step) => paceAt(MOMENTS, step) < 1),
    [false, true, true, false],
  );
  assert.equal(paceAt({ ...MOMENTS, deciding: null }, 500), 1);
});
