// Prints how long a person waits for what `make play` serves, on this machine: make timings. A tool, not a test: it
// asserts nothing. Each is measured several times; the median is printed with the worst.

import { start } from "./harness.mjs";
import { EASY, button, loadSimulator, modelIsThere, spot } from "./player.mjs";
import { customScene, templates } from "../../www/pkg/page/pathlight.js";

/** Puzzles that may be changed, with the fewest and with the most bodies. */
const [FEW, MANY] = ["00000:000", "00013:121"];
/** How long a drag is measured, ms. */
const DRAG = 2000;

await loadSimulator();
const tasks = [1, 7, 12, 16, 20, 23, 24].map((template) => templates()[template].tasks[0]);
const session = await start();
const rows = [];

await add(
  "a puzzle by its link: from an empty cache to its picture",
  tasks.map((task) => () => drawn(`/#task=${task}`)),
);
await add(
  "home: from an empty cache to its first picture",
  tasks.map(() => () => drawn("/")),
);
const page = await opened(`#task=${EASY}&panel=imagine&layers=base,placement&ball=128,200,12`);
await modelIsThere(page);
addDrag("a ball is dragged", await drag(page, [128, 200], [60, 40]));
await add(
  "another puzzle, with the weights there, to its maps",
  tasks.map((task) => () => mapsOf(page, task)),
);
await page.context().close();
for (const task of [FEW, MANY]) {
  const { body1, bodies } = customScene(task);
  const made = await opened(`#task=${task}&panel=imagine`);
  await modelIsThere(made);
  await made.getByRole("tab", { name: "Make" }).click();
  await button(made, "Play it").waitFor();
  addDrag(`one of ${bodies.length} bodies is dragged`, await drag(made, [bodies[body1].x, bodies[body1].y], [6, 3]));
  await made.context().close();
}
console.table(rows);
await session.stop();

async function opened(link) {
  const page = await session.open(`/${link}`);
  await page.getByRole("application").waitFor();
  return page;
}

/** From the start of the navigation until the scene has something on it, ms. */
async function drawn(path) {
  const page = await session.open("");
  await page.addInitScript(() => {
    requestAnimationFrame(function look(now) {
      const canvas = document.querySelector("canvas");
      const [x, y] = canvas ? [canvas.width >> 1, canvas.height >> 1] : [0, 0];
      // The paper is opaque; an empty canvas is transparent.
      if (x > 1 && canvas?.getContext("2d")?.getImageData(x, y, 1, 1).data[3])
        Object.assign(globalThis, { drawnAt: now });
      else requestAnimationFrame(look);
    });
  });
  await page.goto(session.origin + path);
  const time = await page.waitForFunction(() => /** @type {any} */ (globalThis).drawnAt);
  const value = await time.jsonValue();
  await page.context().close();
  return value;
}

/** Goes to another puzzle by its link, ms until its maps are there. */
function mapsOf(page, task) {
  return page.evaluate((task) => {
    const areThere = () => document.querySelector(".maps button") !== null;
    const start = performance.now();
    let left = false;
    return new Promise((resolve) => {
      const observer = new MutationObserver(() => {
        left ||= !areThere();
        if (!left || !areThere()) return;
        observer.disconnect();
        resolve(performance.now() - start);
      });
      observer.observe(document.body, { childList: true, subtree: true });
      location.hash = `task=${task}&panel=imagine`;
    });
  }, task);
}

/**
 * Drags what is at a point around in ellipses: the times between frames, ms, and how much of the time the page's thread
 * was busy, 0..1.
 */
async function drag(page, [x, y], [across, up]) {
  const cdp = await page.context().newCDPSession(page);
  await cdp.send("Performance.enable");
  const metric = async () => {
    const { metrics } = await cdp.send("Performance.getMetrics");
    return ["Timestamp", "TaskDuration"].map((name) => metrics.find((one) => one.name === name).value);
  };
  await page.mouse.move(...(await spot(page, x, y)));
  await page.mouse.down();
  const frames = await page.evaluateHandle(() => {
    const recorded = { times: /** @type {number[]} */ ([]), on: true };
    requestAnimationFrame(function onFrame(now) {
      recorded.times.push(now);
      if (recorded.on) requestAnimationFrame(onFrame);
    });
    return recorded;
  });
  const [from, busyBefore] = await metric();
  const origin = await spot(page, 0, 0);
  const far = await spot(page, 256, 256);
  const at = (x, y) => [origin[0] + (x / 256) * (far[0] - origin[0]), origin[1] + (y / 256) * (far[1] - origin[1])];
  const end = Date.now() + DRAG;
  for (let turn = 0; Date.now() < end; turn += 0.12) {
    const [left, top] = at(x + across * Math.sin(turn), y + up * (Math.cos(turn) - 1));
    await page.mouse.move(left, top);
  }
  const [to, busyAfter] = await metric();
  await page.mouse.up();
  const gaps = await frames.evaluate((recorded) => {
    recorded.on = false;
    return recorded.times.slice(1).map((now, index) => now - recorded.times[index]);
  });
  return { gaps, busy: (busyAfter - busyBefore) / (to - from) };
}

async function add(what, measurements) {
  const values = [];
  for (const measure of measurements) values.push(await measure());
  addRow(what, values);
}

function addDrag(what, { gaps, busy }) {
  addRow(`${what}: between two frames`, gaps);
  const seconds = gaps.reduce((sum, gap) => sum + gap, 0) / 1000;
  rows.push({ what: `${what}: frames a second`, median: (gaps.length / seconds).toFixed(1), worst: "" });
  rows.push({ what: `${what}: the page's share of a processor`, median: `${(100 * busy).toFixed(0)} %`, worst: "" });
}

function addRow(what, values) {
  const sorted = values.toSorted((one, other) => one - other);
  const words = (value) => `${value.toFixed(1)} ms`;
  rows.push({ what, median: words(sorted[sorted.length >> 1]), worst: words(sorted.at(-1)) });
}
