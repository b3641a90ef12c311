// The presentation: the scene and one sentence in large type, and the story in it at the viewer's pace, by buttons,
// keys, a clicker and touch; and the history, which leads back through tabs and steps.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { axeFindsNothing } from "./axe.mjs";
import { start } from "./harness.mjs";
import { EASY, ball, openPanel, openPuzzle, picture, says, spot, type } from "./page-actions.mjs";

const STEPS = [
  "If you do nothing",
  "Where green should go",
  "What red must do",
  "Where to start",
  "Forty futures",
  "Run and compare",
];

let session;
before(async () => (session = await start()));
after(() => session.stop());

const title = (page) => page.locator("#caption-title").textContent();

async function openPresentation(options = {}) {
  const { fragment = "", ...rest } = options;
  const page = await openPuzzle(session, { fragment: `&view=presentation${fragment}`, ...rest });
  await page.locator("#presentation:visible").waitFor();
  return page;
}

/** Waits until the maps are there: the story says what they show. */
const imagined = (page) =>
  page.locator("#imagined-in").filter({ hasText: "Imagined in" }).waitFor({ state: "attached" });

test("a clicker leads through the story, which ends with the ball run and imagined laid against real", async () => {
  const page = await openPresentation({ reducedMotion: true });
  await imagined(page);
  assert.match(await page.locator("#caption").textContent(), /^Get the green .* for 3 seconds\.$/);
  assert.ok(await page.locator("#scene-label").isHidden());
  const pictures = new Set([await picture(page)]);
  for (const [index, name] of STEPS.entries()) {
    await page.keyboard.press("PageDown");
    assert.equal(await title(page), name);
    assert.equal(await page.locator("#scene-label").textContent(), name, "the scene says what lies over it");
    await page.locator("#caption-step", { hasText: `${index + 1} of ${STEPS.length}` }).waitFor();
    await page
      .locator("#caption-result")
      .filter({ hasText: /\S.*\.$/ })
      .waitFor();
    await page.locator("#caption-result").filter({ hasText: "is choosing" }).waitFor({ state: "detached" });
    pictures.add(await picture(page));
  }
  assert.equal(pictures.size, STEPS.length + 1);
  await page
    .locator("#caption-result")
    .filter({
      hasText:
        /^The model’s guess was: .+ \(.+%\)\. (Solved|It did not work\.) .+ Its path for green was \d+ px off, on average\.$/,
    })
    .waitFor();
  await page.keyboard.press("PageDown");
  assert.equal(await title(page), STEPS.at(-1), "there is no more");
  await page.keyboard.press("PageUp");
  await page.keyboard.press("ArrowLeft");
  assert.equal(await title(page), "Where to start");
  await says(page, /place the red ball/);
  assert.equal(await page.locator("#model-attempts li").count(), 0, "looking is no attempt");
});

test("it plays by itself to its end, and waits for the ball", async () => {
  const page = await openPresentation({ fragment: "&step=imagined" });
  await imagined(page);
  await page.locator("#caption-result").filter({ hasText: "It considered" }).waitFor();
  await page.locator("#caption-play").click();
  assert.equal(await title(page), "Run and compare");
  await page.locator("#caption-play-label", { hasText: "Play" }).waitFor();
  await page.locator("#caption-result").filter({ hasText: "Its path for green was" }).waitFor({ timeout: 40_000 });
});

test("the buttons of the story stay where they are, and no edge cuts off their focus", async () => {
  for (const viewport of [
    { width: 1280, height: 800 },
    { width: 390, height: 844 },
  ]) {
    const page = await openPresentation({ viewport });
    await imagined(page);
    const next = page.locator("#caption-next");
    const place = await next.boundingBox();
    assert.ok(place);
    for (const name of STEPS) {
      await page.keyboard.press("PageDown");
      await page.locator("#caption-title", { hasText: name }).waitFor();
      assert.deepEqual(await next.boundingBox(), place, name);
    }
    const around = await page.locator("#presentation").boundingBox();
    const ring = await next.evaluate((button) => {
      const { outlineWidth, outlineOffset } = getComputedStyle(button);
      return parseFloat(outlineWidth) + parseFloat(outlineOffset);
    });
    assert.ok(around && place.x - ring >= around.x, `the ring of ${ring} px begins at ${place.x}`);
    assert.ok(around && place.y + place.height + ring <= around.y + around.height);
  }
});

test("Escape in the middle of the story leaves for its panel, and the story goes on", async () => {
  const page = await openPresentation({ fragment: "&step=placement" });
  await page.keyboard.press("Escape");
  await page.locator("#imagine:visible").waitFor();
  await page.locator("#walkthrough-step", { hasText: "Step 4" }).waitFor({ state: "attached" });
});

test("by touch, on a phone", async () => {
  const page = await openPresentation({ hasTouch: true, isMobile: true, viewport: { width: 390, height: 844 } });
  await imagined(page);
  await page.locator("#caption-next").tap();
  assert.equal(await title(page), "If you do nothing");
  await page.locator("#caption-back").tap();
  assert.match(await page.locator("#caption").textContent(), /^Get the green/i);
  await page.touchscreen.tap(...(await spot(page, 100, 240)));
  await says(page, /Ready|Not here/);
});

test("a ball that is placed in the middle of the run ends the story", async () => {
  const page = await openPresentation({ fragment: "&step=run" });
  await page.locator("#caption-result").filter({ hasText: "Dotted: what" }).waitFor();
  await says(page, /The model’s ball 1 is running/);
  await page.mouse.click(...(await spot(page, 30, 240)));
  await page
    .locator("#caption")
    .filter({ hasText: /^Get the green/i })
    .waitFor();
  await says(page, /Ready|Not here/);
});

