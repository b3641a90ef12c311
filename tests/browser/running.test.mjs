// Running a ball: pause, step, scrub, speed, reset, and the result in words; a known solution is solved.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import {
  attempts,
  known,
  openPuzzle,
  palette,
  pause,
  picture,
  pixels,
  says,
  type,
  waitForValue,
} from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

const seconds = async (page) => parseFloat(await page.locator("#clock").textContent());

test('a solving ball runs to "Solved!", with the ring while the goal holds', async () => {
  const page = await openPuzzle(session);
  const { solving } = await known();
  await type(page, solving);
  await says(page, /Ready/);
  await page.locator("#speed").selectOption("0.25");
  await page.locator("#run").click();
  await says(page, /attempt 1 is running/);
  await page.locator("#speed").selectOption("4");
  const words = await says(page, /^Solved! Your attempt 1: solved after \d+\.\d s\.$/);
  // The clock has stopped at what the words say.
  assert.equal(await seconds(page), parseFloat(words.match(/after ([\d.]+)/)[1]));
  assert.ok((await pixels(page, palette.ring)) > 30, "the ring is full at the end");
  assert.match(await page.locator("#play-count").textContent(), /solved on attempt 1/);
});

test("the ring lies round an object on the floor, whose edge cuts it off", async () => {
  const task = "00000:088";
  const page = await openPuzzle(session, { task, reducedMotion: true });
  await type(page, (await known(task)).solving);
  await page.locator("#run").click();
  await says(page, /^Solved!/);
  const { ring } = palette;
  assert.ok((await pixels(page, ring)) > 30);
  const atTheEdge = await page.locator("#scene").evaluate((canvas, ring) => {
    const expected = [1, 3, 5].map((at) => parseInt(ring.slice(at, at + 2), 16));
    const { data } = canvas.getContext("2d").getImageData(0, canvas.height - 2, canvas.width, 1);
    return Array.from({ length: canvas.width }, (_, x) => x).filter((x) =>
      expected.every((value, channel) => Math.abs(data[4 * x + channel] - value) < 40),
    ).length;
  }, ring);
  assert.ok(atTheEdge > 0);
});

test("a miss says why, and joins the list", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  const { missing } = await known();
  await type(page, missing);
  await page.locator("#run").click();
  await says(
    page,
    /^Not solved\. Your attempt 1: (missed by [\d.]+ px, at [\d.]+ s|never got closer|touched for .+, then lost|touching for .+ when time ran out)(; everything lies still)?\.$/,
  );
  assert.equal(await attempts(page), 1);
});

test("pause, step, scrub and go on", async () => {
  const page = await openPuzzle(session);
  const { missing } = await known();
  await type(page, missing);
  await page.locator("#run").click();
  await waitForValue(page, "#time", (value) => Number(value) > 20);
  await page.locator("#run").click();
  const time = page.locator("#time");
  const paused = Number(await time.inputValue());
  const scene = await picture(page);
  await pause(page, 300);
  assert.equal(Number(await time.inputValue()), paused, "paused stays paused");
  await page.locator("#step").click();
  assert.equal(Number(await time.inputValue()), paused + 1);
  await time.fill("0");
  assert.notEqual(await picture(page), scene);
  await page.locator("#run").click();
  await waitForValue(page, "#time", (value) => Number(value) > 5);
  await page.locator("#reset").click();
  assert.equal(await seconds(page), 0);
  await says(page, /Ready/);
});

test("a quarter of the speed is slower than four times", async () => {
  const page = await openPuzzle(session);
  const { missing } = await known();
  await type(page, missing);
  /** Steps in each second of the page's clock. */
  const rate = async (speed) => {
    await page.locator("#speed").selectOption(speed);
    await page.locator("#run").click();
    const steps = await page.locator("#time").evaluate(async (/** @type {HTMLInputElement} */ time) => {
      const [step, begin] = [Number(time.value), performance.now()];
      await new Promise((resolve) => setTimeout(resolve, 700));
      return (1000 * (Number(time.value) - step)) / (performance.now() - begin);
    });
    await page.locator("#reset").click();
    return steps;
  };
  const [slow, fast] = [await rate("0.25"), await rate("4")];
  assert.ok(slow > 0 && fast > 4 * slow, `${slow} and ${fast} steps a second`);
});

test("an attempt is replayed from the list and does not count again", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  const { missing, solving } = await known();
  for (const one of [missing, solving]) {
    await type(page, one);
    await page.locator("#run").click();
    await says(page, /attempt/);
    await page.locator("#reset").click();
  }
  await page.locator("#play-attempts [data-act=replay]").first().click();
  await says(page, /^Not solved\. Your attempt 1/);
  assert.equal(await attempts(page), 2);
  assert.equal(
    await page.locator("#play-attempts [aria-current]").textContent(),
    await page.locator("#play-attempts [data-act=replay]").first().textContent(),
  );
  // The very same ball is the same attempt.
  await page.locator("#reset").click();
  await page.locator("#run").click();
  await says(page, /attempt 1/);
  assert.equal(await attempts(page), 2);
});

test("the scene runs without a ball too, and that is no attempt", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  await page.locator("#watch").click();
  await says(page, /without a ball/);
  assert.ok(Number(await page.locator("#time").inputValue()) > 0);
  assert.equal(await attempts(page), 0);
});

test("the ring tells how long the goal has held, of the three seconds", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  const { solving } = await known();
  const goalMeter = page.locator("#goal-meter");
  assert.ok(await goalMeter.isHidden());
  await type(page, solving);
  await page.locator("#run").click();
  await says(page, /^Solved!/);
  assert.equal(await goalMeter.textContent().then((text) => text.trim()), "3.0 of 3 s");
  assert.equal(await goalMeter.getAttribute("aria-valuetext"), "3.0 of 3 seconds");
  // Half a second before the end it had held for two and a half; a second and more before it began, not at all.
  const last = Number(await page.locator("#time").getAttribute("max"));
  await page.locator("#time").fill(String(last - 30));
  assert.equal(await goalMeter.getAttribute("aria-valuenow"), "2.5");
  await page.locator("#time").fill("0");
  assert.equal(await goalMeter.getAttribute("aria-valuenow"), "0.0");
});

test("with reduced motion a run shows its end and its path at once", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  const { missing } = await known();
  await type(page, missing);
  const status = await page.locator("#run").evaluate((/** @type {HTMLButtonElement} */ run) => {
    run.click();
    return /** @type {ShadowRoot} */ (run.getRootNode()).getElementById("status")?.textContent ?? "";
  });
  assert.match(status, /^Not solved/, "at once");
  const time = page.locator("#time");
  assert.equal(await time.inputValue(), await time.getAttribute("max"));
  const ended = await pixels(page, palette.green);
  await time.fill("0");
  assert.ok(ended > (await pixels(page, palette.green)) + 20, "the path of the green object is drawn");
});

test("the path is drawn as it goes", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  const { missing } = await known();
  await type(page, missing);
  await page.locator("#run").click();
  const red = palette.red;
  const lengths = [];
  const last = Number(await page.locator("#time").getAttribute("max"));
  for (const fraction of [0, 0.3, 0.6]) {
    await page.locator("#time").fill(String(Math.round(last * fraction)));
    lengths.push(await pixels(page, red));
  }
  assert.ok(lengths[0] < lengths[1] && lengths[1] < lengths[2], lengths.join());
});
