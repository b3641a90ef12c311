// Predict first: the green object's path drawn by mouse, finger and keys, then run and measured beside the model.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import {
  attempts,
  ball,
  dragTo,
  known,
  openPanel,
  openPuzzle,
  pause,
  picture,
  says,
  spot,
  type,
} from "./page-actions.mjs";

let session;
before(async () => (session = await start({ sources: true })));
after(() => session.stop());

async function predict(options) {
  const page = await openPuzzle(session, { fragment: "&panel=predict", reducedMotion: true, ...options });
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor({ state: "attached" });
  return page;
}

/** Draws a line through points of the scene with the mouse. */
async function draw(page, points) {
  await dragTo(page, points);
  await page.mouse.up();
}

/** Where the green object is at first. */
function green(page) {
  return page.evaluate(async () => {
    const { Game } = await import("/pkg/pathlight.js");
    return [...new Game("00000:000").objectStart()];
  });
}

const VERDICT =
  /^(You were closer: \d+%, the model \d+%|The model was closer: \d+%, you \d+%|A draw: both were \d+% right)\.$/;

async function verdict(page) {
  await page.locator("#predict-words").filter({ hasText: VERDICT }).waitFor();
  const percentages = await page.locator("#predict-cards b").allTextContents();
  return percentages.map((percentage) => Number(percentage.match(/^(\d+)%$/)[1]));
}

test("a line is drawn with the mouse, places no ball, and is measured when it has run", async () => {
  const page = await predict();
  await says(page, /Draw the path/);
  assert.ok(await page.locator("#predict-watch").isDisabled(), "there is nothing to measure yet");
  const before = await picture(page);
  const [x, y] = await green(page);
  await draw(page, [
    [x, y],
    [x, 10],
  ]);
  await page
    .locator("#predict-words")
    .filter({ hasText: /^Your line ends at x \d+, y (9|10|11)\. Ready\? Run it\.$/ })
    .waitFor();
  assert.notEqual(await picture(page), before, "the line is in the scene");
  assert.doesNotMatch(page.url(), /ball=/);
  await page.locator("#predict-watch").click();
  const [straight] = await verdict(page);

  // A line far from the real path is worse.
  await draw(page, [
    [10, 250],
    [250, 250],
    [10, 240],
    [250, 240],
  ]);
  await says(page, /Draw the path/);
  await page.locator("#predict-watch").click();
  const [wild] = await verdict(page);
  assert.ok(wild < straight, `${wild}% is less than ${straight}%`);

  await page.locator("#predict-wipe").click();
  assert.equal(await page.locator("#predict-words").textContent(), "Nothing drawn yet.");
  assert.ok(await page.locator("#predict-result").isHidden());
});

test("with a ball the run is an attempt, and the model’s target path is measured", async () => {
  const page = await predict();
  const { solving } = await known();
  const [x, y] = await green(page);
  await draw(page, [
    [x, y],
    [x, 10],
  ]);
  assert.ok(await page.locator("#predict-run").isDisabled(), "there is no ball");
  await page.locator("#tab-play").click();
  await type(page, solving);
  await openPanel(page, "predict");
  await page.locator("#predict-run").click();
  await says(page, /^Solved!/);
  assert.equal((await verdict(page)).length, 2);
  assert.equal(await attempts(page), 1);
});

test("a finger draws, and nothing scrolls", async () => {
  const page = await predict({ hasTouch: true, isMobile: true, viewport: { width: 390, height: 844 } });
  const client = await page.context().newCDPSession(page);
  const touch = async (type, point) => {
    const points = [];
    if (point) {
      const [x, y] = await spot(page, point[0], point[1]);
      points.push({ x, y });
    }
    await client.send("Input.dispatchTouchEvent", { type, touchPoints: points });
  };
  await touch("touchStart", [40, 200]);
  for (const y of [170, 140, 110, 80]) await touch("touchMove", [60, y]);
  // The finger rests before it lifts: the browser takes a tap after a quick swipe for the end of that swipe.
  await pause(page, 200);
  await touch("touchMove", [60, 80]);
  await touch("touchEnd");
  await page
    .locator("#predict-words")
    .filter({ hasText: /^Your line ends at x (59|60|61), y (79|80|81)\. Ready\? Run it\.$/ })
    .waitFor();
  assert.equal(await page.evaluate(() => scrollY), 0);
  await page.locator("#predict-watch").tap();
  await verdict(page);
});

