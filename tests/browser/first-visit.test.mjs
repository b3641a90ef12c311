// The first visit: an introduction of half a minute leads from watching to what the model imagines; it can be skipped,
// and is offered only once.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { axeFindsNothing } from "./axe.mjs";
import { start } from "./harness.mjs";
import { modelLoaded, openPuzzle, says, spot } from "./page-actions.mjs";

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

let session;
before(async () => (session = await start()));
after(() => session.stop());

const guide = async (page, count, words) => {
  await page
    .locator("#guide-count")
    .filter({ hasText: `${count} of 5` })
    .waitFor();
  assert.match(await page.locator("#guide-words").textContent(), words);
};

test("with a finger: watch, guess, place, run, see what the model imagines", async () => {
  const page = await session.open("/", { ...PHONE, reducedMotion: "reduce" });
  await page.locator("#welcome-start").tap();
  await guide(page, 1, /First watch/);
  const act = page.locator("#guide-act");
  await act.tap();
  await guide(page, 2, /Where would it help/);
  assert.ok(await act.isHidden());
  await page.touchscreen.tap(...(await spot(page, 128, 30)));
  await guide(page, 3, /A guess!/);
  await axeFindsNothing(page);
  await act.tap();
  await guide(page, 4, /what the model imagines|What the model imagines|see what the model/);
  await modelLoaded(page);
  await act.tap();
  await guide(page, 5, /The shade is where/);
  assert.equal(await page.locator("#tab-imagine").getAttribute("aria-selected"), "true");
  await act.tap();
  assert.ok(await page.locator("#guide").isHidden());
  // Never again.
  await page.goto(`${session.origin}/`);
  await page.reload();
  await page.locator("#templates a").first().waitFor();
  assert.ok(await page.locator("#welcome").isHidden());
});

test("by keyboard, with the motion", async () => {
  const page = await session.open("/");
  await page.locator("#welcome-start").waitFor();
  await page.locator("#welcome-start").press("Enter");
  await guide(page, 1, /First watch/);
  await page.keyboard.press("Enter");
  await guide(page, 1, /Nobody helps/);
  await guide(page, 2, /Where would it help/);
  await page.locator("#scene").focus();
  await page.keyboard.press("Shift+ArrowUp");
  await guide(page, 3, /A guess!/);
  await page.keyboard.press("Enter");
  await guide(page, 3, /nobody touches anything/);
  await says(page, /^(Not solved|Solved)/);
  await guide(page, 4, /model/);
});

test("it is skipped at any step, and declined at once", async () => {
  const page = await session.open("/");
  await page.locator("#welcome-start").click();
  await page.locator("#guide-skip").click();
  assert.ok(await page.locator("#guide").isHidden());
  await says(page, /place the red ball/);

  const other = await session.open("/");
  await other.locator("#welcome-skip").click();
  assert.ok(await other.locator("#welcome").isHidden());
  await other.reload();
  await other.locator("#templates a").first().waitFor();
  assert.ok(await other.locator("#welcome").isHidden());
});

test("who has played before, or comes by a link, is not led", async () => {
  const page = await openPuzzle(session);
  assert.ok(await page.locator("#guide").isHidden());
  await page.evaluate(() =>
    localStorage.setItem(
      "pathlight.progress",
      JSON.stringify({ tasks: { "00000:000": { attempts: 1, solved: null } } }),
    ),
  );
  await page.goto(`${session.origin}/`);
  await page.reload();
  await page.locator("#progress:visible").waitFor();
  assert.ok(await page.locator("#welcome").isHidden());
});
