// The scene on screens of other pixel ratios: it stays sharp when the page is moved from one to another.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { openPuzzle, palette, pixels } from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

test("a page that is moved to a screen of another pixel ratio draws its scene at that resolution", async () => {
  const page = await openPuzzle(session);
  const scene = await page.locator("#scene").elementHandle();
  const drawnAt = (side) => page.waitForFunction(([canvas, side]) => canvas.width === side, [scene, side]);
  // The size in CSS px stays, as it does on a real screen, whatever the emulated window does.
  await scene.evaluate(({ style }) => Object.assign(style, { width: "300px", height: "300px" }));
  await drawnAt(300);
  const { green } = palette;
  const before = await pixels(page, green);
  const devtools = await page.context().newCDPSession(page);
  // Chromium tells media queries of an emulated ratio only when the window changes too.
  for (const height of [720, 721]) {
    const metrics = { width: 1280, height, deviceScaleFactor: 2, mobile: false };
    await devtools.send("Emulation.setDeviceMetricsOverride", metrics);
  }
  await drawnAt(600);
  assert.ok((await pixels(page, green)) > 2 * before);
});