for (const height of [844, 640])
  test(`on a phone ${height} px high who was closer is in sight after the run`, async () => {
    const page = await predict({ hasTouch: true, isMobile: true, viewport: { width: 390, height } });
    await page.locator("#scene").press("Shift+ArrowDown");
    await page.locator("#predict-watch").tap();
    const shares = await verdict(page);
    const panel = await page.locator("#tabpanel-imagine").boundingBox();
    const seen = async (part) => {
      const box = await part.boundingBox();
      return panel && box && box.y >= panel.y && box.y + box.height <= panel.y + panel.height;
    };
    assert.ok(await seen(page.locator("#predict-words")), "the sentence");
    if (height < 800) return;
    for (const card of await page.locator("#predict-cards li").all())
      assert.ok(await seen(card), await card.innerText());
    const [you, model] = shares;
    assert.equal(
      await page.locator("#predict-cards .closer").innerText(),
      you > model ? `${you}% You` : `${model}% The model`,
    );
  });

test("keys draw from the green object on, and take back", async () => {
  const page = await predict();
  const [x, y] = await green(page);
  await page.locator("#scene").focus();
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Shift+ArrowDown");
  await page.keyboard.press("Backspace");
  await page
    .locator("#predict-words")
    .filter({ hasText: `Your line ends at x ${Math.round(x - 6)}, y ${Math.round(y)}.` })
    .waitFor();
  assert.deepEqual(await ball(page), [0, 0, 0], "no ball has come");
  await page.locator("#predict-watch").press("Enter");
  await verdict(page);
});

test("on another panel the scene places the ball again", async () => {
  const page = await predict();
  await page.locator("#tab-play").click();
  await page.mouse.click(...(await spot(page, 100, 240)));
  assert.deepEqual((await ball(page)).slice(0, 2), [100, 240]);
});

test("a line that is wiped while the pen is down begins again where the pen goes on", async () => {
  const page = await predict();
  await dragTo(page, [[40, 200]]);
  await page.keyboard.press("Backspace");
  assert.equal(await page.locator("#predict-words").textContent(), "Nothing drawn yet.");
  await page.mouse.move(...(await spot(page, 80, 150)), { steps: 5 });
  await page.mouse.up();
  await page
    .locator("#predict-words")
    .filter({ hasText: /^Your line ends at x (79|80|81), y (149|150|151)\. Ready\? Run it\.$/ })
    .waitFor();
  assert.ok(await page.locator("#notice").isHidden());
});

test("maps that are switched on do not tell the answer here", async () => {
  const page = await predict();
  const bare = await picture(page);
  await page.goto(`${session.origin}/#task=00000:000&panel=predict&layers=base,target`);
  await pause(page, 300);
  assert.equal(await picture(page), bare);
  await page.locator("#tab-imagine").click();
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
  assert.notEqual(await picture(page), bare, "they lie over the scene where they are switched on");
  await page.locator("#walkthrough-next").click();
  await page.waitForFunction(() => /step=/.test(location.hash));
  await openPanel(page, "predict");
  await pause(page, 100);
  assert.equal(await picture(page), bare, "nor does the story");
});

test("the big button runs the scene for a prediction without a ball, once there is one", async () => {
  const page = await predict();
  const run = page.locator("#run");
  assert.match(await run.textContent(), /Run/);
  await run.click();
  await says(page, /Draw your prediction first/);
  await page.locator("#scene").press("Shift+ArrowDown");
  await run.click();
  await verdict(page);
});
