// The page on a phone: everything fits, a finger places and drags, and a drag in the scene scrolls nothing.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { ball, known, mapsImagined, openPanel, openPuzzle, says, spot } from "./page-actions.mjs";

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 3 };

let session;
before(async () => (session = await start()));
after(() => session.stop());

/** Drags a finger from the first point over the others. */
async function drag(page, points) {
  const client = await page.context().newCDPSession(page);
  const send = (type, touchPoints) => client.send("Input.dispatchTouchEvent", { type, touchPoints });
  const [from, ...way] = await Promise.all(points.map(async ([x, y]) => spot(page, x, y)));
  const touch = ([x, y]) => [{ x, y }];
  await send("touchStart", touch(from));
  for (const point of way) await send("touchMove", touch(point));
  await send("touchEnd", []);
}

test("a tap places, a finger drags, nothing scrolls", async () => {
  const page = await openPuzzle(session, { ...PHONE, reducedMotion: true });
  await mapsImagined(page);
  await page.touchscreen.tap(...(await spot(page, 128, 220)));
  assert.deepEqual((await ball(page)).slice(0, 2), [128, 220]);
  await drag(page, [
    [130, 222],
    [120, 210],
    [100, 190],
    [90, 150],
  ]);
  const [x, y] = await ball(page);
  assert.ok(Math.abs(x - 88) <= 1 && Math.abs(y - 148) <= 1, `dragged to ${x}, ${y}`);
  const scrolled = await page.locator("#play").evaluate((panel) => [scrollX, scrollY, panel.scrollTop]);
  assert.deepEqual(scrolled, [0, 0, 0]);
});

test("a finger need not hit a small ball, nor its knob, exactly", async () => {
  const page = await openPuzzle(session, { ...PHONE, fragment: "&ball=128,220,4" });
  await mapsImagined(page);
  // One px of the scene is about 1.5 px of the screen, so this is 18 px of the screen beside the ball.
  await drag(page, [
    [116, 220],
    [106, 220],
    [96, 210],
  ]);
  assert.deepEqual(await ball(page), [108, 210, 4], "dragged, and not placed anew under the finger");
  await drag(page, [
    [118, 210],
    [124, 210],
    [130, 210],
  ]);
  const [x, y, r] = await ball(page);
  assert.deepEqual([x, y], [108, 210]);
  assert.ok(r > 12, `the knob was pulled to radius ${r}`);
});

test("a solving ball is tapped, run and solved", async () => {
  const page = await openPuzzle(session, { ...PHONE, reducedMotion: true });
  const {
    solving: [x, y, r],
  } = await known();
  await page.touchscreen.tap(...(await spot(page, x, y)));
  await page.locator("#more-button").tap();
  await page.locator("#ball-r").fill(String(r));
  await page.locator("#ball-r").press("Tab");
  await page.keyboard.press("Escape");
  assert.deepEqual(await ball(page), [x, y, r]);
  await page.locator("#run").tap();
  await says(page, /^Solved!/);
});

for (const [width, height] of [
  [390, 844],
  [360, 640],
  [844, 390],
  [640, 400],
]) {
  test(`at ${width} x ${height} nothing sticks out and the scene stays in sight`, async () => {
    const page = await openPuzzle(session, { ...PHONE, viewport: { width, height } });
    for (const panel of ["play", "imagine", "compare", "predict", "map"]) {
      await openPanel(page, panel);
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= width, `${panel}: ${wide} px wide`);
      const box = await page.locator("#scene").boundingBox();
      assert.ok(box.x >= 0 && box.x + box.width <= width && box.y + box.height <= height, panel);
      // Where the panel has to be scrolled to, the scene moves up.
      const bottomOfHeader = await page.locator("header").evaluate((header) => header.getBoundingClientRect().bottom);
      assert.ok(box.y + box.height - bottomOfHeader > box.height / 2, `${panel}: the scene is at ${box.y}`);
      assert.ok(Math.abs(box.width - box.height) < 2, "the scene is square");
      assert.ok(box.width > Math.min(width, height) / 2, `the scene is large: ${box.width} px`);
      for (const button of await page.locator("button:visible, select:visible, #time").all()) {
        const size = await button.boundingBox();
        assert.ok(
          size.width >= 24 && size.height >= 24,
          `${await button.textContent()} is ${size.width} x ${size.height}`,
        );
        assert.ok(size.x >= 0 && size.x + size.width <= width, `${panel}: ${await button.textContent()} sticks out`);
      }
    }
  });
}

for (const locale of ["en", "de"])
  test(`at 360 x 640 no name of a part runs into the next, in the language ${locale}`, async () => {
    const page = await openPuzzle(session, { ...PHONE, viewport: { width: 360, height: 640 }, locale });
    for (const panel of ["imagine", "predict", "map"]) {
      await openPanel(page, panel);
      const cut = await page.locator(".parts button:visible").evaluateAll((buttons) =>
        buttons
          .filter((button) => {
            const range = document.createRange();
            range.selectNodeContents(button);
            return range.getBoundingClientRect().width > button.clientWidth - 8;
          })
          .map((button) => button.id),
      );
      assert.deepEqual(cut, [], panel);
    }
  });

test("the scene is as sharp as the screen", async () => {
  const page = await openPuzzle(session, PHONE);
  const [pixels, css] = await page.locator("#scene").evaluate((canvas) => [canvas.width, canvas.clientWidth]);
  assert.ok(Math.abs(pixels - css * 3) <= 3, `${pixels} pixels for ${css} CSS px`);
});

test("what a finger hits is 44 px large: the dots of the story, the picker, the cells of the results", async () => {
  const page = await openPuzzle(session, { ...PHONE, reducedMotion: true });
  const isLarge = async (selector) => {
    for (const target of await page.locator(selector).all()) {
      const { width, height } = await target.boundingBox();
      assert.ok(width >= 44 && height >= 44, `${selector}: ${width} x ${height}`);
    }
  };
  await openPanel(page, "imagine");
  await page.locator("#walkthrough-dots button").nth(5).waitFor();
  await isLarge("#walkthrough-dots button:visible");
  await isLarge("#task");
  await page.locator("#home").tap();
  await page.locator("#results-link").tap();
  await page.locator("#results-templates a").first().waitFor();
  await isLarge("#results-templates li:first-child a");
});
