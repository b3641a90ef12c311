// Two people's ways through the page from end to end: a teacher's from the presentation to the link for the class, and
// a researcher's from the list of failures to the exported strip. The way of a first visit is in a file of its own.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { inMore, openLesson, openPuzzle, says, spot } from "./page-actions.mjs";

const SCREENS = {
  "a phone": { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true },
  "a desktop": { viewport: { width: 1280, height: 800 } },
  "a projector": { viewport: { width: 1920, height: 1080 } },
};

let session;
before(async () => (session = await start()));
after(() => session.stop());

for (const [screen, options] of Object.entries(SCREENS)) {
  test(`a teacher shows the story on ${screen}`, async () => {
    const page = await openPuzzle(session, {
      ...options,
      task: "00007:008",
      reducedMotion: true,
      fragment: "&view=presentation",
    });
    await page.locator("#imagined-in").filter({ hasText: "Imagined in" }).waitFor({ state: "attached" });
    for (let step = 1; step <= 6; step += 1) {
      const entries = await page.evaluate(() => history.length);
      await page.keyboard.press("PageDown");
      await page
        .locator("#caption-step")
        .filter({ hasText: `${step} of 6` })
        .waitFor({ state: "attached" });
      // A viewer looks at a step for a while; those that are only passed have no entry in the history.
      await page.waitForFunction((before) => history.length > before, entries);
    }
    await page.locator("#caption-result").filter({ hasText: "Its path for green was" }).waitFor();
    await says(page, /olved/);
    for (let step = 0; step < 6; step += 1) await page.goBack();
    await page.locator("#caption-title", { hasText: "Funnel" }).waitFor();
  });

  test(`a researcher exports the balls of a failure on ${screen}`, async () => {
    const page = await session.open("/", { ...options, reducedMotion: "reduce" });
    await page.locator("#results-link").click();
    await page.locator("#results-filter").selectOption("failures");
    await page.locator("#results-templates .missed").nth(3).click();
    await page
      .locator("#compare .model-badge")
      .filter({ hasText: /Knows all 25 kinds\s*new to the model/ })
      .waitFor();
    // The outcomes are not told before somebody looks at a ball: they would tell how the race ends.
    await page.locator("#proposals").waitFor();
    assert.ok(await page.locator("#proposal-outcomes").isHidden());
    await page.locator("#proposal-next").click();
    await page.locator("#proposal-outcomes").waitFor();
    await page.locator("#proposal-origin").filter({ hasText: "the best chance" }).waitFor();
    const [file] = await Promise.all([
      page.waitForEvent("download"),
      inMore(page, () => page.locator("#proposal-save").click()),
    ]);
    assert.match(file.suggestedFilename(), /^pathlight-\d{5}-\d{3}-within-0\.csv$/);
    const lines = (await readFile(await file.path(), "utf8")).trimEnd().split("\r\n");
    assert.equal(lines.length, 101);
    assert.ok(
      lines.slice(1).every((line) => !line.includes("solved")),
      "none of them solves it",
    );
  });
}

test("a teacher makes the link for the class out of the presentation", async () => {
  const page = await openPuzzle(session, { task: "00007:008", fragment: "&view=presentation&step=target" });
  await page.keyboard.press("Escape");
  await openLesson(page);
  for (const name of ["imagine", "compare", "map", "make", "predict", "puzzles", "tools", "forecast"])
    await page.locator(`#lesson-dialog [name=${name}]`).uncheck();
  const link = await page.locator("#lesson-address").inputValue();
  const pupil = await session.open(link.slice(session.origin.length), { ...SCREENS["a phone"] });
  await pupil.locator("#scene").waitFor();
  await pupil.touchscreen.tap(...(await spot(pupil, 100, 240)));
  await says(pupil, /Ready|Not here/);
  assert.doesNotMatch(
    await pupil.locator("body").innerText(),
    /model|net|imagine/i,
    "nothing is told of what is hidden",
  );
  const inPuzzle = await pupil
    .locator("pathlight-puzzle")
    .evaluate(
      (element) =>
        element.shadowRoot?.querySelector(".puzzle")?.textContent &&
        /** @type {HTMLElement} */ (element.shadowRoot.querySelector(".puzzle")).innerText,
    );
  assert.doesNotMatch(inPuzzle, /model|net\b|nets|imagine/i);
});
