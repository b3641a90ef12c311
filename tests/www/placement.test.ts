// Placing the ball: pointers, gestures, undo.

import assert from "node:assert/strict";
import { test } from "node:test";
import { cancel, drag, nudge, place, press, redo, release, undo } from "../../www/core/change/placement.ts";
import { opened } from "../../www/core/change/route.ts";
import { again } from "../../www/core/change/run.ts";
import { START } from "../../www/core/change/route.ts";
import { MISSING, fresh, playAt, puzzle } from "./player.ts";
import type { State } from "../../www/core/state.ts";

const REACH = { knob: 5, ball: 5 };
const ballOf = ({ placement }: State) => placement.ball;

test("the pointer that began a drag owns it: a palm or a second finger changes nothing", () => {
  const held = press(fresh, 1, [100, 100], REACH);
  const palm = press(held, 2, [30, 200], REACH);
  assert.equal(palm, held);
  assert.equal(drag(palm, 2, [40, 210]), held);
  assert.equal(release(palm, 2), held);
  assert.deepEqual(ballOf(drag(held, 1, [120, 90])), [120, 90, 12]);
});

test("a drag keeps the offset at which the ball was grabbed, and its knob changes the radius", () => {
  const placed = place(fresh, [100, 100, 20], null);
  assert.deepEqual(ballOf(drag(press(placed, 1, [110, 95], REACH), 1, [115, 95])), [105, 100, 20]);
  assert.deepEqual(ballOf(drag(press(placed, 1, [121, 100], REACH), 1, [130, 100])), [100, 100, 30]);
});

test("a ball that is let go where it may not lie goes to a free place nearby, in the same undo step", () => {
  const placed = place(fresh, [100, 100, 12], null);
  const invalid = drag(press(placed, 1, [100, 100], REACH), 1, [5, 90]);
  assert.deepEqual(ballOf(invalid), [5, 90, 12]);
  const settled = release(invalid, 1);
  assert.deepEqual(ballOf(settled), [20, 90, 12]);
  assert.deepEqual(ballOf(undo(settled)), [100, 100, 12]);
});

test("a pointer that the browser takes away, to scroll, has changed nothing", () => {
  assert.deepEqual(cancel(press(fresh, 1, [100, 100], REACH), 1), fresh);
  const over = playAt(fresh, MISSING);
  const swiped = press(over, 1, [50, 50], REACH);
  assert.equal(swiped.run, null);
  assert.deepEqual(cancel(swiped, 1).run, over.run);
});

test("moves of one gesture are undone together, and redone", () => {
  const placed = place(fresh, [100, 100, 12], "link");
  const moved = nudge(nudge(nudge(placed, 1, 0, 0, "key 1"), 1, 0, 0, "key 1"), 0, 1, 0, "key 2");
  assert.deepEqual(ballOf(undo(moved)), [102, 100, 12]);
  assert.deepEqual(ballOf(undo(undo(moved))), [100, 100, 12]);
  assert.deepEqual(ballOf(redo(redo(undo(undo(moved))))), [102, 101, 12]);
  assert.equal(undo(fresh), fresh);
  assert.equal(redo(moved), moved);
});

test("whoever undoes while dragging lets go", () => {
  const placed = place(fresh, [100, 100, 12], null);
  const undone = undo(drag(press(placed, 1, [100, 100], REACH), 1, [120, 100]));
  assert.equal(drag(undone, 1, [150, 100]), undone);
});

test("the ball is whole numbers within the scene and the radii", () => {
  assert.deepEqual(ballOf(place(fresh, [300.4, -7, 99], null)), [255, 0, 32]);
  assert.deepEqual(ballOf(place(fresh, [10.6, 20.4, 0.2], null)), [11, 20, 2]);
});

test("whatever touches the ball ends what is played, and a tap in the scene is a new attempt", () => {
  const over = playAt(fresh, MISSING);
  const tapped = release(press(over, 1, [60, 60], REACH), 1);
  assert.deepEqual([tapped.run, ballOf(tapped)], [null, [60, 60, 12]]);
  assert.deepEqual(ballOf(again(over)), MISSING);
});

test("another puzzle begins without a ball, unless the link has one", () => {
  const placed = place(fresh, [100, 100, 12], null);
  assert.equal(ballOf(opened(placed, { ...START, task: "00001:000" }, puzzle("00001:000"))), null);
  const linked = opened(placed, { ...START, task: "00001:000", ball: [9, 9, 9] }, puzzle("00001:000"));
  assert.deepEqual(ballOf(linked), [9, 9, 9]);
});
