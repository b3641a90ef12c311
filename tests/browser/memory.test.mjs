// Opened puzzles, played duels and removed elements leave nothing behind: heap, objects, wasm and nodes stay as they
// are. memory.mjs measures a thousand puzzles and a hundred duels.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { memoryOf, objectsOf, openMeasured, openPuzzles, playDuels } from "./memory.mjs";
import { EASY, modelIsThere, startPlayer } from "./player.mjs";

let session;
before(async () => (session = await startPlayer()));
after(() => session.stop());

/** The noise of the heap's size over two rounds, bytes. */
const NOISE = 300_000;
/**
 * The rounds in which heap and wasm have to stop growing. Caches fill and the allocator fragments over the first ones,
 * by another amount in each run; a leak never stops.
 */
const ROUNDS = 8;

test("rounds of ten puzzles and four duels", async () => {
  const page = await openMeasured(session, `#task=${EASY}`);
  await modelIsThere(page);
  await openPuzzles(page, 25);
  const seen = [];
  /** Have two rounds added nothing? */
  const isSteady = () => {
    const [earlier, between, later] = seen.slice(-3);
    const isEven = (part) => earlier[part] === between[part] && between[part] === later[part];
    return seen.length >= 3 && isEven("pageWasm") && isEven("workerWasm") && later.heap - earlier.heap < NOISE;
  };
  for (let round = 0; !isSteady(); round++) {
    assert.ok(round < ROUNDS, `it still grows: ${JSON.stringify(seen)}`);
    await openPuzzles(page, 10, 10 * round);
    await playDuels(page, 4, 4 * round);
    seen.push(await memoryOf(page));
  }
  assert.ok(seen.at(-1).nodes - seen[0].nodes < 100, JSON.stringify(seen));
});

test("elements that are removed leave no object behind", async () => {
  const page = await openMeasured(
    session,
    "article",
    '<!doctype html><script type="module" src="element.js"></script>',
  );
  const rounds = async (count) => {
    for (let round = 0; round < count; round++) {
      await page.evaluate((task) => {
        document.body.append(Object.assign(document.createElement("pathlight-puzzle"), { task }));
      }, EASY);
      await modelIsThere(page);
      await page.evaluate(() => document.querySelector("pathlight-puzzle")?.remove());
    }
    return objectsOf(page);
  };
  const before = await rounds(3);
  const after = await rounds(10);
  // An element has hundreds of objects.
  assert.ok(after - before < 100, `${before} objects, then ${after}`);
});
