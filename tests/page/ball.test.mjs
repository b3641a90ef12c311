// Balls as values.

import assert from "node:assert/strict";
import { test } from "node:test";
import { sameBall } from "../../www/puzzles/ball.js";

test("balls are the same by place and radius", () => {
  assert.ok(sameBall([1, 2, 3], [1, 2, 3]));
  assert.equal(sameBall([1, 2, 3], [0, 2, 3]), false);
  assert.equal(sameBall([1, 2, 3], [1, 0, 3]), false);
  assert.equal(sameBall([1, 2, 3], [1, 2, 0]), false);
});

test("no ball is the same as no ball alone", () => {
  assert.ok(sameBall(null, undefined));
  assert.equal(sameBall(null, [1, 2, 3]), false);
  assert.equal(sameBall([1, 2, 3], undefined), false);
});
