// What the browser keeps: reading a document, merging it with another tab's, and storage that fails.

import assert from "node:assert/strict";
import { test } from "node:test";
import { NOTHING_KEPT, choose, keepPuzzles, merged, mergeKept } from "../../www/core/change/kept.ts";
import { setDevice } from "../../www/core/change/settings.ts";
import { attempts } from "../../www/core/derived/duel.ts";
import { theme } from "../../www/core/derived/preferences.ts";
import { Store } from "../../www/core/store.ts";
import { keepingEffect, keptFrom, readKept } from "../../www/effects/keeping.ts";
import { CUSTOM, MISSING, SOLVING, fresh, line, playAt } from "./player.ts";
import type { Kept } from "../../www/core/change/kept.ts";

const ballsOf = ({ attempts }: Kept) => (attempts.a ?? []).map(({ ball }) => String(ball));

const settled = () => new Promise((resolve) => setImmediate(resolve));

/** Runs with a storage of this many characters. */
async function withStorage(capacity: number, run: (items: Map<string, string>) => Promise<void>): Promise<void> {
  const items = new Map<string, string>();
  const storage = {
    getItem: (key: string) => items.get(key) ?? null,
    setItem(key: string, value: string) {
      if (value.length > capacity) throw new DOMException("full", "QuotaExceededError");
      items.set(key, value);
    },
  };
  Object.assign(globalThis, { localStorage: storage });
  try {
    await run(items);
  } finally {
    Reflect.deleteProperty(globalThis, "localStorage");
  }
}

test("what another tab has kept joins this one's, and its choices hold", () => {
  const here = playAt(fresh, MISSING);
  const theirs: Kept = { ...NOTHING_KEPT, language: "de", attempts: { [here.puzzle.key]: [line(SOLVING)] } };
  const joined = mergeKept(here, theirs);
  assert.deepEqual(
    attempts(joined).map(({ ball }) => ball),
    [SOLVING, MISSING],
  );
  assert.deepEqual([joined.kept.language, joined.run], ["de", null]);
});

test("of a custom puzzle what was done last counts, also that it was deleted", () => {
  const here = keepPuzzles(fresh, { a: CUSTOM, b: CUSTOM }, 1).kept;
  const there = keepPuzzles(keepPuzzles(fresh, { a: null }, 2), { b: null, c: CUSTOM }, 0).kept;
  for (const { puzzles } of [merged(here, there), merged(there, here)])
    assert.deepEqual([puzzles.a?.scene, puzzles.b?.scene, puzzles.c?.scene], [null, CUSTOM, CUSTOM]);
  assert.deepEqual(keptFrom({ ...here, puzzles: { ...here.puzzles, d: 7, e: { scene: {}, changed: 1 } } }), here);
});

test("only what is understood of this version's document is read", () => {
  assert.deepEqual(keptFrom(null), NOTHING_KEPT);
  assert.deepEqual(keptFrom({ version: 2, guess: false }), NOTHING_KEPT);
  assert.deepEqual(keptFrom({ version: 1, guess: false, theme: "pink", model: "none" }), {
    ...NOTHING_KEPT,
    guess: false,
  });
  const damaged = [
    line(MISSING),
    null,
    {},
    { ...line(SOLVING), ball: [1, 2] },
    { ...line(SOLVING), status: "invalid" },
  ];
  assert.deepEqual(ballsOf(keptFrom({ version: 1, attempts: { a: damaged, b: 7 } })), [String(MISSING)]);
});

test("what the page began with is not written again; a drop is, together with other tabs' attempts", async () => {
  await withStorage(1e6, async (items) => {
    const store = new Store(fresh, [keepingEffect()]);
    store.start(() => {});
    assert.equal(items.size, 0);
    items.set("pathlight", JSON.stringify({ ...NOTHING_KEPT, attempts: { [fresh.puzzle.key]: [line(SOLVING)] } }));
    store.change(playAt, MISSING);
    await settled();
    assert.deepEqual(
      readKept().attempts[fresh.puzzle.key]!.map(({ ball }) => ball),
      [SOLVING, MISSING],
    );
  });
});

test("a full storage is said, and the person plays on", async () => {
  await withStorage(10, async () => {
    const store = new Store(fresh, [keepingEffect()]);
    store.start(() => {});
    store.change(playAt, MISSING);
    await settled();
    assert.deepEqual([store.state.notice, attempts(store.state).length], [{ kind: "storage_full" }, 1]);
  });
});

test("a browser that refuses its storage holds nothing up; a theme that the page around asks for comes first", () => {
  assert.deepEqual(readKept(), NOTHING_KEPT);
  const chosen = choose(fresh, { theme: "dark" });
  assert.deepEqual([theme(chosen), theme(setDevice(chosen, { asked: "light" }))], ["dark", "light"]);
});
