// Motion that helps: a loupe beside the finger that drags the ball, a spark where the ball first touches the green
// object, a slow moment at the touch that decides, and no waiting where nothing moves.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { Game, initSync } from "../../www/pkg/pathlight.js";
import { start } from "./harness.mjs";
import { EASY, mapsImagined, openPuzzle, palette, pixels, says, type } from "./page-actions.mjs";

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

let session;
/** The moments of a ball that falls on the green object and misses. */
let moments;
/** @type {import("./page-actions.mjs").Ball} */
const BALL = [90, 220, 8];
before(async () => {
  session = await start();
  initSync({ module: await readFile(new URL("../../www/pkg/pathlight_bg.wasm", import.meta.url)) });
  const game = new Game(EASY);
  game.attempt(...BALL);
  moments = game.moments();
});
after(() => session.stop());

test("a loupe shows what the finger covers, inside of the scene, until the finger lets go", async () => {
  const page = await openPuzzle(session, PHONE);
  await mapsImagined(page);
  const box = await page.locator("#scene").boundingBox();
  const client = await page.context().newCDPSession(page);
  const touch = (name, x, y) =>
    client.send("Input.dispatchTouchEvent", {
      type: name,
      touchPoints: name === "touchEnd" ? [] : [{ x: box.x + x * box.width, y: box.y + y * box.height }],
    });
  const loupe = page.locator("#loupe");
  assert.ok(await loupe.isHidden());
  await touch("touchStart", 0.5, 0.5);
  for (const [x, y] of [
    [0.52, 0.4],
    [0.97, 0.03],
    [0.02, 0.97],
  ]) {
    await touch("touchMove", x, y);
    await loupe.waitFor();
    const place = await loupe.boundingBox();
    assert.ok(place.x >= box.x - 1 && place.x + place.width <= box.x + box.width + 1, `at ${x}, ${y}`);
    assert.ok(place.y >= box.y - 1 && place.y + place.height <= box.y + box.height + 1, `at ${x}, ${y}`);
    const [middle, across] = [place.x + place.width / 2, place.y + place.height / 2];
    const distance = Math.hypot(middle - box.x - x * box.width, across - box.y - y * box.height);
    assert.ok(distance > 40, `${distance} px from the finger`);
  }
  await touch("touchMove", 0.5, 0.4);
  assert.ok((await pixels(page, palette.red, "#loupe")) > 500, "the ball is in it");
  await touch("touchEnd");
  await loupe.waitFor({ state: "hidden" });
});

test("the mouse needs no loupe", async () => {
  const page = await openPuzzle(session);
  const box = await page.locator("#scene").boundingBox();
  await page.mouse.move(box.x + 100, box.y + 60);
  await page.mouse.down();
  await page.mouse.move(box.x + 140, box.y + 80);
  assert.ok(await page.locator("#loupe").isHidden());
  await page.mouse.up();
});

/** The page at a step of that run, paused. */
async function pausedAt(step, options) {
  const page = await openPuzzle(session, options);
  await type(page, BALL);
  await page.locator("#run").click();
  await page.locator("#time").evaluate((/** @type {HTMLInputElement} */ time, value) => {
    time.value = String(value);
    time.dispatchEvent(new Event("input"));
  }, step);
  return page;
}

test("a spark marks the first contact of the ball with the green object, but not with reduced motion", async () => {
  const { step } = moments.contact;
  const page = await pausedAt(step + 2);
  assert.ok((await pixels(page, palette.ring)) > 20);
  const still = await pausedAt(step + 2, { reducedMotion: true });
  assert.equal(await pixels(still, palette.ring), 0);
});

test("where nothing moves, a run can be skipped to its end", async () => {
  const [[first, last]] = moments.quiet;
  assert.equal(last, 1000);
  const page = await pausedAt(first - 10);
  const skip = page.locator("#skip-quiet");
  assert.ok(await skip.isHidden());
  // At a speed that was chosen, quiet stretches are not hurried through.
  await page.locator("#speed").selectOption("0.25");
  await page.locator("#run").click();
  await skip.waitFor();
  await skip.press("Enter");
  await says(page, /^Not solved/);
  assert.ok(await skip.isHidden());
  assert.ok(await page.locator("#scene:focus").isVisible(), "the focus is not lost");
});

test("two balls that run over each other are named", async () => {
  const page = await session.open("", { reducedMotion: "reduce" });
  await page.addInitScript(() => {
    const written = (globalThis.written = new Set());
    const { fillText } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.fillText = function (text, ...rest) {
      written.add(text);
      return fillText.call(this, text, ...rest);
    };
  });
  await page.goto(`${session.origin}/#task=${EASY}`);
  await page.locator("#puzzle [inert]").first().waitFor({ state: "detached" });
  await type(page, BALL);
  await page.locator("#run").click();
  await says(page, /^Not solved/);
  await page.locator("#race-it:enabled").click();
  await page.waitForFunction(() => ["You", "The model"].every((name) => globalThis.written.has(name)));
});
