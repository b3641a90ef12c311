// The maps: imagined in the worker, each with its legend, laid over the scene when asked.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { inMore, openImagined, openPanel, openPuzzle, picture } from "./page-actions.mjs";

const MAPS = ["base", "target", "action", "placement", "success"];
const NAMES = [
  "If you do nothing",
  "Where green should go",
  "What red must do",
  "Where to start",
  "Where it would work",
];

let session;
before(async () => (session = await start()));
after(() => session.stop());

const imagine = (options) => openImagined(session, options);
/** With no map over the scene. */
const bareScene = () => imagine({ fragment: "&panel=imagine&layers=" });
const laid = (page) =>
  page.locator("#maps input:checked").evaluateAll((boxes) => boxes.map((box) => box.closest("li").dataset.map));

test("five different maps, each with a sentence, a summary and a legend", async () => {
  const page = await imagine();
  const seen = new Set();
  for (const map of MAPS) {
    const row = page.locator(`[data-map=${map}]`);
    assert.match(await row.locator(".meaning").textContent(), /^(Where|A path) .+\.$/);
    assert.match(await row.locator(".map canvas[role=img]").getAttribute("aria-label"), /: most sure [a-z ]+/);
    const peak = Number(await row.locator(".scale span").last().textContent());
    assert.ok(peak > 0 && peak <= 1, `${map}: ${peak}`);
    seen.add(await picture(page, `[data-map=${map}] .map canvas[role=img]`));
    seen.add(await picture(page, `[data-map=${map}] .legend`));
  }
  assert.equal(seen.size, 10, "no two maps and no two legends are alike");
});

test("opening it lays two maps over the scene", async () => {
  const page = await imagine();
  assert.deepEqual(await laid(page), ["target", "action"]);
  assert.notEqual(await picture(page), await picture(await bareScene()));
});

test("a small map is its switch, and a third replaces the oldest", async () => {
  const page = await imagine();
  const map = (name) => page.locator(`[data-map=${name}] .map`);
  await map("base").click();
  assert.deepEqual(await laid(page), ["base", "action"]);
  await map("placement").click();
  assert.deepEqual(await laid(page), ["base", "placement"]);
  await page.locator("[data-map=success] input").check();
  assert.deepEqual(await laid(page), ["placement", "success"], "the order is that in which they were switched on");
  await map("placement").click();
  assert.deepEqual(await laid(page), ["success"]);
  await page.waitForFunction(() => location.hash.endsWith("layers=success"));
});

test("a layer lies over the scene while it is on, as strongly as its opacity", async () => {
  const page = await bareScene();
  const bare = await picture(page);
  for (const map of MAPS) {
    const box = page.locator(`[data-map=${map}] input`);
    await box.check();
    assert.notEqual(await picture(page), bare, `${map} shows`);
    await box.uncheck();
    assert.equal(await picture(page), bare, `${map} is gone`);
  }
  await page.locator("[data-map=target] input").check();
  const strong = await picture(page);
  await inMore(page, () => page.locator("#opacity").fill("0.3"));
  assert.notEqual(await picture(page), strong);
  await page.waitForFunction(() => /layers=target/.test(location.hash) && /opacity=0.3/.test(location.hash));
});

test("another puzzle is imagined afresh", async () => {
  const page = await imagine();
  const before = await picture(page, "[data-map=base] .map canvas[role=img]");
  await page.locator("#next").click();
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
  assert.notEqual(await picture(page, "[data-map=base] .map canvas[role=img]"), before);
});

test("maps that are switched on stay over the scene while a ball is placed, until they are taken off", async () => {
  const page = await bareScene();
  const bare = await picture(page);
  await page.locator("[data-map=target] input").check();
  await page.locator("#tab-play").click();
  const one = await picture(page);
  assert.notEqual(one, bare);
  await openPanel(page, "predict");
  assert.equal(await picture(page), bare, "they would tell the answer");
  await openPanel(page, "compare");
  assert.equal(await picture(page), one);
  assert.deepEqual(await page.locator("#laid li:visible").allInnerTexts(), ["Where green should go"]);
  await page.locator("#laid-off").click();
  assert.equal(await picture(page), bare);
  assert.ok(await page.locator("#laid").isHidden());
  await page.locator("#tab-imagine").click();
  await page.locator("#walkthrough-next").click();
  await page.locator("#tab-play").click();
  assert.equal(await picture(page), bare, "the map of a step of the walkthrough stays in its panel");
});

test("in Play a legend has the colour of each map and the dashes of its outline, light and dark", async () => {
  const page = await openPuzzle(session, { fragment: `&layers=${MAPS}` });
  assert.deepEqual(await page.locator("#laid li:visible").allInnerTexts(), NAMES);
  const marks = new Set();
  for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
    await page.emulateMedia({ colorScheme });
    for (const map of MAPS) marks.add(await picture(page, `#laid [data-of=${map}] canvas`));
  }
  assert.equal(marks.size, 2 * MAPS.length, "no two marks are alike");
});

test("a link may lay more maps there: two are shaded, and the others outlined", async () => {
  const pictures = [];
  for (const layers of ["base", "base,target", "base,target,action"]) {
    const page = await imagine({ fragment: `&panel=imagine&layers=${layers}` });
    assert.equal(await page.locator("#outlines-note").isVisible(), layers.endsWith("action"));
    pictures.push(await picture(page));
  }
  // A shade covers a good part of the scene, an outline little of it.
  const page = await session.open("/");
  const changed = await page.evaluate(async (addresses) => {
    const read = async (address) => {
      const image = new Image();
      image.src = address;
      await image.decode();
      const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
      if (!context) throw new Error("no 2D canvas");
      context.drawImage(image, 0, 0);
      return new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer);
    };
    const [one, two, three] = await Promise.all(addresses.map(read));
    const share = (before, after) =>
      before.reduce((sum, value, index) => sum + Number(value !== after[index]), 0) / before.length;
    return [share(one, two), share(two, three)];
  }, pictures);
  assert.ok(changed[0] > 0.1 && changed[1] > 0 && changed[1] < 0.06, `${changed}`);
});
