// Leaving a puzzle while something of it is still to be drawn: the page must not use the freed puzzle.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { attempts, known, openPuzzle, pause, says, type, unsolvedTask } from "./page-actions.mjs";

let session;
before(async () => (session = await start({ sources: true })));
after(() => session.stop());

test("a puzzle is left while pictures of attempts wait to be drawn", async () => {
  const page = await openPuzzle(session, {
    task: await unsolvedTask(),
    fragment: "&panel=compare",
    reducedMotion: true,
  });
  // Slow painting, so that some pictures still wait.
  await page.evaluate(async () => {
    const { Game } = await import("/pkg/pathlight.js");
    const paintAttempt = Game.prototype.paintAttempt;
    Game.prototype.paintAttempt = function (...args) {
      const end = performance.now() + 100;
      while (performance.now() < end);
      paintAttempt.apply(this, args);
    };
  });
  await page.locator("#model-turn:enabled").click();
  await page.locator("#model-attempts canvas.drawn").first().waitFor();
  assert.ok((await page.locator("#model-attempts canvas:not(.drawn)").count()) > 0, "some are not drawn yet");
  await page.locator("#home").click();
  await page.locator("#templates canvas.drawn").first().waitFor();
  await pause(page, 400);
  assert.ok(await page.locator("#notice").isHidden());
  // Its attempts come back with it, and their pictures are drawn.
  await page.goBack();
  await page.locator("#model-attempts canvas.drawn").nth(1).waitFor();
});

test("sentences about a puzzle go with it", async () => {
  const sentences = ["#attempts-words", "#luck-words", "#make-said", "#make-alone"];
  const page = await openPuzzle(session, { fragment: "&panel=make", reducedMotion: true });
  await page.locator("#make-keep").click();
  await page.locator("#tab-play").click();
  await type(page, (await known()).solving);
  await page.locator("#run").click();
  await page.locator("#luck-ask").click();
  await page.locator("#more-button").click();
  await page.locator("#attempts-save").click();
  for (const id of sentences) await page.locator(id).filter({ hasText: /./ }).waitFor({ state: "attached" });
  await page.locator("#attempts-words").filter({ hasText: "One attempt is saved" }).waitFor();
  await page.evaluate(() => (location.hash = "#task=00001:000"));
  await page.locator("#run:enabled").waitFor();
  for (const id of sentences) await page.locator(id).filter({ hasNotText: /./ }).waitFor({ state: "attached" });
});

test("an answer about a puzzle that was left is not shown", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  await type(page, (await known()).solving);
  await page.locator("#run").click();
  // The worker answers in order: the answer to the button comes before that to the search.
  await page.locator("#luck-ask").click();
  await page.evaluate(() => (location.hash = "#task=00001:000&panel=make"));
  await page.locator("#check-search").click();
  await page
    .locator("#check-words")
    .filter({ hasText: /\d balls/ })
    .waitFor();
  assert.equal(await page.locator("#luck-words").textContent(), "");
});

test("the colour scheme changes after a puzzle was left", async () => {
  const page = await openPuzzle(session, { fragment: "&panel=predict", reducedMotion: true });
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor({ state: "attached" });
  await page.locator("#scene").press("Shift+ArrowDown");
  await page.locator("#predict-watch").click();
  await page.locator("#predict-result:visible").waitFor();
  await page.locator("#home").click();
  await page.locator("#templates canvas.drawn").first().waitFor();
  await page.emulateMedia({ colorScheme: "dark", reducedMotion: "reduce" });
  await pause(page, 300);
  assert.ok(await page.locator("#notice").isHidden());
});

test("an attempt that runs while the page is left counts", async () => {
  const page = await openPuzzle(session);
  await type(page, (await known()).missing);
  await page.locator("#run").click();
  await says(page, /is running/);
  assert.equal(await attempts(page), 0);
  await page.reload();
  await page.locator("#play-attempts li").first().waitFor();
  assert.equal(await attempts(page), 1);
});
