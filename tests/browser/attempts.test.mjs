// The player's attempts: each joins the list with a picture of how it ended, and can be compared and deleted.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { attempts, focused, known, openPuzzle, palette, picture, pixels, says, type } from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

const row = (page, number) => page.locator(`#play-attempts li[data-number="${number}"]`);

/** A puzzle on which two balls have been tried: one that misses, then one that solves. */
async function tried(options = {}) {
  const page = await openPuzzle(session, { reducedMotion: true, ...options });
  const { missing, solving } = await known();
  for (const { ball, words } of [
    { ball: missing, words: /^Not solved\. Your attempt 1/ },
    { ball: solving, words: /^Solved! Your attempt 2/ },
  ]) {
    await type(page, ball);
    await page.locator("#run").click();
    await says(page, words);
    await page.locator("#reset").click();
  }
  return page;
}

test("every attempt has a picture of its own, with its ball in it", async () => {
  const page = await tried({ deviceScaleFactor: 2 });
  const red = palette.red;
  const pictures = new Set();
  for (const number of [1, 2]) {
    await row(page, number).locator("canvas.drawn").waitFor();
    const canvas = `#play-attempts li[data-number="${number}"] canvas`;
    assert.ok((await pixels(page, red, canvas)) > 5, `the red ball of attempt ${number}`);
    pictures.add(await picture(page, canvas));
  }
  assert.equal(pictures.size, 2);
  // The result is in words too, not by colour or mark alone.
  assert.match(await row(page, 2).locator(".words").textContent(), /^solved after/);
  await page.emulateMedia({ colorScheme: "dark" });
  const canvas = page.locator('#play-attempts li[data-number="1"] canvas');
  const bright = [...pictures];
  // Drawn afresh in the dark, some frames later.
  await page.waitForFunction(
    ([canvas, bright]) => !bright.includes(canvas.toDataURL()),
    [await canvas.elementHandle(), bright],
  );
});

test("two attempts of one’s own lie over each other", async () => {
  const page = await tried();
  await row(page, 1).locator("[data-act=replay]").click();
  await says(page, /^Not solved\. Your attempt 1/);
  const alone = await picture(page);
  await row(page, 2).getByRole("button", { name: "Compare attempt 2" }).click();
  await says(page, /Your attempt 2: .+; your attempt 1 \(dashed\): /);
  assert.notEqual(await picture(page), alone);
  assert.equal(await page.locator("#play-attempts [aria-current]").count(), 2);
});

test("an attempt is deleted, by key too, and the list closes up", async () => {
  const page = await tried();
  await row(page, 1).locator("[data-act=replay]").click();
  await row(page, 1).getByRole("button", { name: "Delete attempt 1" }).focus();
  await page.keyboard.press("Enter");
  assert.equal(await attempts(page), 1);
  assert.match(await row(page, 1).locator(".words").textContent(), /^solved after/);
  assert.equal(await page.locator("#play-count").textContent(), "solved on attempt 2", "the deleted one still counts");
  // What was shown is gone, and the ball can be placed; the focus stays in the list.
  await says(page, /Ready/);
  assert.equal(await (await focused(page)).getAttribute("aria-label"), "Delete attempt 1");
  await page.keyboard.press("Enter");
  assert.equal(await attempts(page), 0);
  assert.equal(await page.locator("#play-attempts").isVisible(), false);
});

test("while a new attempt runs, another is deleted, and the new one joins the list", async () => {
  const page = await tried();
  await page.emulateMedia({ reducedMotion: "no-preference" });
  const {
    missing: [x, y, r],
  } = await known();
  await type(page, [x + 16, y, r]);
  await page.locator("#run").click();
  await says(page, /running/);
  await row(page, 1).getByRole("button", { name: "Delete attempt 1" }).click();
  assert.match(await row(page, 1).locator(".words").textContent(), /^solved after/);
  assert.equal(
    await row(page, 2).locator("[data-act=replay]").getAttribute("title"),
    `Replay: ball at x ${x + 16}, y ${y}, radius ${r}`,
  );
});

test("the buttons of an attempt are as large as a finger needs", async () => {
  const page = await tried({ viewport: { width: 360, height: 640 }, hasTouch: true, isMobile: true });
  for (const button of await row(page, 1).locator("button").all()) {
    const { width, height } = await button.boundingBox();
    assert.ok(width >= 24 && height >= 24, `${width} x ${height}`);
  }
  await row(page, 2).locator("[data-act=remove]").tap();
  assert.equal(await attempts(page), 1);
});
