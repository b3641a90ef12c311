// Each of the 25 templates: drawn on the grid, opened from there, and drawn as a scene with its goal in words.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { palette, pixels } from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

test("the grid draws 25 thumbnails when they scroll into sight", async () => {
  const page = await session.open("/");
  const canvases = page.locator("#templates canvas");
  await page.locator("#templates canvas.drawn").first().waitFor();
  assert.equal(await canvases.count(), 25);
  // Below the fold nothing is drawn before it is needed.
  assert.ok((await page.locator("#templates canvas.drawn").count()) < 25);
  for (let index = 0; index < 25; index += 1) await canvases.nth(index).scrollIntoViewIfNeeded();
  await page.waitForFunction(() => document.querySelectorAll("#templates canvas.drawn").length === 25);
});

test("every template opens from the grid with its scene and its goal", async () => {
  const page = await session.open("/");
  const links = page.locator("#templates a");
  await links.first().waitFor();
  const colours = palette;
  for (let index = 0; index < 25; index += 1) {
    const name = await links.nth(index).locator("strong").textContent();
    await links.nth(index).click();
    await page.locator("#scene").waitFor();
    assert.equal(await page.locator("#puzzle-name").textContent(), name);
    const goal = await page.locator("#goal").textContent();
    const [, target] = goal.match(/^Get the green \w+ to touch the (blue|purple) [\w ]+ for 3 seconds\.$/) ?? [];
    assert.ok(target, `${name}: ${goal}`);
    for (const role of ["green", target]) {
      assert.ok((await pixels(page, colours[role])) > 20, `${name}: the ${role} body is drawn`);
    }
    assert.match(await page.locator("#description").textContent(), /the goal is the (blue|purple)/);
    await page.locator("#home").click();
    await page.locator("#gallery").waitFor();
  }
});

test("the picker goes through the 100 puzzles of a template and to any", async () => {
  const page = await session.open("/");
  await page.locator("#templates a").nth(3).click();
  const select = page.locator("#task");
  const ids = await select
    .locator("option")
    .evaluateAll((options) => options.map((option) => /** @type {HTMLOptionElement} */ (option).value));
  assert.equal(ids.length, 100);
  assert.equal(await select.locator("option").nth(7).textContent(), "8 of 100");
  await page.locator("#next").click();
  assert.equal(await select.inputValue(), ids[1]);
  assert.match(page.url(), new RegExp(`task=${ids[1]}`));
  await page.locator("#previous").click();
  await page.locator("#previous").click();
  assert.equal(await select.inputValue(), ids[99]);
  await select.selectOption(ids[42]);
  assert.match(await page.title(), new RegExp(ids[42]));
  await page.goBack();
  assert.equal(await select.inputValue(), ids[99]);
  await page.locator("#random").click();
  assert.match(page.url(), /task=000[0-2]\d:\d{3}/);
});

test("the grid tells how hard the kinds are, and orders them by that", async () => {
  const page = await session.open("/");
  const names = () => page.locator("#templates strong").allTextContents();
  await page
    .locator("#templates i")
    .filter({ hasText: /^mostly (easy|medium|hard)$/ })
    .nth(24)
    .waitFor({ state: "attached" });
  const byNumber = await names();
  await page.locator("#gallery-order").selectOption("difficulty");
  const easiest = await names();
  assert.notDeepEqual(easiest, byNumber);
  assert.deepEqual(easiest.toSorted(), byNumber.toSorted());
  const kinds = await page.locator("#templates i").allTextContents();
  const rank = (words) => ["mostly easy", "mostly medium", "mostly hard"].indexOf(words);
  assert.deepEqual(
    kinds.map(rank),
    kinds.map(rank).toSorted((one, other) => one - other),
  );
  await page.locator("#gallery-order").selectOption("number");
  assert.deepEqual(await names(), byNumber);
});
