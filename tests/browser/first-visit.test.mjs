// The first visit: an introduction of half a minute leads from watching to a race with the model. It says why a ball
// may not lie somewhere, can be left at any time, and is found again on the home page.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { FIRST_RADIUS } from "../../www/shell/constants.js";
import { FIRST_TASK } from "../../www/home/home-tasks.js";
import { axeFindsNothing } from "./axe.mjs";
import { start } from "./harness.mjs";
import { modelLoaded, openPuzzle, says, spot } from "./page-actions.mjs";

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

/** A ball that solves the puzzle of the introduction, as large as a ball is at first. */
let solution;
let session;
before(async () => {
  const lines = (await readFile(new URL("../../assets/solutions.jsonl", import.meta.url), "utf8")).trim().split("\n");
  solution = lines
    .filter((line) => line.includes(`"${FIRST_TASK}"`))
    .flatMap((line) => JSON.parse(line).balls)
    .find(([, , r]) => r === FIRST_RADIUS);
  session = await start();
});
after(() => session.stop());

const guide = async (page, count, words) => {
  await page
    .locator("#guide-count")
    .filter({ hasText: `${count} of 4` })
    .waitFor();
  await page.locator("#guide-words").filter({ hasText: words }).waitFor();
};

test("with a finger: watch, place, drop, race", async () => {
  const page = await session.open("/", { ...PHONE, reducedMotion: "reduce" });
  await page.locator("#guide-start:enabled").tap();
  await guide(page, 1, /First watch/);
  const act = page.locator("#guide-act");
  await act.tap();
  await guide(page, 2, /where would it help/);
  assert.ok(await act.isHidden());
  const [x, y] = solution;
  await page.touchscreen.tap(...(await spot(page, x, y)));
  await guide(page, 2, /It fits there/);
  await axeFindsNothing(page);
  await modelLoaded(page);
  await act.tap();
  await guide(page, 3, /^Solved!/);
  await act.tap();
  await guide(page, 4, /tries its own balls/);
  assert.ok(await page.locator("#guide-skip").isHidden(), "there is nothing left to leave");
  await page.locator("#race-verdict").filter({ hasText: "the model" }).waitFor({ timeout: 120_000 });
  await act.tap();
  assert.ok(await page.locator("#guide").isHidden());
});

test("by keyboard, with the motion", async () => {
  const page = await session.open("/");
  await page.locator("#guide-start:enabled").press("Enter");
  await guide(page, 1, /First watch/);
  await page.keyboard.press("Enter");
  await guide(page, 1, /Nobody helps/);
  await guide(page, 2, /where would it help/);
  await page.locator("#scene").focus();
  // The first puts the ball into the middle, where a bar is; the others move it off that.
  for (let times = 0; times < 5; times += 1) await page.keyboard.press("Shift+ArrowRight");
  await guide(page, 2, /It fits there/);
  await page.keyboard.press("Enter");
  await guide(page, 3, /nobody touches anything/);
  await says(page, /^(Not solved|Solved)/);
  await guide(page, 3, /model/);
});

test("a ball that may not lie there is no step back, and it is told why", async () => {
  const page = await session.open("/", { reducedMotion: "reduce" });
  await page.locator("#guide-start:enabled").click();
  await page.locator("#guide-act").click();
  await guide(page, 2, /where would it help/);
  await page.mouse.click(...(await spot(page, 40, 230)));
  await page.locator("#guide-act").click();
  await guide(page, 3, /Not yet/);
  await page.mouse.click(...(await spot(page, 20, 230)));
  await guide(page, 3, /It fits there/);
  for (let step = 0; step < 2; step += 1) await page.keyboard.press("Shift+ArrowLeft");
  await guide(page, 3, /^Not here: .+\. The ball needs a free spot/);
  // A ball that is put down at the edge slides in.
  await page.mouse.click(...(await spot(page, 2, 230)));
  await guide(page, 3, /It fits there/);
});

test("it is left at any step, and found again", async () => {
  const page = await session.open("/");
  await page.locator("#guide-start:enabled").click();
  await page.locator("#guide-skip").click();
  assert.ok(await page.locator("#guide").isHidden());
  await says(page, /place the red ball/);
  await page.locator("#home").click();
  await page.locator("#guide-start").click();
  await guide(page, 1, /First watch/);
});

test("who comes by a link is not led", async () => {
  const page = await openPuzzle(session);
  assert.ok(await page.locator("#guide").isHidden());
});
