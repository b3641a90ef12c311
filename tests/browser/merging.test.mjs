// What devices remember is merged without loss: any histories, in any order. The modules run in Node, without the wasm;
// PATHLIGHT_MERGES sets how many histories are tried.

import assert from "node:assert/strict";
import { test } from "node:test";
import fc from "fast-check";
import { Progress } from "../../www/storage/progress.js";
import { progressJson, progressOfText } from "../../www/storage/progress-file.js";
import { atOnce } from "../../www/storage/sliced-work.js";

const RUNS = { numRuns: Number(process.env.PATHLIGHT_MERGES ?? 500) };
const TASK = "00002:007";
const PUZZLES = [TASK, "00000:001", "a".repeat(64), "b".repeat(64)];
const AUTHORS = ["player", "__proto__", `${"long".repeat(20)}.name`];
const VERSIONS = [
  { simulator: 3, agents: 2 },
  { simulator: 3, agents: 4 },
];

const digestOf = (scene) => scene.digest;
const read = (text) => atOnce(progressOfText(text, digestOf));
const ending = (solved) => ({ solved, steps: 300, longest_touch: solved ? 180 : 0, final_touch: 0 });
/** @returns {import("../../www/pkg/pathlight.js").Ball} */
const ballAt = (x) => [x, 200, 8];

/** Merges what a file holds; one without anything is refused. */
function readBack(progress, text) {
  if (/"tasks": \{\},\s*"models": \{\},\s*"attempts": \[\s*\]/.test(text))
    return { added: 0, solved: 0, left: 0, undo() {} };
  const { attempts, counts, unread } = read(text);
  return { ...atOnce(progress.merging(attempts, counts)), unread };
}

/** The progress of a device on which these things were done. */
function played(actions) {
  const progress = new Progress(false);
  for (const { act, puzzle, by, versions, x, solved } of actions) {
    if (act === "attempt") {
      const { simulator, agents } = versions;
      const made = [{ ball: ballAt(x), ending: ending(solved) }];
      progress.add(puzzle, by, made, by === "player" ? { simulator } : { simulator, agents });
    } else if (act === "remove") progress.remove(puzzle, by, [String(ballAt(x))]);
    else progress.forget(puzzle);
  }
  return progress;
}

const history = fc.array(
  fc.record({
    act: fc.constantFrom("attempt", "attempt", "attempt", "attempt", "remove", "forget"),
    puzzle: fc.constantFrom(...PUZZLES),
    by: fc.constantFrom(...AUTHORS),
    versions: fc.constantFrom(...VERSIONS),
    x: fc.integer({ min: 1, max: 9 }),
    solved: fc.boolean(),
  }),
  { maxLength: 25 },
);

/** A device that has read files one after the other. */
function merged(...texts) {
  const progress = new Progress(false);
  for (const text of texts) readBack(progress, text);
  return progress;
}

/** All that a device remembers, in the order in which it shows it. */
function memoryOf(progress) {
  const { tasks, models } = JSON.parse(progressJson(progress));
  return { tasks, models, attempts: PUZZLES.map((puzzle) => progress.attemptsAt(puzzle)) };
}

const turn = ({ puzzle, by, simulator, agents }) => (by === "player" ? [puzzle, by] : [puzzle, by, simulator, agents]);
const identities = (progress) => progress.all.map((one) => String([turn(one), one.ball]));

/** Asserts that everything that one device remembers, the other remembers too. */
function assertHolds(all, part) {
  const kept = new Set(identities(all));
  for (const identity of identities(part)) assert.ok(kept.has(identity), `${identity} is lost`);
  for (const attempt of part.all.filter((one) => one.ending.solved)) {
    const there = all.all.find((one) => String([turn(one), one.ball]) === String([turn(attempt), attempt.ball]));
    assert.ok(there?.ending.solved, "a solution is lost");
  }
  for (const task of part.player.tasks) {
    const [before, after] = [part.player.of(task), all.player.of(task)];
    assert.ok(after.attempts >= before.attempts, `${task}: ${after.attempts} < ${before.attempts} attempts`);
    if (before.solved !== null)
      assert.ok(after.solved !== null && after.solved <= before.solved, `${task} is unsolved`);
  }
}

test("histories merged in any order are the same, and lose no attempt and no solution", () => {
  fc.assert(
    fc.property(history, history, history, (...histories) => {
      const [a, b, c] = histories.map(played);
      const [inA, inB, inC] = [a, b, c].map(progressJson);
      const all = merged(inA, inB, inC);
      assert.deepEqual(memoryOf(merged(inC, inB, inA)), memoryOf(all));
      assert.deepEqual(memoryOf(merged(inB, progressJson(merged(inC, inA)))), memoryOf(all));
      for (const part of [a, b, c]) assertHolds(all, part);
    }),
    RUNS,
  );
});