test("a key and a button of the page lead there and back, and the link says it", async () => {
  const page = await openPuzzle(session, { fragment: "&panel=compare" });
  await page.locator("#presentation-button").click();
  await page.locator("#presentation:visible").waitFor();
  for (const hidden of ["header", "#tab-play", "#compare", "#more-button", "#goal"])
    assert.ok(await page.locator(hidden).isHidden(), hidden);
  await page.waitForFunction(() => /view=presentation/.test(location.hash));
  await page.keyboard.press("Escape");
  await page.locator("#compare:visible").waitFor();
  await page.waitForFunction(() => !/view=/.test(location.hash));
  await page.locator("#scene").press("v");
  await page.locator("#presentation:visible").waitFor();
  await page.locator("#presentation-leave").click();
  await page.locator("#compare:visible").waitFor();
});

test("the sentence is as large as a projector asks for, and nothing scrolls sideways", async () => {
  for (const [width, height, least] of [
    [1920, 1080, 40],
    [1280, 800, 24],
    [390, 844, 18],
    [320, 568, 16],
    [844, 390, 16],
    [2560, 1440, 40],
  ]) {
    const page = await openPresentation({ viewport: { width, height }, fragment: "&step=base" });
    await imagined(page);
    const size = await page.locator("#caption").evaluate((element) => parseFloat(getComputedStyle(element).fontSize));
    assert.ok(size >= least, `${width} x ${height}: ${size} px`);
    const beyond = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(beyond <= 0, `${width} x ${height}: ${beyond} px beyond`);
    const box = await page.locator("#caption-next").boundingBox();
    assert.ok(
      box && box.y + box.height <= height && box.x + box.width <= width,
      `${width} x ${height}: the buttons are in sight`,
    );
    await page.context().close();
  }
});

test("a link that hides what is imagined shows the goal alone", async () => {
  const page = await openPresentation({ fragment: "&step=base&hide=imagine" });
  assert.match(await page.locator("#caption").textContent(), /^Get the green/i);
  assert.ok(await page.locator("#caption-next").isHidden());
  await page.keyboard.press("PageDown");
  assert.match(await page.locator("#caption").textContent(), /^Get the green/i);
});

for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
  test(`axe finds nothing, ${colorScheme}`, async () => {
    for (const viewport of [
      { width: 1920, height: 1080 },
      { width: 390, height: 844 },
    ]) {
      const page = await openPresentation({ viewport, colorScheme, reducedMotion: true, fragment: "&step=real" });
      await page.locator("#caption-result").filter({ hasText: "Its path for green" }).waitFor();
      await axeFindsNothing(page);
    }
  });
}

test("Back after three tabs and two steps leads through them, and leaves the ball", async () => {
  const page = await openPuzzle(session);
  const wait = (pattern) => page.waitForFunction((source) => new RegExp(source).test(location.hash), pattern);
  for (const panel of ["imagine", "make", "imagine"]) {
    await page.locator(`#tab-${panel}`).click();
    await wait(`panel=${panel}`);
  }
  await page.goBack();
  await page.locator("#make:visible").waitFor();
  await page.goBack();
  await page.locator("#imagine:visible").waitFor();
  await imagined(page);
  for (const step of ["base", "target"]) {
    await page.locator("#walkthrough-next").click();
    await wait(`step=${step}`);
  }
  await page.goBack();
  await page.locator("#walkthrough-step", { hasText: "Step 1" }).waitFor({ state: "attached" });
  await page.goBack();
  await page.locator("#walkthrough-step", { hasText: "All together" }).waitFor({ state: "attached" });
  await page.goBack();
  await page.locator("#play:visible").waitFor();
  await type(page, [90, 190, 7]);
  await wait("ball=90,190,7");
  await openPanel(page, "compare");
  await wait("panel=compare");
  await page.locator("#tab-play").click();
  await wait(`task=${EASY}&ball`);
  await type(page, [60, 200, 9]);
  await wait("ball=60,200,9");
  await page.goBack();
  await page.locator("#compare:visible").waitFor();
  assert.deepEqual(await ball(page), [60, 200, 9]);
});

test("Back that follows a tab at once leads to the tab before, as it was left", async () => {
  const page = await openPuzzle(session);
  await page.locator("#tab-imagine").click();
  await page.waitForFunction(() => location.hash.endsWith("&panel=imagine"));
  // No person is faster; of two tabs within this time only the later one has an entry in the history.
  const reached = await page.evaluate(() => performance.now());
  await page.waitForFunction((time) => performance.now() > time, reached + 250);
  await page.evaluate(() => {
    const root = document.querySelector("pathlight-puzzle")?.shadowRoot;
    for (const selector of ["[data-map=target] input", "#tab-make"]) {
      const control = root?.querySelector(selector);
      if (control instanceof HTMLElement) control.click();
    }
    history.back();
  });
  await page.locator("#imagine:visible").waitFor();
  await page.waitForFunction(() => location.hash.endsWith("&panel=imagine&layers=action"));
  assert.ok(!(await page.locator("[data-map=target] input").isChecked()));
  await page.goForward();
  await page.locator("#make:visible").waitFor();
});

test("a link to the presentation without a puzzle shows the grid and its header", async () => {
  const page = await session.open("/#view=presentation");
  await page.locator("#templates a").first().waitFor();
  assert.ok(await page.locator("header").first().isVisible());
  await page.locator("#templates a").first().click();
  await page.locator("#tab-play").waitFor();
});
