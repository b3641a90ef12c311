// The walkthrough of the maps, and the probe under the pointer: by mouse, touch and keys, from a link too.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { openImagined, picture, spot } from "./page-actions.mjs";

const MAPS = ["base", "target", "action", "placement", "success"];
/** How a model that imagines balls chooses one, and what comes of it. */
const CHOICE = ["candidates", "imagined", "chosen", "run", "real"];

let session;
before(async () => (session = await start()));
after(() => session.stop());

const imagine = (options) => openImagined(session, options);

/** The maps that are in the panel, and those that lie over the scene. */
async function shown(page) {
  const rows = await page.locator("#maps li:visible").evaluateAll((rows) => rows.map((row) => row.dataset.map));
  const laid = await page
    .locator("#maps input:checked")
    .evaluateAll((boxes) => boxes.map((box) => box.closest("li").dataset.map));
  return { rows, laid };
}

test("each step shows one map alone, forward and back, and all again", async () => {
  const page = await imagine();
  assert.deepEqual((await shown(page)).rows, MAPS);
  for (const map of MAPS) {
    await page.locator("#walkthrough-next").click();
    assert.deepEqual(await shown(page), { rows: [map], laid: [map] });
    const row = page.locator(`[data-map=${map}]`);
    assert.match(await row.locator(".meaning").textContent(), /^Where .+\.$/);
    assert.match(
      await row.locator(".summary").textContent(),
      /^Most sure [a-z ]+(, also sure [a-z ]+)?\.$/,
      "in words of the scene",
    );
    assert.match(
      await row.locator(".numbers").textContent(),
      /^In numbers: strongest at x \d+, y \d+; \d+ percent on the left, \d+ on the right\.$/,
    );
    assert.match(await page.locator("#announcement").textContent(), /Where .+ It is most sure /, "it is said aloud");
  }
  await page.locator("#walkthrough-dots button:visible").last().click();
  const last = await page.locator("#walkthrough-step").textContent();
  assert.equal(last, `Step ${MAPS.length + CHOICE.length} of ${MAPS.length + CHOICE.length}`);
  await page.locator("#walkthrough-next").press("Enter");
  assert.equal(await page.locator("#walkthrough-step").textContent(), last, "there is no more");
  for (let back = 0; back <= CHOICE.length; back += 1) await page.locator("#walkthrough-back").click();
  assert.deepEqual((await shown(page)).rows, ["placement"]);
  await page.locator("#walkthrough-dots button").first().click();
  assert.deepEqual((await shown(page)).rows, ["base"]);
  await page.locator("#walkthrough-all").click();
  assert.deepEqual((await shown(page)).rows, MAPS);
});

test("it plays by itself to the end, and a step is in the link", async () => {
  const page = await imagine();
  await page.locator("#walkthrough-play").click();
  for (const step of [...MAPS, ...CHOICE]) {
    await page.waitForFunction((step) => location.hash.includes(`step=${step}`), step, { timeout: 30_000 });
  }
  await page.locator("#walkthrough-play-label", { hasText: "Play" }).waitFor();
  await page.reload();
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
  assert.deepEqual(await shown(page), { rows: [], laid: [] });
});

test("keys go through the steps", async () => {
  const page = await imagine();
  await page.locator("#walkthrough-next").focus();
  for (const map of MAPS) {
    await page.keyboard.press("Enter");
    assert.deepEqual((await shown(page)).rows, [map]);
  }
});

test("the mouse reads the maps that lie over the scene", async () => {
  const page = await imagine();
  await page.locator("[data-map=base] input").check();
  const summary = await page.locator("[data-map=base] .numbers").textContent();
  const [, x, y] = summary.match(/x (\d+), y (\d+)/).map(Number);
  await page.mouse.move(...(await spot(page, x, y)));
  const peak = await page.locator("[data-map=base] .scale span").last().textContent();
  const note = await page.locator("#probe").textContent();
  assert.ok(note.startsWith(`Base path ${peak}`), `${note}: its peak is ${peak}`);
  assert.match(await page.locator("[data-map=base] .value").textContent(), new RegExp(`^${peak} at x ${x}, y `));
  assert.match(await page.locator("[data-map=placement] .value").textContent(), /^\d\.\d\d at/, "all are read");
  await page.mouse.move(2, 2);
  await page.locator("#probe").waitFor({ state: "hidden" });
});

test("a finger reads too, and its values stay", async () => {
  const page = await imagine({ hasTouch: true, viewport: { width: 390, height: 844 } });
  await page.locator("#walkthrough-next").tap();
  await page.touchscreen.tap(...(await spot(page, 100, 200)));
  assert.match(
    await page.locator("#probe:visible").textContent(),
    /^Base path \d\.\d\dx (99|100|101), y (199|200|201)$/,
  );
});

test("arrow keys on a small map read it", async () => {
  const page = await imagine();
  await page.locator("[data-map=target] .map").focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Shift+ArrowUp");
  assert.match(await page.locator("#announcement").textContent(), /^x 132, y 160: \d\.\d\d$/);
  assert.match(await page.locator("[data-map=target] .value").textContent(), /^\d\.\d\d at x 132, y 160$/);
});

test("it ends with the choice: the candidates, what is imagined for them, the ball that is tried first", async () => {
  const page = await imagine();
  const pictures = new Set([await picture(page)]);
  await page.locator('[aria-label="Step 5: Success"]').click();
  for (const [name, words] of Object.entries({
    Candidates: /^Here there are \d+; a ring stands for the middle of each\.$/,
    Imagined: /^Here \d+ of the \d+ balls are more likely to solve the puzzle than not\./,
    Chosen: /^Here it is the ball at x \d+, y \d+ with radius \d+: [a-z ]+ \(.+ %\)\.$/,
  })) {
    await page.locator("#walkthrough-next").press("Enter");
    assert.equal(await page.locator("#choice-title").textContent(), name);
    await page.locator("#choice-result").filter({ hasText: words }).waitFor();
    assert.deepEqual(await shown(page), { rows: [], laid: [] });
    assert.match(await page.locator("#announcement").textContent(), new RegExp(`^${name}\\. `), "it is said aloud");
    pictures.add(await picture(page));
  }
  assert.equal(pictures.size, 4, "each lays something else over the scene");
  const [, x, y, r] =
    (await page.locator("#choice-result").textContent()).match(/x (\d+), y (\d+) with radius (\d+)/) ?? [];
  await page.locator("#tab-compare").click();
  await page.locator("#proposal-next").click();
  assert.equal(
    await page.locator("#proposal-ball").textContent(),
    `x ${x}, y ${y}, radius ${r}`,
    "it is the first of its turn",
  );
});