test("an old solution that is only counted is saved too", () => {
  const [model, older, newer] = ["model", VERSIONS[0], VERSIONS[1]];
  const attempt = (x, solved, versions) => ({ act: "attempt", puzzle: TASK, by: model, versions, x, solved });
  const forgotten = played([attempt(1, true, older), { act: "forget", puzzle: TASK }]);
  const solvedLater = played([attempt(1, false, older), attempt(2, true, older)]);
  const together = merged(progressJson(forgotten), progressJson(solvedLater));
  assert.equal(together.ofModel(model).of(TASK).solved, 2, "the kept turn counts");
  const file = progressJson(together);
  const device = played([attempt(1, false, newer)]);
  readBack(device, file);
  assert.equal(device.ofModel(model).of(TASK).solved, 1, "the newer turn has not ended, so all that is known counts");
});

test("a file that is read twice, or by the device that saved it, changes nothing", () => {
  fc.assert(
    fc.property(history, history, (...histories) => {
      const [a, b] = histories.map(played);
      const before = memoryOf(a);
      const own = readBack(a, progressJson(a));
      assert.deepEqual([memoryOf(a), own.added, own.solved, own.left], [before, 0, 0, 0]);
      const file = progressJson(b);
      readBack(a, file);
      const once = memoryOf(a);
      assert.equal(readBack(a, file).added, 0);
      assert.deepEqual(memoryOf(a), once);
    }),
    RUNS,
  );
});

test("reading is undone, and what was played since stays", () => {
  fc.assert(
    fc.property(history, history, fc.boolean(), (historyA, historyB, playsOn) => {
      const [a, b] = [historyA, historyB].map(played);
      const before = memoryOf(a);
      const { undo } = readBack(a, progressJson(b));
      if (playsOn) a.add(TASK, "player", [{ ball: ballAt(77), ending: ending(true) }], { simulator: 3 });
      undo();
      if (!playsOn) assert.deepEqual(memoryOf(a), before);
      else assert.ok(a.attemptsAt(TASK).some(({ ball, by }) => by === "player" && ball[0] === 77));
      const kept = a.attemptsAt(TASK).filter(({ ball }) => ball[0] !== 77);
      assert.deepEqual(kept, before.attempts[0]);
    }),
    RUNS,
  );
});

test("a puzzle that was solved at once stays so when another device’s misses are read", () => {
  const attempt = (x, solved) => ({ act: "attempt", puzzle: TASK, by: "player", versions: VERSIONS[0], x, solved });
  const a = played([attempt(1, true)]);
  const b = played([attempt(2, false), attempt(3, false)]);
  const { puzzles, attempts, added, solved } = readBack(a, progressJson(b));
  assert.deepEqual({ puzzles, attempts, added, solved }, { puzzles: 1, attempts: 2, added: 2, solved: 0 });
  assert.deepEqual(a.player.of(TASK), { attempts: 3, solved: 1 });
  assert.deepEqual(
    a.attemptsAt(TASK).map(({ ending }) => ending.solved),
    [true, false, false],
  );
  const fromA = readBack(b, progressJson(played([attempt(1, true)])));
  assert.deepEqual([fromA.added, fromA.solved, b.player.of(TASK).solved], [1, 1, 1]);
});

test("attempts that are deleted still count", () => {
  const attempt = (x, solved) => ({ act: "attempt", puzzle: TASK, by: "player", versions: VERSIONS[0], x, solved });
  const progress = played([attempt(1, false), attempt(2, true), { act: "forget", puzzle: TASK }, attempt(3, true)]);
  assert.deepEqual(progress.player.of(TASK), { attempts: 3, solved: 2 });
});

test("a model’s turn by newer agents counts once it has ended", () => {
  const by = "within-0";
  const attempt = (x, solved, versions) => ({ act: "attempt", puzzle: TASK, by, versions, x, solved });
  const old = [attempt(1, false, VERSIONS[0]), attempt(2, true, VERSIONS[0])];
  const begun = played([...old, attempt(5, false, VERSIONS[1])]);
  assert.deepEqual(begun.ofModel(by).of(TASK), { attempts: 2, solved: 2 });
  const misses = [5, 6, 7].map((x) => attempt(x, false, VERSIONS[1]));
  const ended = played([...old, ...misses, attempt(8, true, VERSIONS[1])]);
  assert.deepEqual(ended.ofModel(by).of(TASK), { attempts: 4, solved: 4 });
});
