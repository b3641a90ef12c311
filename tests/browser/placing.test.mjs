// Placing the ball with the mouse, the wheel, the knob and the fields; where it may not be, the page says why.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import {
  attempts,
  ball,
  click,
  dragTo,
  inMore,
  known,
  openPuzzle,
  palette,
  pixels,
  says,
  spot,
  type,
  waitForValue,
} from "./page-actions.mjs";

let session;
before(async () => (session = await start({ sources: true })));
after(() => session.stop());

test("a click places the ball there, in whole px", async () => {
  const page = await openPuzzle(session);
  await says(page, /place the red ball/);
  const {
    missing: [x, y],
  } = await known();
  await click(page, x, y);
  const [atX, atY, r] = await ball(page);
  assert.ok(Math.abs(atX - x) <= 1 && Math.abs(atY - y) <= 1, `${atX}, ${atY}`);
  assert.ok(Number.isInteger(atX) && Number.isInteger(atY) && r >= 2);
  assert.ok((await pixels(page, palette.red)) > 50);
});

test("a drag moves the ball, the knob and the wheel change its radius", async () => {
  const page = await openPuzzle(session);
  await type(page, [128, 200, 12]);
  await page.mouse.move(...(await spot(page, 130, 202)));
  await page.mouse.down();
  await page.mouse.move(...(await spot(page, 100, 220)), { steps: 8 });
  await page.mouse.up();
  const [x, y, r] = await ball(page);
  assert.ok(Math.abs(x - 98) <= 1 && Math.abs(y - 218) <= 1, `dragged to ${x}, ${y}`);
  assert.equal(r, 12);

  await page.mouse.move(...(await spot(page, x + r, y)));
  await page.mouse.down();
  await page.mouse.move(...(await spot(page, x + 25, y)), { steps: 5 });
  await page.mouse.up();
  assert.ok(Math.abs((await ball(page))[2] - 25) <= 1);

  const [, , before] = await ball(page);
  await page.mouse.wheel(0, -100);
  await page.mouse.wheel(0, -100);
  await page.mouse.wheel(0, 100);
  await waitForValue(page, "#ball-r", (value) => value === String(before + 1));
  await page.locator("#radius").fill("9");
  assert.deepEqual(await ball(page), [x, y, 9]);
});

test("an invalid ball is outlined, named and never counts", async () => {
  const page = await openPuzzle(session);
  const { invalid } = await known();
  await type(page, invalid);
  const words = await says(page, /^Not here: (too close to the edge|the ball overlaps the [\w ]+)\.$/);
  // It is announced, in the only live region; a dialog and another view may have their own.
  const live = page.locator(":is([role=status], [aria-live], output):not(dialog *, [hidden] *)");
  assert.equal(await live.count(), 1);
  assert.equal(await live.textContent(), words);
  await page.locator("#run").click();
  await says(page, /does not count as an attempt/);
  assert.equal(await attempts(page), 0);
});

test("a ball that is dropped where it may not lie slides to the nearest place", async () => {
  const page = await openPuzzle(session);
  await type(page, [128, 200, 12]);
  await dragTo(page, [
    [128, 200],
    [60, 252],
  ]);
  await says(page, /^Not here/);
  await page.mouse.up();
  await says(page, /Ready/);
  const [x, y, r] = await ball(page);
  assert.ok(Math.abs(x - 60) <= 1 && y === 256 - r && r === 12, `it lies at ${x}, ${y}`);
  await page.keyboard.press("Control+z");
  assert.deepEqual(await ball(page), [128, 200, 12]);
});

test("a field that is emptied goes on showing the ball", async () => {
  const page = await openPuzzle(session);
  await type(page, [128, 200, 12]);
  await inMore(page, async () => {
    await page.locator("#ball-r").fill("");
    await page.locator("#ball-r").press("Tab");
  });
  assert.equal(await page.locator("#ball-r").inputValue(), "12");
});

test("without a ball, Run says what to do", async () => {
  const page = await openPuzzle(session);
  await page.locator("#run").click();
  await says(page, /Place the ball first/);
});

test("however many moves a drag makes, a frame is drawn once", async () => {
  const page = await openPuzzle(session, { fragment: "&ball=128,200,12" });
  await page.evaluate(async () => {
    const { Game } = await import("/pkg/pathlight.js");
    const paint = Game.prototype.paint;
    globalThis.drawings = 0;
    Game.prototype.paint = function (...args) {
      paint.apply(this, args);
      globalThis.drawings += 1;
    };
  });
  const [x, y] = await spot(page, 128, 200);
  await page.mouse.move(x, y);
  await page.mouse.down();
  const drawings = await page.locator("#scene").evaluate(
    async (scene, [x, y]) => {
      const next = () => new Promise((resume) => requestAnimationFrame(resume));
      await next();
      globalThis.drawings = 0;
      for (let frame = 0; frame < 30; frame += 1) {
        for (let move = 0; move < 20; move += 1) {
          scene.dispatchEvent(
            new PointerEvent("pointermove", {
              clientX: x + frame * 2,
              clientY: y + move,
              isPrimary: true,
              bubbles: true,
            }),
          );
        }
        await next();
      }
      return globalThis.drawings;
    },
    [x, y],
  );
  await page.mouse.up();
  assert.ok(drawings >= 20 && drawings <= 31, `${drawings} drawings in 30 frames of 20 moves`);
});

test("a second finger does not end the drag of the first", async () => {
  const page = await openPuzzle(session);
  await type(page, [128, 200, 12]);
  await dragTo(page, [
    [128, 200],
    [110, 210],
  ]);
  await page.locator("#scene").dispatchEvent("pointerup", { isPrimary: false, pointerId: 77 });
  await page.mouse.move(...(await spot(page, 90, 220)), { steps: 5 });
  await page.mouse.up();
  const [x, y] = await ball(page);
  assert.ok(Math.abs(x - 90) <= 1 && Math.abs(y - 220) <= 1, `dragged to ${x}, ${y}`);
});
