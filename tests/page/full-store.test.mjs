// A store that is full: what it refuses is written once there is room, and takes away nothing that another tab has
// written meanwhile.

import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";
import { BrowserStore } from "../../www/storage/browser-store.js";
import { Counts, StoredCounts } from "../../www/storage/counts.js";
import { Preferences } from "../../www/storage/preferences.js";
import { Progress } from "../../www/storage/progress.js";

const [TASK, OTHER] = ["00007:008", "00011:004"];
const SIMULATOR = { simulator: 3 };

/** How many more characters the store takes. */
let room = Infinity;
const entries = /** @type {Record<string, string>} */ ({});
const count = (/** @type {string | undefined} */ text) => text?.length ?? 0;
for (const [name, value] of Object.entries({
  getItem: (key) => entries[key] ?? null,
  removeItem(key) {
    room += count(entries[key]);
    delete entries[key];
  },
  setItem(key, text) {
    const more = count(text) - count(entries[key]);
    if (more > room) throw new DOMException("full", "QuotaExceededError");
    room -= more;
    entries[key] = text;
  },
}))
  Object.defineProperty(entries, name, { value });
Object.assign(globalThis, { localStorage: entries });

beforeEach(() => {
  room = Infinity;
  for (const key of Object.keys(entries)) delete entries[key];
});

/** The player drops balls, of which the last one may solve. */
function play(progress, task, balls, solved = false) {
  const attempts = balls.map((x, index) => ({
    ball: [x, 200, 8],
    ending: { solved: solved && index === balls.length - 1, steps: 300, longest_touch: 0, final_touch: 0 },
  }));
  progress.add(task, "player", attempts, SIMULATOR);
}
const stored = () => new Progress(true);

test("attempts that are cleared still count, as they make the room for that", () => {
  const progress = stored();
  play(progress, TASK, [1, 2, 3], true);
  room = 0;
  progress.forget(TASK);
  assert.deepEqual(progress.unkept, { failure: null, attempts: 0 });
  assert.deepEqual(stored().player.of(TASK), { attempts: 3, solved: 3 });
  assert.deepEqual(stored().all, []);
});

test("attempts that were refused are kept once there is room, the counts before them", () => {
  const progress = stored();
  play(progress, TASK, [1, 2, 3], true);
  room = 0;
  play(progress, OTHER, [1, 2, 3, 4, 5]);
  assert.deepEqual(progress.unkept, { failure: "full", attempts: 5 });
  progress.forget(TASK);
  assert.deepEqual(progress.unkept, { failure: "full", attempts: 5 }, "these need more");
  assert.deepEqual(stored().player.of(TASK), { attempts: 3, solved: 3 });
  room = 1000;
  progress.memory.add("within-0", { key: TASK, name: null }, '{"puzzles":[{"attempts":[]}]}');
  assert.deepEqual(progress.unkept, { failure: null, attempts: 0 });
  assert.deepEqual(stored().player.of(OTHER), { attempts: 5, solved: null });
});

test("counts that were refused are added to what another tab has counted meanwhile", () => {
  const countsOf = (task, solved) => {
    const counts = new Counts();
    counts.set("player", task, { attempts: 4, solved });
    return counts;
  };
  const [first, second] = [new StoredCounts(new BrowserStore(true)), new StoredCounts(new BrowserStore(true))];
  room = 0;
  first.add(countsOf(TASK, null));
  room = Infinity;
  second.add(countsOf(OTHER, 2));
  first.refresh();
  const all = { player: { [OTHER]: { attempts: 4, solved: 2 }, [TASK]: { attempts: 4, solved: null } } };
  assert.deepEqual(JSON.parse(entries["pathlight.counts"]), all);
});

test("what another tab has forgotten does not come back with counts that were refused", () => {
  const first = new StoredCounts(new BrowserStore(true));
  const counted = (task) => {
    const counts = new Counts();
    counts.set("player", task, { attempts: 4, solved: 2 });
    return counts;
  };
  first.add(counted(TASK));
  room = 0;
  first.add(counted(OTHER));
  new StoredCounts(new BrowserStore(true)).clear();
  room = Infinity;
  first.refresh(true);
  assert.deepEqual(first.all, []);
  assert.equal(entries["pathlight.counts"], undefined);
});

test("a memory that was refused does not take the place of what another tab has remembered meanwhile", () => {
  const [first, second] = [stored(), stored()];
  const remember = (progress, key) =>
    progress.memory.add("within-0", { key, name: null }, '{"puzzles":[{"attempts":[]}]}');
  room = 0;
  remember(first, TASK);
  room = Infinity;
  remember(second, OTHER);
  first.memory.refresh("memory.within-0");
  play(first, TASK, [1]);
  assert.deepEqual(
    stored()
      .memory.puzzles("within-0")
      .map(({ key }) => key),
    [OTHER],
  );
  assert.equal(first.unkept.failure, null);
});

test("where nothing is kept the guess stays switched as the person wants it", () => {
  const preferences = new Preferences(false);
  assert.equal(preferences.guess, false);
  for (const on of [true, false]) {
    preferences.guess = on;
    assert.equal(preferences.guess, on);
  }
  assert.equal(new Preferences(true).guess, true, "to newcomers it is shown");
});
