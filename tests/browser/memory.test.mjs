// Puzzles that are opened and turns that are played leave nothing behind: the heap, the wasm of page and worker and the
// elements stay as they are. memory.mjs measures a thousand puzzles and a hundred turns.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { memoryOf, openPuzzles, playTurns } from "./memory.mjs";
import { openImagined } from "./page-actions.mjs";

/** The noise of the heap's size, bytes. */
const NOISE = 400_000;
/**
 * How much the wasm of the worker grows over its first turns, because its allocator fragments, bytes. After some thirty
 * turns it grows no more.
 */
const FRAGMENTS = 1_000_000;

let session;
before(async () => (session = await start({ sources: true })));
after(() => session.stop());

test("fifty puzzles and ten turns", async () => {
  const page = await openImagined(session, { reducedMotion: true });
  await openPuzzles(page, 25);
  await playTurns(page, 2);
  const before = await memoryOf(page);
  await openPuzzles(page, 25);
  await playTurns(page, 8);
  const later = await memoryOf(page);
  assert.ok(later.heap - before.heap < NOISE, `the heap has grown from ${before.heap} to ${later.heap}`);
  assert.equal(later.pageWasm, before.pageWasm);
  const grown = later.workerWasm - before.workerWasm;
  assert.ok(grown <= FRAGMENTS, `the worker's wasm has grown by ${grown} bytes`);
  assert.ok(later.elements - before.elements < 300, `from ${before.elements} to ${later.elements} nodes`);
});
