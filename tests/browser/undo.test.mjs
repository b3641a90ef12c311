// Undo and redo of placements: by keys, by the buttons, by touch; a drag or a held key is one step.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { ball, click, dragTo, inMore, openPuzzle, says, spot, type, waitForValue } from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

/** Waits until the fields hold these numbers, "x,y,r". */
async function shows(page, wanted) {
  const values = wanted.split(",");
  for (const [index, name] of ["x", "y", "r"].entries())
    await waitForValue(page, `#ball-${name}`, (value) => value === values[index]);
}

test("a drag is undone in one step, back to no ball at all, and redone", async () => {
  const page = await openPuzzle(session);
  await click(page, 60, 220);
  const first = await ball(page);
  await page.mouse.move(...(await spot(page, 60, 220)));
  await page.mouse.down();
  await page.mouse.move(...(await spot(page, 120, 200)), { steps: 12 });
  await page.mouse.up();
  const second = await ball(page);
  assert.notDeepEqual(second, first);
  await page.keyboard.press("Control+z");
  assert.deepEqual(await ball(page), first);
  await page.keyboard.press("Control+z");
  await shows(page, ",,");
  await says(page, /place the red ball/);
  assert.ok(await page.locator("#undo").isDisabled());
  await page.keyboard.press("Control+y");
  assert.deepEqual(await ball(page), first);
  await page.keyboard.press("Control+Shift+z");
  assert.deepEqual(await ball(page), second);
  assert.ok(await page.locator("#redo").isDisabled());
});

test("what had been undone is forgotten when the ball is placed again", async () => {
  const page = await openPuzzle(session);
  await type(page, [100, 200, 10]);
  await page.locator("#scene").focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Meta+z");
  assert.deepEqual(await ball(page), [101, 200, 10], "each press of a key is a step");
  await page.keyboard.press("ArrowUp");
  assert.ok(await page.locator("#redo").isDisabled());
  await page.keyboard.press("Meta+y");
  assert.deepEqual(await ball(page), [101, 201, 10]);
});

test("a key that is held and a turn of the wheel are one step each", async () => {
  const page = await openPuzzle(session);
  await type(page, [100, 200, 10]);
  await page.locator("#scene").focus();
  for (let presses = 0; presses < 6; presses += 1) await page.keyboard.down("ArrowLeft");
  await page.keyboard.up("ArrowLeft");
  assert.deepEqual(await ball(page), [94, 200, 10]);
  await page.mouse.move(...(await spot(page, 94, 200)));
  for (let notches = 0; notches < 3; notches += 1) await page.mouse.wheel(0, -100);
  await shows(page, "94,200,13");
  await page.locator("#undo").click();
  assert.deepEqual(await ball(page), [94, 200, 10]);
  await page.locator("#undo").click();
  assert.deepEqual(await ball(page), [100, 200, 10]);
});

test("the buttons are there for fingers, and undo out of a run", async () => {
  const page = await openPuzzle(session, {
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    isMobile: true,
    reducedMotion: true,
  });
  await page.touchscreen.tap(...(await spot(page, 128, 230)));
  const first = await ball(page);
  await page.touchscreen.tap(...(await spot(page, 40, 230)));
  const second = await ball(page);
  await page.locator("#run").tap();
  await says(page, /attempt 1/);
  await page.locator("#undo").tap();
  assert.deepEqual(await ball(page), first);
  await says(page, /Ready|Not here/);
  await page.locator("#redo").tap();
  assert.deepEqual(await ball(page), second);
});

test("in a field, Ctrl+Z takes back the placement and what was being typed", async () => {
  const page = await openPuzzle(session);
  await type(page, [100, 200, 10]);
  await page.locator("#scene").focus();
  await page.keyboard.press("ArrowUp");
  await inMore(page, async () => {
    await page.locator("#ball-x").fill("7");
    await page.keyboard.press("Control+z");
  });
  await shows(page, "100,200,10");
});

test("undo in the middle of a drag ends the drag", async () => {
  const page = await openPuzzle(session);
  // Pressed in an empty scene: undone, there is no ball to drag.
  await dragTo(page, [
    [60, 220],
    [90, 210],
  ]);
  await page.keyboard.press("Control+z");
  await page.mouse.move(...(await spot(page, 120, 200)), { steps: 5 });
  await page.mouse.up();
  await shows(page, ",,");

  await type(page, [100, 200, 10]);
  await dragTo(page, [
    [100, 200],
    [130, 210],
  ]);
  await page.keyboard.press("Control+z");
  await page.mouse.move(...(await spot(page, 150, 220)), { steps: 5 });
  await page.mouse.up();
  await shows(page, "100,200,10");
  assert.ok(await page.locator("#notice").isHidden());
});
