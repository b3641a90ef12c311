// Undo and redo without a page.

import assert from "node:assert/strict";
import { test } from "node:test";
import { UndoStack } from "../../www/play/undo-stack.js";

test("values are undone and redone in order, and the ends hold", () => {
  const stack = new UndoStack("first");
  assert.deepEqual([stack.canUndo, stack.canRedo], [false, false]);
  for (const value of ["second", "third"]) stack.push(value);
  assert.deepEqual([stack.undo(), stack.undo(), stack.undo()], ["second", "first", "first"]);
  assert.deepEqual([stack.canUndo, stack.canRedo], [false, true]);
  assert.deepEqual([stack.redo(), stack.redo(), stack.redo()], ["second", "third", "third"]);
});

test("a new value forgets those that were undone", () => {
  const stack = new UndoStack(1);
  stack.push(2);
  stack.undo();
  stack.push(3);
  assert.equal(stack.canRedo, false);
  assert.equal(stack.undo(), 1);
});

test("values of one gesture are one step; an undo ends the gesture", () => {
  const stack = new UndoStack(0);
  const drag = {};
  for (const value of [1, 2, 3]) stack.push(value, drag);
  assert.equal(stack.undo(), 0);
  assert.equal(stack.redo(), 3);
  stack.push(4, drag);
  assert.equal(stack.undo(), 3);
});

test("a value that equals the present one is no step", () => {
  const stack = new UndoStack([1, 2]);
  stack.push([1, 2]);
  assert.equal(stack.canUndo, false);
});
