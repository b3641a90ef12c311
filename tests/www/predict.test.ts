// Predicting: drawing from the green object on, letting it run, and the score.

import assert from "node:assert/strict";
import { test } from "node:test";
import { answered } from "../../www/core/change/model.ts";
import { place, redo, undo } from "../../www/core/change/placement.ts";
import { openPanel } from "../../www/core/change/route.ts";
import { advance, again } from "../../www/core/change/run.ts";
import {
  cancelSketch,
  dragSketch,
  letRun,
  nudgeSketch,
  pressSketch,
  releaseSketch,
  wipe,
} from "../../www/core/change/sketch.ts";
import { attempts, nextStep, verdict } from "../../www/core/derived/duel.ts";
import { shownGuess, shownLayers } from "../../www/core/derived/imagined.ts";
import { prediction } from "../../www/core/derived/prediction.ts";
import { MISSING, SOLVING, fresh, playAt, withTurn } from "./player.ts";
import type { Point } from "../../www/core/change/placement.ts";
import type { Ball, ImaginedBall, Maps } from "../../www/pkg/page/pathlight.js";
import type { State } from "../../www/core/state.ts";

const REACH = { knob: 10, ball: 0 };
const predicting = openPanel(withTurn(fresh, SOLVING), "predict");
const drawn = (state: State, ...points: Point[]) =>
  releaseSketch(
    points.reduce((state, point) => dragSketch(state, 1, point), pressSketch(state, 1, [52, 49], REACH)),
    1,
  );
const line = drawn(predicting, [60, 60], [70, 80]);

test("a line begins at the green object, goes on from its end, and leaves out what is too short", () => {
  assert.deepEqual(line.sketch, {
    line: [
      [50, 50],
      [60, 60],
      [70, 80],
    ],
    drawing: null,
  });
  const longer = releaseSketch(dragSketch(pressSketch(line, 2, [72, 82], REACH), 2, [900, 90]), 2);
  assert.deepEqual(longer.sketch.line.at(-1), [256, 90]);
  assert.equal(dragSketch(pressSketch(line, 2, [70, 80], REACH), 2, [71, 80]).sketch.line.length, 3);
  assert.deepEqual(drawn(line, [40, 40]).sketch.line, [
    [50, 50],
    [40, 40],
  ]);
});

test("a press beside the object, within reach, begins the line", () => {
  const overlaps = ([x, , r]: Ball) => x - r < 60;
  const near = (ball: Ball) => (overlaps(ball) ? ({ kind: "overlaps", body: 0 } as const) : null);
  const state = { ...predicting, puzzle: { ...predicting.puzzle, whyInvalid: near } };
  assert.deepEqual(pressSketch(state, 1, [69, 50], REACH).sketch.line, [[50, 50]]);
  assert.deepEqual(pressSketch(state, 1, [71, 50], REACH).sketch.line, []);
});

test("a run does not stay for a prediction, which needs the scene as it was", () => {
  const over = playAt(withTurn(fresh, SOLVING), MISSING);
  assert.notEqual(openPanel(over, "imagine").run, null);
  assert.equal(openPanel(over, "predict").run, null);
});

test("off the object the pointer places the ball; one that the browser takes away leaves the line", () => {
  const placed = pressSketch(line, 1, [150, 150], REACH);
  assert.deepEqual([placed.placement.ball, placed.sketch.line.length], [[150, 150, 12], 3]);
  const drawing = dragSketch(pressSketch(line, 1, [50, 50], REACH), 1, [10, 10]);
  assert.deepEqual(cancelSketch(drawing, 1).sketch, line.sketch);
  assert.equal(pressSketch(drawing, 2, [150, 150], REACH), drawing);
});

test("line and ball are undone in the order in which they were made", () => {
  const both = drawn(place(place(predicting, MISSING, null), null, null), [90, 90]);
  const undone = [undo(both), undo(undo(both)), undo(undo(undo(both)))];
  const seen = [both, ...undone].map(({ sketch, placement }) => [sketch.line.length, placement.ball]);
  assert.deepEqual(seen, [
    [2, null],
    [0, null],
    [0, MISSING],
    [0, null],
  ]);
  assert.deepEqual(redo(undone[0]!).sketch, both.sketch);
  assert.deepEqual(undo(wipe(both)).sketch, both.sketch);
});

test("keys draw too, and change the size of the ball", () => {
  const drawn = nudgeSketch(nudgeSketch(predicting, 1, 0, 0, "key"), 0, -10, 0, "key");
  assert.deepEqual(drawn.sketch.line, [
    [50, 50],
    [55, 50],
    [55, 0],
  ]);
  assert.equal(nudgeSketch(place(drawn, MISSING, null), 0, 0, 1, "key").placement.ball![2], 13);
  assert.deepEqual(wipe(drawn).sketch.line, []);
});

test("without a ball the scene runs alone, and the model is measured by its base path, shown at the end", () => {
  assert.equal(letRun(predicting).run, null);
  const maps = { base: Float32Array.of(1, 0, 0, 0) } as Maps;
  const running = letRun(answered(line, line.puzzle.key, { maps }));
  assert.deepEqual(
    [running.run!.balls, prediction(running), shownLayers(running)],
    [[{ ball: null, of_model: false }], null, []],
  );
  const over = advance(running, 1e6);
  assert.deepEqual([prediction(over), shownLayers(over), nextStep(over)], [{ you: 1, model: 0.5 }, ["base"], "back"]);
  assert.equal(attempts(over).length, 0);
  assert.deepEqual([nextStep(again(over)), again(over).sketch], ["run", line.sketch]);
});

test("with a ball it is an attempt, alone, and the model is measured by what it imagines for that ball", () => {
  const imagined = { object: Float32Array.of(60, 60, 70, 80), probability: 0.5 } as ImaginedBall;
  const placed = answered(place(line, MISSING, null), line.puzzle.key, { guess: { of: MISSING, imagined } });
  assert.equal(shownGuess(placed), null);
  const over = advance(letRun(placed), 1e6);
  assert.deepEqual(over.run!.balls, [{ ball: MISSING, of_model: false }]);
  assert.deepEqual([prediction(over), attempts(over).length], [{ you: 1, model: 1 }, 1]);
  assert.ok(shownGuess(over));
  assert.equal(verdict(over)!.round, 1);
  assert.equal(attempts(advance(letRun(again(over)), 1e6)).length, 1);
});
