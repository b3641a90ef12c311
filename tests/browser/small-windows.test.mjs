// Small and low windows, and a finger that has been lifted: nothing lies over another, the page never scrolls
// past its content.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { known, openPuzzle, openShare, says, type } from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

for (const [width, height] of [
  [844, 390],
  [740, 360],
  [640, 400],
  [320, 568],
]) {
  test(`at ${width} x ${height} the transport stays in its column, and its time line can be dragged`, async () => {
    const page = await openPuzzle(session, { viewport: { width, height }, reducedMotion: true });
    await type(page, (await known()).missing);
    await page.locator("#run").click();
    await says(page, /^Not solved/);
    const [transport, area, side, time] = await Promise.all(
      [".transport", ".scene-area", ".side", "#time"].map((one) => page.locator(one).boundingBox()),
    );
    assert.ok(transport.x >= area.x && transport.x + transport.width <= area.x + area.width + 1, "within the area");
    for (const control of await page.locator(".transport :is(button, input, select, #clock):visible").all()) {
      const box = await control.boundingBox();
      assert.ok(
        box.x + box.width <= transport.x + transport.width + 1,
        `${await control.getAttribute("id")} sticks out`,
      );
      const over =
        box.x < side.x + side.width &&
        side.x < box.x + box.width &&
        box.y < side.y + side.height &&
        side.y < box.y + box.height;
      assert.ok(!over, `${await control.getAttribute("id")} lies over the panel`);
    }
    assert.ok(time.width >= 60, `the time line is ${time.width} px wide`);
    assert.match(await page.locator("#run").innerText(), /Replay/, "its button says what it does");
  });
}

for (const [width, height] of [
  [320, 256],
  [360, 400],
  [480, 320],
  [560, 500],
  [600, 500],
]) {
  test(`at ${width} x ${height} the panel is wide enough to be used, and can be reached`, async () => {
    const page = await openPuzzle(session, { viewport: { width, height } });
    const { width: panel } = await page.locator("#tabpanel-play").boundingBox();
    assert.ok(panel >= 240, `the panel is ${panel} px wide`);
    for (const id of ["scene", "run", "tab-make", "race-it", "radius"]) {
      const part = page.locator(`#${id}`);
      await part.scrollIntoViewIfNeeded();
      const box = await part.boundingBox();
      assert.ok(box.x >= -1 && box.x + box.width <= width + 1, `#${id}: ${JSON.stringify(box)}`);
      assert.ok(box.y >= -1 && box.y + box.height <= height + 1, `#${id}: ${JSON.stringify(box)}`);
    }
  });
}

for (const { width, height, locale } of [
  { width: 390, height: 664, locale: "en" },
  { width: 390, height: 664, locale: "de" },
  { width: 320, height: 568, locale: "de" },
  { width: 844, height: 390, locale: "en" },
  { width: 1024, height: 600, locale: "de" },
]) {
  test(`at ${width} x ${height}, with the model's guess, all can be reached after a miss, in the language ${locale}`, async () => {
    const viewport = { width, height };
    const page = await openPuzzle(session, { viewport, locale, reducedMotion: true, newcomer: true });
    await type(page, (await known()).missing);
    await page.locator("#run").click();
    await says(page, /^(Not solved|Nicht gelöst)/);
    await page.locator("#forecast-words:visible").waitFor({ timeout: 60_000 });
    for (const id of ["tab-imagine", "race-it", "next", "forecast-on", "tab-make"]) {
      const part = page.locator(`#${id}`);
      await part.scrollIntoViewIfNeeded();
      const box = await part.boundingBox();
      assert.ok(box && box.y >= -1 && box.y + box.height <= height + 1, `#${id}: ${JSON.stringify(box)}`);
      assert.ok(box.x >= -1 && box.x + box.width <= width + 1, `#${id}: ${JSON.stringify(box)}`);
    }
    const time = await page.locator("#time").boundingBox();
    assert.ok(time.width >= 44, `the time line is ${time.width} px wide`);
  });
}

test("what is longer than the window never scrolls the page away", async () => {
  const page = await openPuzzle(session, { viewport: { width: 640, height: 240 } });
  await page.locator("#difficulty").evaluate((element) => element.scrollIntoView());
  await page.locator("#watch").focus();
  await page.evaluate(() => document.scrollingElement?.scrollTo(0, 1000));
  assert.deepEqual(
    await page.evaluate(() => [
      document.scrollingElement?.scrollTop,
      document.body.scrollTop,
      document.querySelector("main")?.scrollTop,
    ]),
    [0, 0, 0],
  );
});

test("next stays under the pointer, whatever the picker says", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  const left = async () => (await page.locator("#next").boundingBox()).x;
  const before = await left();
  await type(page, (await known()).missing);
  await page.locator("#run").click();
  await page.locator("#task option:checked").filter({ hasText: "missed, 1 try" }).waitFor({ state: "attached" });
  assert.equal(await left(), before);
});

test("that the link is copied is said without moving anything, and goes by itself", async () => {
  const page = await openPuzzle(session, { permissions: ["clipboard-write"] });
  await page.clock.install();
  const top = (await page.locator("#scene").boundingBox()).y;
  await openShare(page);
  await page.locator("#copy").click();
  await page.locator("#notice").filter({ hasText: "copied" }).waitFor();
  assert.equal((await page.locator("#scene").boundingBox()).y, top);
  await page.clock.runFor(7000);
  assert.ok(await page.locator("#notice").isHidden());
});
