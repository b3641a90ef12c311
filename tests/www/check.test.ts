// The check: its radius, how the model's guess agrees with it, and the search for an easy ball.

import assert from "node:assert/strict";
import { test } from "node:test";
import { setCheckRadius, sought, toggleCheck, toggleSeeking } from "../../www/core/change/check.ts";
import { answered } from "../../www/core/change/model.ts";
import { place, undo } from "../../www/core/change/placement.ts";
import { advance, drop } from "../../www/core/change/run.ts";
import { agreement, searched, working } from "../../www/core/derived/check.ts";
import { attempts, nextStep } from "../../www/core/derived/duel.ts";
import { MISSING, SOLVING, fresh } from "./player.ts";
import type { State } from "../../www/core/state.ts";
import type { FoundSolutions, Maps } from "../../www/pkg/page/pathlight.js";

const checked = toggleCheck(place(fresh, [100, 100, 17], null));
const key = fresh.puzzle.key;

test("the check begins with the radius of the ball, and stays within the radii that there are", () => {
  assert.equal(checked.check?.radius, 17);
  assert.deepEqual([setCheckRadius(checked, 99).check?.radius, setCheckRadius(checked, 0).check?.radius], [32, 2]);
  assert.equal(toggleCheck(checked).check, null);
});

test("outcomes count for their own radius alone; the model agrees by what of its map lies where a ball works", () => {
  const solutions = { radius: 17, outcomes: Uint8Array.of(1, 2, 3, 3), progress: 1 };
  const placement = Float32Array.of(0.1, 0.1, 0.5, 0.3);
  const known = answered(checked, key, { solutions, maps: { placement } as unknown as Maps });
  assert.equal(working(known), 0.5);
  assert.ok(Math.abs(agreement(known)! - 0.8) < 1e-6);
  assert.deepEqual([working(setCheckRadius(known, 18)), agreement(setCheckRadius(known, 18))], [0, null]);
});

test("the solution that the search has placed runs, but is no attempt", () => {
  const known = answered(fresh, key, { found: found(1, SOLVING) });
  const shown = drop(place(known, SOLVING, null));
  assert.deepEqual([shown.run!.round, attempts(shown), nextStep(advance(shown, 1e6))], [null, [], "back"]);
});

const found = (progress: number, easiest: FoundSolutions["easiest"]): FoundSolutions => ({
  progress,
  easiest,
  valid: 10,
  solved: easiest ? 1 : 0,
  rank: 0.5,
  solves_itself: false,
});

test("the easiest ball is placed once all have been tried, which can be undone; whoever goes on has been told", () => {
  const looking = toggleSeeking(checked);
  const half = sought(looking, key, found(0.5, SOLVING));
  assert.deepEqual([half.placement.ball, searched(half)?.progress], [[100, 100, 17], 0.5]);
  const over = sought(half, key, found(1, SOLVING));
  assert.deepEqual([over.placement.ball, over.check], [SOLVING, { radius: SOLVING[2], seeking: false }]);
  assert.ok(searched(over));
  assert.equal(searched(place(over, MISSING, null)), null);
  assert.deepEqual(undo(over).placement.ball, [100, 100, 17]);
  const none = sought(half, key, found(1, null));
  assert.deepEqual([none.placement.ball, searched(none)?.solved], [[100, 100, 17], 0]);
});

test("what a search finds that was stopped, or of another puzzle, changes nothing", () => {
  const looking = toggleSeeking(checked);
  const stopped: State = toggleSeeking(looking);
  assert.equal(sought(stopped, key, found(1, SOLVING)), stopped);
  assert.equal(sought(looking, "00001:000", found(1, SOLVING)), looking);
});
