// A miss: it ends when everything lies still, says how near the object came and when, and draws the gap.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { EASY, openPuzzle, palette, picture, pixels, says, type, waitForValue } from "./page-actions.mjs";
import { load } from "../../www/api/index.js";

let session;
before(async () => (session = await start()));
after(() => session.stop());

/**
 * A ball that misses: the object never touches, and everything lies still before the time is over.
 * @returns {Promise<{ ball: import('./page-actions.mjs').Ball, rollout: import('../../www/api/index.js').Rollout
 *   }>}
 */
async function stillMiss() {
  const pathlight = await load({ weights: null });
  for (let x = 10; x < 250; x += 4) {
    const rollout = pathlight.simulate(EASY, [x, 240, 6]);
    const last = rollout.poses.slice(-3 * rollout.bodies.length);
    const at = (step) => rollout.poses.slice(step * 3 * rollout.bodies.length, (step + 1) * 3 * rollout.bodies.length);
    if (rollout.status === "not_solved" && rollout.longest_touch === 0 && String(at(700)) === String(last))
      return { ball: [x, 240, 6], rollout };
  }
  throw new Error("every miss moves for eleven seconds");
}

test("a miss ends as soon as nothing changes any more, and its record stays whole", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  const { ball, rollout } = await stillMiss();
  await type(page, ball);
  await page.locator("#run").click();
  const words = await says(
    page,
    /^Not solved\. Your attempt 1: missed by [\d.]+ px, at [\d.]+ s; everything lies still\.$/,
  );
  const last = Number(await page.locator("#time").getAttribute("max"));
  const width = 3 * rollout.bodies.length;
  const row = (step) => String(rollout.poses.slice(step * width, (step + 1) * width));
  assert.ok(last < 700, `it ends after ${last} steps`);
  assert.equal(row(last), row(1000), "nothing changes afterwards");
  assert.notEqual(row(last - 1), row(last), "but until then");
  assert.equal(rollout.steps, 1000);
  assert.ok(words);
});

test("a miss that is watched ends by itself, without thirteen seconds of nothing", async () => {
  const page = await openPuzzle(session);
  const { ball } = await stillMiss();
  await type(page, ball);
  await page.locator("#speed").selectOption("4");
  await page.locator("#run").click();
  await says(page, /everything lies still/);
  assert.ok(Number(await page.locator("#time").getAttribute("max")) < 1000);
});

test("the gap is drawn where it was smallest, marked on the time line, and a button goes there", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  const { ball } = await stillMiss();
  await type(page, ball);
  assert.ok(await page.locator("#see-closest").isHidden());
  await page.locator("#run").click();
  const [, gap, seconds] = (await says(page, /missed by/)).match(/missed by ([\d.]+) px, at ([\d.]+) s/).map(Number);
  assert.ok(gap > 0 && gap < 256);
  assert.match(
    await page.locator("#time").evaluate((time) => time.style.getPropertyValue("--touches")),
    /var\(--text\)/,
  );
  const { ink } = palette;
  const drawn = await pixels(page, ink);
  await page.locator("#see-closest").focus();
  await page.keyboard.press("Enter");
  assert.ok(Math.abs(Number(await page.locator("#time").inputValue()) / 60 - seconds) < 0.06);
  const there = await picture(page);
  await page.locator("#reset").click();
  assert.notEqual(await picture(page), there);
  assert.ok(await page.locator("#see-closest").isHidden());
  // What is left is the rim of the ball's knob.
  assert.ok(drawn > (await pixels(page, ink)) + 20, "the gap is drawn, and goes with the attempt");
});

test("a double click on Run does not pause what it starts", async () => {
  const page = await openPuzzle(session);
  const { ball } = await stillMiss();
  await type(page, ball);
  await page.locator("#run").dblclick();
  await waitForValue(page, "#time", (value) => Number(value) > 3);
  assert.equal((await page.locator("#run").textContent()).trim(), "Pause");
});
