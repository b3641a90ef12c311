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
 * The rounds in which the worker's wasm has to stop growing. Its allocator fragments over the first turns, by another
 * amount in each run; a leak of more than a page of wasm a round never stops.
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
  const worker = () => seen.map(({ workerWasm }) => workerWasm);
  // It has stopped when two rounds have added nothing.
  while (seen.length < 3 || new Set(worker().slice(-3)).size > 1) {
    assert.ok(seen.length <= ROUNDS, `the worker's wasm still grows, bytes: ${worker().join(", ")}`);
    await openPuzzles(page, 10, 10 * seen.length);
    await playTurns(page, 4);
    seen.push(await memoryOf(page));
  }
  const [earlier, , later] = seen.slice(-3);
  assert.ok(later.heap - earlier.heap < NOISE, `the heap has grown from ${earlier.heap} to ${later.heap}`);
  assert.equal(later.pageWasm, seen[0].pageWasm);
  assert.ok(later.elements - seen[0].elements < 700, `from ${seen[0].elements} to ${later.elements} nodes`);
});
