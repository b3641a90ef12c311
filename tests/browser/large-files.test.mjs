// Large files: read in slices that yield, in linear time, up to a stated number; stopped without a trace; and what is
// here is never pushed out. The modules run in Node, without the wasm.

import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";
import { MOST_ATTEMPTS, Progress } from "../../www/storage/progress.js";
import { progressJson, progressOfText } from "../../www/storage/progress-file.js";
import { MOST_PUZZLES, PuzzleStore } from "../../www/storage/puzzle-store.js";
import { FileProblem, atOnce, inSlices } from "../../www/storage/sliced-work.js";

const TIMES = { steps: 300, longest_touch: 0, final_touch: 0 };

/** A storage like the browser's, with this much room in characters. */
function storage(room = Infinity) {
  const entries = {};
  const size = () => Object.values(entries).reduce((sum, text) => sum + text.length, 0);
  for (const [name, value] of Object.entries({
    getItem: (key) => entries[key] ?? null,
    removeItem: (key) => delete entries[key],
    setItem: (key, text) => {
      if (size() - (entries[key]?.length ?? 0) + text.length > room)
        throw new DOMException("Setting the value exceeded the quota.", "QuotaExceededError");
      entries[key] = text;
    },
  }))
    Object.defineProperty(entries, name, { value });
  return /** @type {any} */ (entries);
}
beforeEach(() => (globalThis.localStorage = storage()));

/** A clock that a millisecond passes on whenever it is looked at. */
function clock() {
  let time = 0;
  return () => (time += 1);
}

const taskOf = (number) =>
  `${String(Math.floor(number / 100)).padStart(5, "0")}:${String(number % 100).padStart(3, "0")}`;
const line = (puzzle, x, status = "not_solved", by = "player") => ({
  ...puzzle,
  by,
  ball: [x, 200, 8],
  status,
  ...TIMES,
});
/** The text of a file with attempts, at fifty for each task. */
const textOf = (count) =>
  Array.from({ length: count }, (_, index) => {
    const [task, x] = [taskOf(Math.floor(index / 50)), index % 50];
    return `${JSON.stringify(line({ task }, x, x === 49 ? "solved" : "not_solved"))}\n`;
  }).join("");
const read = (text) => atOnce(progressOfText(text, () => ""));

test("work is done in slices, between which it says how far it is", async () => {
  function* steps() {
    for (let step = 1; step <= 100; step += 1) yield step / 100;
    return "done";
  }
  /** @type {[number[], (number | undefined)[]]} */
  const [said, pauses] = [[], []];
  const pause = async () => void pauses.push(said.at(-1));
  const result = await inSlices(steps(), { now: clock(), pause, onProgress: (done) => said.push(done) });
  assert.equal(result, "done");
  // A slice is twelve milliseconds, and so are twelve steps.
  assert.ok(pauses.length >= 7 && pauses.length <= 9, `${pauses.length} pauses`);
  assert.deepEqual(pauses, said);
  assert.deepEqual(
    said,
    [...said].sort((a, b) => a - b),
  );
});

test("a file of attempts yields at each line, and merging at each puzzle", () => {
  const text = textOf(3000);
  assert.equal([...progressOfText(text, () => "")].length, 3000);
  const { attempts } = read(text);
  // A thousand at a time are sorted by puzzle, and each puzzle is merged at once.
  assert.equal([...new Progress(false).merging(attempts)].length, 3 + 60);
  // Each puzzle is merged once, also when its attempts are far apart in the file.
  const mixed = attempts.map((_, index) => attempts[(index * 50 + Math.floor(index / 60)) % 3000]);
  assert.equal([...new Progress(false).merging(mixed)].length, 3 + 60);
  // Of all custom scenes not more than a thousand at once.
  const custom = Array.from({ length: 2500 }, (_, index) =>
    JSON.stringify(line({ scene: (10_000 + index).toString(16).padStart(64, "0") }, 1)),
  );
  assert.equal([...new Progress(false).merging(read(custom.join("\n")).attempts)].length, 3 + 3);
});

