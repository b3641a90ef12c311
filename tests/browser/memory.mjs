// Measures whether the page holds on to memory: opens many puzzles in a row, and lets the model play many turns. Of the
// page and of its worker: the heap of JavaScript after a forced collection, and the memory of the wasm.
//
//     node tests/browser/memory.mjs [puzzles] [turns]

import { pathToFileURL } from "node:url";
import { start } from "./harness.mjs";
import { inMore, openImagined } from "./page-actions.mjs";

/** @typedef {import('playwright-core').Page} Page */
/**
 * @typedef {{ heap: number, pageWasm: number, workerWasm: number, elements: number }} Memory bytes, and the elements of
 *   the page
 */

/**
 * Opens a number of puzzles of the page, which imagines each.
 * @param {Page} page
 * @param {number} count
 * @param {number} [from]
 */
export async function openPuzzles(page, count, from = 0) {
  const templates = await page.evaluate(async () =>
    (await import("/pkg/pathlight.js")).templates().map(({ tasks }) => tasks),
  );
  for (let index = from; index < from + count; index++) {
    const tasks = templates[index % templates.length];
    const task = tasks[Math.floor(index / templates.length) % tasks.length];
    await page.evaluate((task) => void (location.hash = `#task=${task}&panel=imagine`), task);
    await page
      .locator("#imagined-in")
      .filter({ hasText: /Imagined in [\d,]+ ms/ })
      .waitFor();
  }
}

/**
 * Lets the model play a number of turns, each on a puzzle that is opened anew.
 * @param {Page} page
 * @param {number} count
 */
export async function playTurns(page, count) {
  for (let index = 0; index < count; index++) {
    await page.evaluate(
      (task) => void (location.hash = `#task=${task}&panel=compare`),
      index % 2 ? "00000:000" : "00002:007",
    );
    if (await page.locator("#clear-attempts").isEnabled())
      await inMore(page, () => page.locator("#clear-attempts").click());
    await page.locator("#model-turn:enabled").click();
    await page.locator("#model-turn").filter({ hasText: "The model has played" }).waitFor({ timeout: 120_000 });
  }
}

/**
 * What the page and its worker hold.
 * @param {Page} page
 * @returns {Promise<Memory>}
 */
export async function memoryOf(page) {
  const session = await page.context().newCDPSession(page);
  await session.send("HeapProfiler.enable");
  for (let round = 0; round < 3; round++) await session.send("HeapProfiler.collectGarbage");
  const { usedSize } = await session.send("Runtime.getHeapUsage");
  const { nodes } = await session.send("Memory.getDOMCounters");
  await session.detach();
  const pageWasm = await page.evaluate(wasmBytes);
  const workerWasm = await page.workers()[0].evaluate(wasmBytes);
  return { heap: usedSize, pageWasm, workerWasm, elements: nodes };
}

/** The bytes of the wasm's memory, which only grows. */
async function wasmBytes() {
  const { default: init } = await import("/pkg/pathlight.js");
  return (await init()).memory.buffer.byteLength;
}

/** @param {Memory} memory */
function words({ heap, pageWasm, workerWasm, elements }) {
  const mib = (bytes) => (bytes / 2 ** 20).toFixed(2).padStart(7);
  return `heap ${mib(heap)} MiB, wasm of the page ${mib(pageWasm)} MiB, of the worker ${mib(workerWasm)} MiB, ${elements} nodes`;
}

async function measure(puzzles, turns) {
  const session = await start({ sources: true });
  const page = await openImagined(session, { reducedMotion: true });
  // What is kept once, for all puzzles, is there after the first of every template.
  await openPuzzles(page, 25);
  console.log(`after   25 puzzles: ${words(await memoryOf(page))}`);
  for (let opened = 25; opened < puzzles;) {
    const count = Math.min(195, puzzles - opened);
    await openPuzzles(page, count, opened);
    opened += count;
    console.log(`after ${String(opened).padStart(4)} puzzles: ${words(await memoryOf(page))}`);
  }
  for (let played = 0; played < turns;) {
    const count = played === 0 ? Math.min(4, turns) : Math.min(24, turns - played);
    await playTurns(page, count);
    played += count;
    console.log(`after ${String(played).padStart(4)} turns:   ${words(await memoryOf(page))}`);
  }
  await session.stop();
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href)
  await measure(Number(process.argv[2] ?? 1000), Number(process.argv[3] ?? 100));
