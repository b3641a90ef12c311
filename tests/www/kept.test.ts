// What the browser keeps: reading a document, two histories that merge, and storage that fails.

import assert from "node:assert/strict";
import { test } from "node:test";
import { NOTHING_KEPT, choose, keepPuzzles, merged, mergeKept } from "../../www/core/change/kept.ts";
import { attempts } from "../../www/core/derived/duel.ts";
import { Store } from "../../www/core/store.ts";
import { keepingEffect, keptFrom, readKept } from "../../www/effects/keeping.ts";
import { ATTEMPT_LIMIT } from "../../www/pkg/constants.ts";
import { CUSTOM, MISSING, SOLVING, fresh, line, playAt } from "./player.ts";
import type { Kept } from "../../www/core/change/kept.ts";
import type { Ball } from "../../www/pkg/page/pathlight.js";

const kept = (...balls: Ball[]): Kept => ({ ...NOTHING_KEPT, attempts: { a: balls.map((ball) => line(ball)) } });
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

test("two histories merge without losing an attempt or a solution", () => {
  const random = generator(7);
  for (let round = 0; round < 300; round++) {
    const [one, other] = [history(random), history(random)];
    const both = ballsOf(merged(one, other));
    const all = new Set([...ballsOf(one), ...ballsOf(other)]);
    assert.equal(new Set(both).size, both.length);
    assert.ok(both.length === Math.min(all.size, ATTEMPT_LIMIT));
    const solutions = [...all].filter((ball) => Number(ball.split(",")[0]) > 200);
    if (solutions.length <= ATTEMPT_LIMIT) for (const ball of solutions) assert.ok(both.includes(ball), ball);
  }
});

test("merging again changes nothing", () => {
  const one = kept(MISSING, SOLVING);
  assert.deepEqual(merged(merged(one, kept([1, 2, 3])), one), merged(one, kept([1, 2, 3])));
});

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
  assert.deepEqual(keptFrom({ version: 1, guess: false, theme: "pink" }), { ...NOTHING_KEPT, guess: false });
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

test("a browser that refuses its storage holds nothing up", () => {
  assert.deepEqual(readKept(), NOTHING_KEPT);
  assert.equal(choose(fresh, { theme: "dark" }).kept.theme, "dark");
});

function history(random: () => number): Kept {
  const count = Math.floor(random() * 90);
  const balls = Array.from({ length: count }, (): Ball => [Math.floor(random() * 256), Math.floor(random() * 3), 5]);
  return kept(...new Map(balls.map((ball) => [String(ball), ball])).values());
}

/** Numbers in 0..1 that are the same each time. */
function generator(seed: number): () => number {
  let state = seed;
  return () => (state = (state * 16807) % 2147483647) / 2147483647;
}
