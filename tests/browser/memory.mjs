// Measures whether the page holds on to memory: opens many puzzles, plays many duels, and puts ten elements into a
// page.
//
//     node tests/browser/memory.mjs [PUZZLES] [DUELS]

import { pathToFileURL } from "node:url";
import { EASY, drop, known, loadSimulator, modelIsThere, place, startPlayer } from "./player.mjs";
import { templates } from "../../www/pkg/page/pathlight.js";

/** @typedef {import("playwright-core").Page} Page */
/**
 * Of the page: the heap of JavaScript, bytes, and its nodes; of page and worker: the wasm's memory, bytes.
 * @typedef {{ heap: number, nodes: number, pageWasm: number, workerWasm: number }} Memory
 */

const DUELS = [EASY, "00002:017"];

/** Opens a page whose memory can be measured: that of the player, or one of this markup. */
export async function openMeasured(session, path, body = "") {
  const page = await session.open("", { reducedMotion: "reduce" });
  await page.addInitScript(watchWasm);
  await page.route("**/worker.js", async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, body: `(${watchWasm})();\n${await response.text()}` });
  });
  if (body) await page.route("**/article", (route) => route.fulfill({ contentType: "text/html", body }));
  await page.goto(`${session.origin}/${path}`);
  return page;
}

/** In a page or a worker: keeps hold of the memory of the wasm that it starts. */
function watchWasm() {
  for (const name of /** @type {const} */ (["instantiate", "instantiateStreaming"])) {
    const start = /** @type {(...args: any[]) => Promise<any>} */ (WebAssembly[name]);
    Object.assign(WebAssembly, {
      [name]: async (...args) => {
        const started = await start(...args);
        Object.assign(globalThis, { wasmMemory: (started.instance ?? started).exports.memory });
        return started;
      },
    });
  }
}

const wasmBytes = () => /** @type {any} */ (globalThis).wasmMemory.buffer.byteLength;

/** Collects a page's garbage, and returns the session of the debugger that did. */
async function collected(page) {
  const session = await page.context().newCDPSession(page);
  await session.send("HeapProfiler.enable");
  // One collection may keep what was in use a moment before.
  for (let round = 0; round < 3; round++) await session.send("HeapProfiler.collectGarbage");
  return session;
}

/**
 * @param {Page} page
 * @returns {Promise<Memory>} after a collection
 */
export async function memoryOf(page) {
  const session = await collected(page);
  const { usedSize } = await session.send("Runtime.getHeapUsage");
  const { nodes } = await session.send("Memory.getDOMCounters");
  await session.detach();
  const [worker] = page.workers();
  return {
    heap: usedSize,
    nodes,
    pageWasm: await page.evaluate(wasmBytes),
    workerWasm: await worker.evaluate(wasmBytes),
  };
}

/** Returns the number of objects of a page, after a collection. */
export async function objectsOf(page) {
  const session = await collected(page);
  const { result } = await session.send("Runtime.evaluate", { expression: "Object.prototype" });
  const { objects } = await session.send("Runtime.queryObjects", { prototypeObjectId: result.objectId });
  const functionDeclaration = "function () { return this.length; }";
  const count = await session.send("Runtime.callFunctionOn", { functionDeclaration, objectId: objects.objectId });
  await session.detach();
  return count.result.value;
}

/** Opens some puzzles of all kinds, from the one at a place on, and waits until each is imagined. */
export async function openPuzzles(page, count, from = 0) {
  await loadSimulator();
  const kinds = templates();
  for (let index = from; index < from + count; index++) {
    const { tasks } = kinds[index % kinds.length];
    await goTo(page, tasks[Math.floor(index / kinds.length) % tasks.length], "&panel=imagine");
    await page.getByRole("group", { name: "Maps over the scene" }).waitFor();
  }
}

/** Plays some duels, from the one with a number on, each on a puzzle that is opened anew. */
export async function playDuels(page, count, from = 0) {
  for (let index = from; index < from + count; index++) {
    const task = DUELS[index % DUELS.length];
    const { missing } = await known(task);
    await goTo(page, task);
    await modelIsThere(page);
    await place(page, missing[index % missing.length], task);
    await drop(page);
  }
}

async function goTo(page, task, rest = "") {
  await page.evaluate((hash) => (location.hash = hash), `#task=${task}${rest}`);
  await page.waitForFunction(
    (task) => document.querySelector("input.number")?.["value"] === task && !document.querySelector(".verdict"),
    task,
  );
}

/** @param {Memory} memory */
function words({ heap, nodes, pageWasm, workerWasm }) {
  const mib = (bytes) => (bytes / 2 ** 20).toFixed(2).padStart(6);
  return `heap ${mib(heap)} MiB, wasm of the page ${mib(pageWasm)} MiB, of the worker ${mib(workerWasm)} MiB, ${nodes} nodes`;
}

async function measure(puzzles, duels) {
  const session = await startPlayer();
  const page = await openMeasured(session, `#task=${EASY}`);
  await modelIsThere(page);
  const print = async (what, page) => console.log(`${what.padEnd(18)} ${words(await memoryOf(page))}`);
  await print("at the start", page);
  for (let opened = 0; opened < puzzles; opened += 100) {
    const count = Math.min(100, puzzles - opened);
    await openPuzzles(page, count, opened);
    await print(`after ${opened + count} puzzles`, page);
  }
  for (let played = 0; played < duels; played += 25) {
    const count = Math.min(25, duels - played);
    await playDuels(page, count, played);
    await print(`after ${played + count} duels`, page);
  }
  await page.context().close();
  const element = `<pathlight-puzzle task="${EASY}"></pathlight-puzzle>`;
  const body = `<!doctype html><script type="module" src="element.js"></script>${element.repeat(10)}`;
  const article = await openMeasured(session, "article", body);
  for (let index = 0; index < 10; index++)
    await article
      .getByText(/^Model A\./)
      .nth(index)
      .waitFor();
  await print("ten elements", article);
  await session.stop();
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href)
  await measure(Number(process.argv[2] ?? 1000), Number(process.argv[3] ?? 100));
