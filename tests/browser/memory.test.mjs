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
 * The rounds in which the worker's wasm has to stop growing. Its allocator fragments over the first turns, by another
 * amount in each run; a leak grows in every round.
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
  // Two rounds at least, so that the heap is compared too.
  while (seen.length <= 2 || worker().at(-1) !== worker().at(-2)) {
    assert.ok(seen.length <= ROUNDS, `the worker's wasm still grows, bytes: ${worker().join(", ")}`);
    await openPuzzles(page, 10, 10 * seen.length);
    await playTurns(page, 4);
    seen.push(await memoryOf(page));
  }
  const [earlier, later] = seen.slice(-2);
  assert.ok(later.heap - earlier.heap < NOISE, `the heap has grown from ${earlier.heap} to ${later.heap}`);
  assert.equal(later.pageWasm, seen[0].pageWasm);
  assert.ok(later.elements - seen[0].elements < 700, `from ${seen[0].elements} to ${later.elements} nodes`);
});