test("a file with more attempts than are kept says so, and loses no solution", () => {
  const progress = new Progress(false);
  const merged = atOnce(progress.merging(read(textOf(MOST_ATTEMPTS + 5000)).attempts));
  assert.deepEqual([merged.added, merged.left, progress.all.length], [MOST_ATTEMPTS, 5000, MOST_ATTEMPTS]);
  const tasks = (MOST_ATTEMPTS + 5000) / 50;
  assert.deepEqual(progress.player.sum(progress.player.tasks), { tried: tasks, solved: tasks, attempts: tasks * 50 });
});

test("reading that is stopped changes nothing", async () => {
  const progress = new Progress(false);
  const ending = { solved: true, ...TIMES };
  progress.add(taskOf(1), "player", [{ ball: [200, 200, 8], ending }], { simulator: 3 });
  const before = progressJson(progress);
  const stop = new AbortController();
  let pauses = 0;
  const pause = async () => void ((pauses += 1) === 3 && stop.abort());
  const { attempts } = read(textOf(5000));
  await assert.rejects(inSlices(progress.merging(attempts), { signal: stop.signal, now: clock(), pause }), {
    name: "AbortError",
  });
  assert.equal(pauses, 3);
  assert.equal(progressJson(progress), before);
});

test("attempts at a thousand unknown custom scenes push none out, and go first when there is no room", () => {
  const progress = new Progress(false);
  const mine = "e".repeat(64);
  const ending = { solved: true, ...TIMES };
  progress.add(mine, "player", [{ ball: [1, 200, 8], ending }], { simulator: 3 });
  const unknown = Array.from({ length: 1000 }, (_, index) =>
    JSON.stringify(line({ scene: index.toString(16).padStart(64, "0") }, 1)),
  );
  const { added, left } = atOnce(progress.merging(read(unknown.join("\n")).attempts));
  assert.deepEqual([added, left], [999, 1]);
  for (let x = 2; x < 30; x += 1)
    progress.add("f".repeat(64), "player", [{ ball: [x, 200, 8], ending }], { simulator: 3 });
  assert.deepEqual([progress.attemptsAt(mine).length, progress.ofCustomScenes.length], [1, 1000]);
});

test("a full store keeps what it has, says how many attempts it does not keep, and is of use again when there is room", () => {
  globalThis.localStorage = storage(40_000);
  const progress = new Progress(true);
  atOnce(progress.merging(read(textOf(1000)).attempts));
  const { failure, attempts } = progress.unkept;
  assert.equal(failure, "full");
  assert.ok(attempts > 0 && attempts < 1000, `${attempts} are not kept`);
  assert.equal(progress.player.tasks.length, 20, "as long as the page is open, all is there");
  assert.equal(read(progressJson(progress)).attempts.length, 1000, "and the file has all");
  assert.equal(new Progress(true).all.length, 1000 - attempts);
  progress.clear();
  assert.deepEqual(progress.unkept, { failure: null, attempts: 0 });
});

test("lines that are none are counted, and a deep or long one is none", () => {
  const deep = `${"[".repeat(1e6)}${"]".repeat(1e6)}`;
  for (const text of [
    "{}\n".repeat(20_000),
    deep,
    `{"attempts": ${deep}}`,
    "x".repeat(2e7),
    `[${"{},".repeat(1e6)}{}]`,
  ])
    assert.throws(() => read(text), FileProblem);
  const { attempts, unread } = read(`${"{}\n".repeat(20_000)}${JSON.stringify(line({ task: taskOf(1) }, 1))}\n${deep}`);
  assert.deepEqual([attempts.length, unread], [1, 20_001]);
});

test("equal puzzles are kept once, and not too many", () => {
  const puzzles = new PuzzleStore();
  const scene = (name) => ({ version: /** @type {const} */ (1), name, body1: 0, body2: 1, bodies: [] });
  assert.deepEqual(puzzles.add([scene("a"), scene("a"), scene("a")]), { added: 1, left: 0, failure: null });
  const many = Array.from({ length: MOST_PUZZLES + 10 }, (_, index) => scene(`puzzle ${index}`));
  assert.deepEqual(puzzles.add(many), { added: MOST_PUZZLES - 1, left: 11, failure: null });
  assert.match(puzzles.add([scene("one more")]).failure ?? "", /keeps 500 puzzles/);
  puzzles.remove(scene("a"));
  assert.equal(puzzles.scenes.length, MOST_PUZZLES - 1);
  assert.deepEqual(new PuzzleStore().scenes, puzzles.scenes);
});
