// The store: effects run by what they depend on, once at a time, and then for the newest needs.

import assert from "node:assert/strict";
import { test } from "node:test";
import { Store } from "../../www/core/store.ts";
import type { Effect } from "../../www/core/store.ts";

interface Numbers {
  readonly asked: number | null;
  readonly other: number;
}

const START: Numbers = { asked: 1, other: 0 };
const ask = (state: Numbers, asked: number | null) => ({ ...state, asked });

/** An effect that ends when it is told to. */
function slow() {
  const runs: { asked: number | null; signal: AbortSignal; end(): void }[] = [];
  const effect: Effect<Numbers> = {
    needs: ({ asked }) => (asked === null ? null : [asked]),
    run: ({ state }, signal) => new Promise((end) => runs.push({ asked: state.asked, signal, end })),
  };
  return { runs, effect };
}

const settled = () => new Promise((resolve) => setImmediate(resolve));

test("an effect runs again only when its needs change, and then for the newest", async () => {
  const { runs, effect } = slow();
  const store = new Store(START, [effect]);
  store.start(() => {});
  store.change((state) => ({ ...state, other: 1 }));
  assert.equal(runs.length, 1);
  for (const asked of [2, 3, 4]) store.change(ask, asked);
  assert.deepEqual([runs.length, runs[0]!.signal.aborted], [1, true]);
  runs[0]!.end();
  await settled();
  assert.deepEqual(
    runs.map(({ asked }) => asked),
    [1, 4],
  );
  assert.equal(runs[1]!.signal.aborted, false);
});

test("an effect whose needs are gone is aborted and does not run again", async () => {
  const { runs, effect } = slow();
  const store = new Store(START, [effect]);
  store.start(() => {});
  store.change(ask, null);
  runs[0]!.end();
  await settled();
  assert.deepEqual([runs.length, runs[0]!.signal.aborted], [1, true]);
  store.change(ask, 1);
  assert.equal(runs.length, 2);
});

test("a change that changes nothing calls nobody, and a stopped store changes no more", () => {
  const { runs, effect } = slow();
  let calls = 0;
  const store = new Store(START, [effect]);
  store.start(() => (calls += 1));
  store.change((state) => state);
  assert.equal(calls, 1);
  store.stop();
  store.change(ask, 9);
  assert.deepEqual([calls, store.state.asked, runs[0]!.signal.aborted], [1, 1, true]);
});
