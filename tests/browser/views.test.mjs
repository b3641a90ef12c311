// What is seen at once on a small phone, and what axe says of the views of Play.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { axeFindsNothingInLightAndDark } from "./axe.mjs";
import { EASY, STILL, button, drop, known, modelIsThere, openPuzzle, place, scene, startPlayer } from "./player.mjs";

let session;
let balls;
before(async () => {
  session = await startPlayer();
  balls = await known();
});
after(() => session.stop());

/** With the browser's bars. */
const SMALL = { ...STILL, viewport: { width: 390, height: 664 }, isMobile: true, hasTouch: true };

test("on a small phone scene, large button and verdict are seen together, in either language", async () => {
  for (const [locale, lost] of [
    ["en-GB", "The model solves it with ball 1. Can you?"],
    ["de-DE", "Das Modell löst es mit Kugel 1. Und du?"],
  ]) {
    const page = await openPuzzle(session, `#task=${EASY}&ball=${balls.missing[0]}`, { ...SMALL, locale });
    await modelIsThere(page);
    await button(page, /^(Drop it|Fallen lassen)$/).click();
    const parts = [
      scene(page),
      page.locator("p:visible", { hasText: lost }),
      button(page, /^(Try again|Neuer Versuch)$/),
    ];
    for (const part of parts) {
      await part.first().waitFor();
      const { y, height } = await part.first().boundingBox();
      assert.ok(y >= 0 && y + height <= SMALL.viewport.height, `${locale}: ${part} from ${y} to ${y + height}`);
    }
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  }
});

test("on a small phone a button far below the scene brings it back into sight", async () => {
  const page = await openPuzzle(session, `#task=${EASY}&ball=${balls.missing[0]}`, SMALL);
  await modelIsThere(page);
  await button(page, "Drop it").click();
  const again = button(page, /Ball 1: show it again/);
  await again.evaluate((one) => scrollTo(0, one.getBoundingClientRect().bottom));
  assert.ok((await scene(page).boundingBox()).y < 0);
  await again.click();
  await page.waitForFunction((one) => one.getBoundingClientRect().top >= 0, await scene(page).elementHandle());
});

test("in a low window what plays a run again stays under the scene", async () => {
  const page = await openPuzzle(session, `#task=${EASY}`, { ...STILL, viewport: { width: 900, height: 560 } });
  await modelIsThere(page);
  await place(page, balls.missing[0]);
  await drop(page);
  const right = async (part) => part.boundingBox().then(({ x, width }) => x + width);
  assert.ok((await right(page.getByRole("combobox", { name: "Speed" }))) <= (await right(scene(page))) + 1);
  await page.setViewportSize({ width: 932, height: 370 });
  const { height } = await page.getByRole("tabpanel").locator("..").boundingBox();
  assert.ok(height > 200, `there is room for the panel: ${height}`);
});

test("axe finds nothing while one places, after a miss, in the menu, with the check, and in the presentation", async () => {
  for (const options of [STILL, SMALL]) {
    const page = await openPuzzle(session, `#task=${EASY}`, options);
    await modelIsThere(page);
    const look = (view) => axeFindsNothingInLightAndDark(page, view);
    await place(page, balls.invalid);
    await look("a ball that may not lie there");
    for (const ball of balls.missing.slice(0, 3)) {
      await place(page, ball);
      await drop(page);
    }
    await page.getByRole("checkbox", { name: "Show every place that works" }).check();
    await page.getByText(/A ball of this size works at/).waitFor();
    await look("missed, with the check");
    await button(page, "Menu").click();
    await look("the menu");
    await button(page, "Presentation").click();
    await look("the presentation");
  }
});

test("axe finds nothing in a puzzle within an article", async () => {
  const page = await session.open("", STILL);
  const body = `<!doctype html><html lang="en"><title>Article</title><script type="module" src="element.js"></script>
    <main><h1>Article</h1><pathlight-puzzle task="${EASY}"></pathlight-puzzle></main></html>`;
  await page.route("**/article", (route) => route.fulfill({ contentType: "text/html", body }));
  await page.goto(`${session.origin}/article`);
  await modelIsThere(page);
  await axeFindsNothingInLightAndDark(page, "element");
});
