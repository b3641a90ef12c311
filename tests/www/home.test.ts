// The home page: the show in its picture, the kinds of puzzles, those to begin with, and progress.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { endIntro, setRecorded, showAgain, tick, toggleIntro } from "../../www/core/change/home.ts";
import { answered } from "../../www/core/change/model.ts";
import { place, undo } from "../../www/core/change/placement.ts";
import { START, opened } from "../../www/core/change/route.ts";
import { drop } from "../../www/core/change/run.ts";
import { nextStep, verdict } from "../../www/core/derived/duel.ts";
import {
  introPaths,
  introPhase,
  introShown,
  isHome,
  kindsOf,
  progress,
  standing,
  taskOfDay,
  unsolvedTask,
} from "../../www/core/derived/home.ts";
import { FIRST_TASK } from "../../www/core/derived/next.ts";
import { addressOf } from "../../www/effects/address.ts";
import { MISSING, SOLVING, fresh, line, playAt, puzzle, withTurn } from "./player.ts";
import type { Futures, Recorded } from "../../www/core/change/home.ts";

const path = [10, 20, 30, 40];
const FUTURES: Futures = {
  futures: [
    { probability: 0.8, path },
    { probability: 0.2, path },
  ],
  ball: MISSING,
  imagined: { object: path, ball: path, errors: [1, 1], probability: 0.8 },
};
const recorded: Recorded = JSON.parse(readFileSync("assets/home.json", "utf8"));

const home = opened(fresh, START, puzzle());
const shown = answered(home, home.puzzle.key, { futures: FUTURES });

test("futures fan out, one is picked, its ball falls, and the end is looked at; three times", () => {
  assert.ok(isHome(shown) && introShown(shown));
  assert.equal(introPhase(shown), "imagine");
  assert.deepEqual([...introPaths(tick(shown, 2599)).hints[0]!.object].map(Math.round), path);
  const picked = tick(shown, 3000);
  assert.equal(introPhase(picked), "pick");
  assert.deepEqual(introPaths(picked).imagined!.of, MISSING);
  const falling = tick(picked, 2000);
  assert.equal(introPhase(falling), "real");
  assert.deepEqual(falling.run!.balls, [{ ball: MISSING, of_model: true }]);
  const over = tick(falling, 2000);
  assert.equal(introPhase(over), "result");
  assert.equal(verdict(over), null);
  let state = tick(over, 5000);
  assert.equal(introPhase(state), "imagine");
  for (let second = 0; second < 100; second++) state = tick(state, 1000);
  assert.equal(state.intro!.playing, false);
  assert.equal(introPhase(state), "result");
  assert.equal(introPhase(toggleIntro(state)), "imagine");
});

test("it waits until something is imagined, can be paused, and stands still where motion is unwelcome", () => {
  assert.equal(tick(home, 5000), home);
  const paused = toggleIntro(tick(shown, 1000));
  assert.equal(tick(paused, 5000), paused);
  const still = { ...shown, device: { ...shown.device, stillness: true } };
  const end = tick(still, 1);
  assert.equal(introPhase(end), "result");
  assert.equal(tick(end, 1).intro!.playing, false);
});

test("whoever places a ball, or starts, plays the puzzle in the picture, and its address stays the home page's", () => {
  const falling = tick(tick(shown, 5000), 100);
  const placed = place(falling, SOLVING, null);
  assert.equal(introShown(placed), false);
  assert.equal(placed.run, null);
  assert.equal(addressOf(placed), "#");
  assert.equal(verdict(tick(drop(withTurn(placed, MISSING)), 1e6))!.outcome, "won");
  assert.ok(introShown(undo(placed)));
  assert.equal(nextStep(falling), "start");
  const started = endIntro(falling);
  assert.equal(nextStep(started), "drop");
  assert.equal(tick(started, 5000), started);
  const back = showAgain(place(started, MISSING, null));
  assert.ok(introShown(back) && back.placement.ball === null);
});

test("the first puzzle has been recorded", () => {
  assert.equal(recorded.scene.task, FIRST_TASK);
});

const tasks = ["00000:000", "00000:001", "00000:002", "00001:000", "00001:001", "00001:002"];
const benchmark = {
  tasks,
  rates: Float64Array.of(0.9, 0.02, 0.3, 0.4, 0.001, 0.5),
  unseen: new Set(["00000:001", "00000:002", "00001:000", "00001:001"]),
};

test("a kind leads through puzzles that are new to the model, the easiest first, and says how far one has come", () => {
  const kinds = kindsOf(benchmark);
  assert.deepEqual(kinds, [
    { id: "00001", tasks: ["00001:000", "00001:001"] },
    { id: "00000", tasks: ["00000:002", "00000:001"] },
  ]);
  const kind = kinds[1]!;
  assert.deepEqual(standing(kind, {}), { task: "00000:002", number: 1, played: [] });
  const attempts = { "00000:002": [line(MISSING), line(SOLVING)], "00000:001": [line(MISSING)] };
  const played = [
    { number: 1, solved: true },
    { number: 2, solved: false },
  ];
  assert.deepEqual(standing(kind, attempts), { task: "00000:001", number: 2, played });
});

test("the puzzle of a day is new to the model, not too hard, and another one the next day", () => {
  const days = [20_000, 20_001, 20_002].map((day) => taskOfDay(benchmark, day));
  assert.deepEqual(days.toSorted(), ["00000:001", "00000:002", "00001:000"]);
});

test("of those that the model never solved, the first is offered that the person has not solved", () => {
  assert.equal(unsolvedTask(fresh), null);
  const known = setRecorded(fresh, { ...recorded, unsolved: ["00000:000", "00001:000"] });
  assert.equal(unsolvedTask(known), "00000:000");
  assert.equal(unsolvedTask(playAt(known, SOLVING)), "00001:000");
});

test("progress counts puzzles and balls", () => {
  assert.deepEqual(progress(playAt(fresh, MISSING)), { tried: 1, solved: 0, attempts: 1 });
});
