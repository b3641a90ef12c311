// Puzzles that are opened and turns that are played leave nothing behind: the heap, the wasm of page and worker and the
// elements stay as they are. memory.mjs measures a thousand puzzles and a hundred turns.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { memoryOf, openPuzzles, playTurns } from "./memory.mjs";
import { openImagined } from "./page-actions.mjs";

/** The noise of the heap's size over two rounds, bytes. */
const NOISE = 300_000;
/**
 * The rounds in which heap and wasm have to stop growing. Caches fill and the allocator fragments over the first turns,
 * by another amount in each run; a leak never stops.
 */
const ROUNDS = 8;

let session;
before(async () => (session = await start({ sources: true })));
after(() => session.stop());

test("rounds of ten puzzles and four turns", async () => {
  const page = await openImagined(session, { reducedMotion: true });
  await openPuzzles(page, 25);
  await playTurns(page, 2);
  const seen = [await memoryOf(page)];
  /** Have two rounds added nothing? */
  const isSteady = () => {
    const [earlier, between, later] = seen.slice(-3);
    const sizes = new Set([earlier, between, later].map((memory) => memory?.workerWasm));
    return seen.length >= 3 && sizes.size === 1 && later.heap - earlier.heap < NOISE;
  };
  while (!isSteady()) {
    const grown = seen.map(({ heap, workerWasm }) => `${heap} + ${workerWasm}`);
    assert.ok(seen.length <= ROUNDS, `heap and wasm of the worker still grow, bytes: ${grown.join(", ")}`);
    await openPuzzles(page, 10, 10 * seen.length);
    await playTurns(page, 4);
    seen.push(await memoryOf(page));
  }
  const later = seen[seen.length - 1];
  assert.equal(later.pageWasm, seen[0].pageWasm);
  assert.ok(later.elements - seen[0].elements < 700, `from ${seen[0].elements} to ${later.elements} nodes`);
});
