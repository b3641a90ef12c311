// What older versions have stored in the browser, and saved as files, is read as they meant it. The modules run in
// Node, without the wasm.

import assert from "node:assert/strict";
import { test } from "node:test";
import { Progress } from "../../www/storage/progress.js";
import { progressOfText } from "../../www/storage/progress-file.js";
import { PuzzleStore } from "../../www/storage/puzzle-store.js";
import { atOnce } from "../../www/storage/sliced-work.js";

const TASK = "00007:008";
const DIGEST = "c".repeat(64);
const SCENE = { version: 1, name: "Over", body1: 0, body2: 1, bodies: [] };
const TIMES = { steps: 312, longest_touch: 180, final_touch: 180 };

/** Lines as they were stored before attempts had numbers. */
const LINES = [
  { task: TASK, by: "player", ball: [10, 200, 8], status: "not_solved", ...TIMES, simulator: 3 },
  { task: TASK, by: "player", ball: [20, 200, 8], status: "solved", ...TIMES, simulator: 3 },
  { task: TASK, by: "within-0", ball: [30, 200, 8], status: "solved", ...TIMES, simulator: 3, agents: 4 },
];
const CUSTOM_LINE = { scene: DIGEST, by: "player", ball: [40, 200, 8], status: "solved", ...TIMES, simulator: 3 };
/** The player's misses before the solution were deleted, but counted. */
const COUNTS = { [TASK]: { attempts: 5, solved: 4 }, "00000:001": { attempts: 2, solved: null } };
const MODELS = { "within-0": { [TASK]: { attempts: 1, solved: 1 }, "00000:002": { attempts: 100, solved: null } } };

const jsonLines = (lines) => lines.map((line) => `${JSON.stringify(line)}\n`).join("");

/** localStorage with these entries. */
function stored(entries) {
  const storage = { ...entries };
  for (const [name, value] of Object.entries({
    getItem: (key) => storage[key] ?? null,
    setItem: (key, text) => (storage[key] = text),
    removeItem: (key) => delete storage[key],
  }))
    Object.defineProperty(storage, name, { value });
  globalThis.localStorage = /** @type {any} */ (storage);
  return storage;
}

/** A device on which a file is read that an older version has saved. */
function read(text) {
  const progress = new Progress(false);
  const { attempts, counts, unread } = atOnce(progressOfText(text, () => DIGEST));
  assert.equal(unread, 0);
  atOnce(progress.merging(attempts, counts));
  return progress;
}

function assertAsCounted(progress) {
  for (const [task, counts] of Object.entries(COUNTS)) assert.deepEqual(progress.player.of(task), counts);
  for (const [name, tasks] of Object.entries(MODELS))
    for (const [task, counts] of Object.entries(tasks)) assert.deepEqual(progress.ofModel(name).of(task), counts);
}

test("what is stored: counts, attempts at tasks and custom scenes, puzzles", () => {
  const storage = stored({
    "pathlight.progress": JSON.stringify({ tasks: COUNTS }),
    "pathlight.model.within-0": JSON.stringify({ tasks: MODELS["within-0"] }),
    [`pathlight.attempts.${TASK}`]: jsonLines(LINES),
    "pathlight.attempts.own": jsonLines([CUSTOM_LINE]),
    "pathlight.own-puzzles": JSON.stringify([SCENE]),
  });
  const progress = new Progress(true);
  assertAsCounted(progress);
  assert.deepEqual(
    progress
      .attemptsAt(TASK)
      .map(({ by, number, ball }) => [by, number, ball[0]])
      .sort(),
    [
      ["player", 1, 10],
      ["player", 4, 20],
      ["within-0", 1, 30],
    ],
  );
  assert.equal(progress.attemptsAt(DIGEST)[0].ending.solved, true);
  assert.deepEqual(new PuzzleStore().scenes, [SCENE]);
  // An attempt that is made now counts on.
  const ending = { solved: false, steps: 1, longest_touch: 0, final_touch: 0 };
  progress.add(TASK, "player", [{ ball: [50, 200, 8], ending }], { simulator: 3 });
  assert.deepEqual(progress.player.of(TASK), { attempts: 6, solved: 4 });
  assert.deepEqual(new Progress(true).player.of(TASK), { attempts: 6, solved: 4 });
  progress.clear();
  assert.deepEqual(Object.keys(storage), ["pathlight.own-puzzles"], "all of the progress is forgotten, models’ too");
});

test("a file of counts alone", () => {
  const progress = read(JSON.stringify({ tasks: COUNTS }, null, 1));
  assert.deepEqual([progress.player.tasks, progress.all], [Object.keys(COUNTS).sort(), []]);
  assert.deepEqual(progress.player.of(TASK), COUNTS[TASK]);
});

test("a file of counts and attempts", () => {
  const file = { tasks: COUNTS, models: MODELS, attempts: [...LINES, CUSTOM_LINE] };
  const progress = read(JSON.stringify(file, null, 1));
  assertAsCounted(progress);
  assert.equal(progress.all.length, 4);
});

test("a file of attempts at one puzzle, with digests and scenes", () => {
  const lines = [LINES[1], { ...CUSTOM_LINE, scene: SCENE, digest: "d".repeat(64) }].map((line) => ({
    ...line,
    digest: DIGEST,
  }));
  const progress = read(jsonLines(lines));
  assert.deepEqual(progress.player.of(TASK), { attempts: 1, solved: 1 });
  assert.equal(progress.attemptsAt(DIGEST).length, 1);
});

test("a file that was cut off gives what is whole", () => {
  const whole = `{\n "tasks": {},\n "models": {},\n "attempts": [\n${LINES.map((line) => JSON.stringify(line)).join(",\n")}`;
  const progress = new Progress(false);
  const { attempts, unread } = atOnce(progressOfText(whole.slice(0, -20), () => DIGEST));
  atOnce(progress.merging(attempts));
  assert.deepEqual([progress.all.length, unread > 0], [2, true]);
});
