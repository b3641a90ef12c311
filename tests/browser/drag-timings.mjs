// How smoothly something follows the pointer in the scene, and how long the maps of a scene that is being edited take
// to follow: for timings.mjs.

import { spot } from "./page-actions.mjs";

/** @typedef {import('playwright-core').Page} Page */

/** The benchmark's puzzles with the fewest, the median number and the most bodies, of those that may be edited. */
const BENT = ["00000:000", "00004:611", "00013:121"];

/** Time of a drag, ms. */
const DRAG = 2000;

/**
 * Drags what is at a point around in ellipses: the times between frames, ms.
 * @param {Page} page
 * @param {[x: number, y: number]} from px
 * @param {[x: number, y: number]} radii px
 */
export async function drag(page, [x, y], [across, up]) {
  await page.mouse.move(...(await spot(page, x, y)));
  await page.mouse.down();
  const frames = await page.evaluateHandle(() => {
    /** @type {{ times: number[], on: boolean }} */
    const recorded = { times: [], on: true };
    const onFrame = (now) => {
      recorded.times.push(now);
      if (recorded.on) requestAnimationFrame(onFrame);
    };
    requestAnimationFrame(onFrame);
    return recorded;
  });
  const end = Date.now() + DRAG;
  for (let turn = 0; Date.now() < end; turn += 0.12) {
    await page.mouse.move(...(await spot(page, x + across * Math.sin(turn), y + up * (Math.cos(turn) - 1))));
  }
  await page.mouse.up();
  return frames.evaluate((recorded) => {
    recorded.on = false;
    return recorded.times.slice(1).map((now, index) => now - recorded.times[index]);
  });
}

/**
 * Drags the green object of three puzzles in the panel Make: for each the times between frames, and those from a move
 * of the pointer until the frame that shows the maps imagined of it, ms.
 * @param {Awaited<ReturnType<typeof import('./harness.mjs').start>>} session
 * @param {(task: string) => Promise<import('../../www/pkg/pathlight.js').CustomScene>} sceneOf
 */
export async function editingTimings(session, sceneOf) {
  const timings = [];
  for (const task of BENT) {
    const { body1, bodies } = await sceneOf(task);
    const page = await session.open("");
    await page.addInitScript(watchMaps);
    await page.goto(`${session.origin}/#task=${task}&panel=make`);
    await page.locator('#make-maps canvas[aria-label*="not imagined yet"]').first().waitFor({ state: "detached" });
    const latencies = await page.evaluateHandle(() => globalThis.mapLatencies());
    const { x, y } = bodies[body1];
    const gaps = await drag(page, [x, y], [6, 3]);
    timings.push({ bodies: bodies.length, gaps, latencies: await latencies.jsonValue() });
    await page.context().close();
  }
  return timings;
}

/** Runs in the page before it: records when the worker is asked for maps, and for which move of the pointer. */
function watchMaps() {
  let [moved, askedFor] = [0, 0];
  addEventListener("pointermove", () => (moved = performance.now()), { capture: true });
  const { postMessage } = Worker.prototype;
  Worker.prototype.postMessage = function (message, ...rest) {
    if (message.call === "imagine") askedFor = moved;
    return postMessage.call(this, message, ...rest);
  };
  globalThis.mapLatencies = () => {
    /** @type {number[]} */
    const latencies = [];
    const canvas = /** @type {HTMLCanvasElement} */ (
      document.querySelector("#puzzle")?.shadowRoot?.querySelector("#make-maps canvas")
    );
    const map = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
    const { putImageData } = map;
    map.putImageData = (/** @type {any[]} */ ...image) => {
      const start = askedFor;
      requestAnimationFrame(() => latencies.push(performance.now() - start));
      putImageData.apply(map, /** @type {any} */ (image));
    };
    return latencies;
  };
}
