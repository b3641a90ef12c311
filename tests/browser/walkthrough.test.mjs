// The walkthrough of the maps: by mouse, touch and keys, from a link too.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { click, mapsImagined, openImagined, openPuzzle, picture } from "./page-actions.mjs";

const MAPS = ["base", "target", "action", "placement", "success"];
/** The maps that each step lays over the scene and leaves in the panel. */
const STEPS = {
  base: ["base"],
  target: ["target"],
  action: ["action"],
  placement: ["placement", "success"],
  imagined: [],
  run: [],
};
const COUNT = Object.keys(STEPS).length;

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

test("each step shows its maps alone, forward and back, and all again", async () => {
  const page = await imagine();
  assert.deepEqual(await shown(page), { rows: MAPS, laid: ["target", "action"] });
  for (const maps of Object.values(STEPS).slice(0, 4)) {
    await page.locator("#walkthrough-next").click();
    assert.deepEqual(await shown(page), { rows: maps, laid: maps });
    const row = page.locator(`[data-map=${maps[0]}]`);
    assert.match(await row.locator(".meaning").textContent(), /^(Where|A path) .+\.$/);
    assert.match(
      await row.locator(".summary").textContent(),
      /^Most sure [a-z ]+(, also sure [a-z ]+)?\.$/,
      "in words of the scene",
    );
    assert.match(
      await row.locator(".numbers").textContent(),
      /^In numbers: strongest at x \d+, y \d+; \d+ percent on the left, \d+ on the right\.$/,
    );
    assert.match(await page.locator("#announcement").textContent(), /It is most sure /, "it is said aloud");
  }
  await page.locator("#walkthrough-dots button:visible").last().click();
  const last = await page.locator("#walkthrough-step").textContent();
  assert.equal(last, `Step ${COUNT} of ${COUNT}`);
  await page.locator("#walkthrough-next").press("Enter");
  assert.equal(await page.locator("#walkthrough-step").textContent(), last, "there is no more");
  for (const maps of [[], STEPS.placement]) {
    await page.locator("#walkthrough-back").click();
    assert.deepEqual((await shown(page)).rows, maps);
  }
  await page.locator("#walkthrough-dots button").first().click();
  assert.deepEqual((await shown(page)).rows, ["base"]);
  await page.locator("#walkthrough-all").click();
  assert.deepEqual(await shown(page), { rows: MAPS, laid: ["target", "action"] });
});

/** Waits until the story has gone through all its steps by itself, and stands still. */
async function playsThrough(page) {
  for (const step of Object.keys(STEPS))
    await page.waitForFunction((step) => location.hash.endsWith(`step=${step}`), step, { timeout: 30_000 });
  await page.locator("#walkthrough-play-label", { hasText: "Play" }).waitFor();
}

test("it plays by itself to the end, and a step is in the link", async () => {
  const page = await imagine();
  await page.locator("#walkthrough-play").click();
  await playsThrough(page);
  await page.reload();
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
  assert.deepEqual(await shown(page), { rows: [], laid: [] });
});

test("opened for the first time it shows two maps, then plays through once; later the person sets the pace", async () => {
  const page = await openPuzzle(session, { newcomer: true });
  // It begins some seconds after the panel is opened, or once the model is there.
  await mapsImagined(page);
  await page.locator("#tab-imagine").click();
  await page.locator("#walkthrough-play-label", { hasText: "Pause" }).waitFor();
  assert.deepEqual((await shown(page)).laid, ["target", "action"]);
  await playsThrough(page);
  await page.locator("#next").click();
  for (const tab of ["play", "imagine"]) await page.locator(`#tab-${tab}`).click();
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
  assert.equal(await page.locator("#walkthrough-play-label").textContent(), "Play");
});

test("what the person does ends the story that plays by itself", async () => {
  for (const act of [
    (page) => page.locator("[data-map=placement] .map").click(),
    (page) => page.locator("#walkthrough-next").click(),
    (page) => click(page, 128, 240),
  ]) {
    const page = await openPuzzle(session, { newcomer: true });
    await page.locator("#tab-imagine").click();
    await page.locator("#walkthrough-play-label", { hasText: "Pause" }).waitFor();
    await act(page);
    await page.locator("#walkthrough-play-label", { hasText: "Play" }).waitFor();
  }
});

test("it does not play by itself from a link, in a lesson or with reduced motion", async () => {
  for (const options of [{ fragment: "&panel=imagine" }, { fragment: "&hide=compare" }, { reducedMotion: true }]) {
    const page = await openPuzzle(session, { newcomer: true, ...options });
    await page.locator("#tab-imagine").click();
    await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
    assert.equal(await page.locator("#walkthrough-play-label").textContent(), "Play");
  }
});

test("the buttons of the story stay where they are", async () => {
  const page = await imagine({ viewport: { width: 1280, height: 800 } });
  const next = page.locator("#walkthrough-next");
  const place = await next.boundingBox();
  await page.locator("#walkthrough-play").click();
  await page.locator("#walkthrough-step", { hasText: "Step 1" }).waitFor({ state: "attached" });
  assert.deepEqual(await next.boundingBox(), place, "while it plays");
  for (let step = 2; step <= COUNT; step += 1) {
    await next.click();
    await page.locator("#walkthrough-step", { hasText: `Step ${step}` }).waitFor({ state: "attached" });
    assert.deepEqual(await next.boundingBox(), place, `at step ${step}`);
  }
});

test("keys go through the steps", async () => {
  const page = await imagine();
  await page.locator("#walkthrough-next").focus();
  for (const maps of Object.values(STEPS)) {
    await page.keyboard.press("Enter");
    assert.deepEqual((await shown(page)).rows, maps);
  }
});

test("it ends with the futures of the likeliest balls, and with the one that is tried first", async () => {
  const page = await imagine({ reducedMotion: true });
  const pictures = new Set([await picture(page)]);
  await page.locator('[aria-label="Step 4: Where to start"]').click();
  for (const [name, words] of Object.entries({
    "Forty futures": /^It considered \d+ balls, and gives (\d+|none) of them a chance above 50%\.$/,
    "Run and compare":
      /^The model’s guess was: .+ \(.+%\)\. (Solved|It did not work\.) .+ Its path for green was \d+ px off, on average\.$/,
  })) {
    await page.locator("#walkthrough-next").press("Enter");
    assert.equal(await page.locator("#choice-title").textContent(), name);
    await page.locator("#choice-result").filter({ hasText: words }).waitFor();
    assert.deepEqual(await shown(page), { rows: [], laid: [] });
    assert.match(await page.locator("#announcement").textContent(), new RegExp(`^${name}\\. `), "it is said aloud");
    pictures.add(await picture(page));
  }
  assert.equal(pictures.size, 3, "each lays something else over the scene");
});

test("what is said of the lines is how they are drawn", async () => {
  const page = await imagine({ task: "00002:017" });
  await page.locator("#walkthrough-dots button:visible").last().click();
  // The model's paths are dashed everywhere.
  await page
    .locator("#choice-result")
    .filter({ hasText: /Dashed: what really happens/ })
    .waitFor();
});
