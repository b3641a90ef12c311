// "Can it be solved?" and "Luck or plan?": the search runs beside the page, can be stopped, and keeps its easiest ball
// to itself until it is asked for.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { axeFindsNothing } from "./axe.mjs";
import { start } from "./harness.mjs";
import { ball, known, openPuzzle, pause, pressDuring, says, type } from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

/** Opens a custom scene in the panel Make. */
async function openScene(scene) {
  const page = await session.open("/", { reducedMotion: "reduce" });
  await page.locator("#custom-open").waitFor();
  await page
    .locator("#custom-file")
    .setInputFiles({ name: "scene.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify(scene)) });
  await page.locator("#tab-make").click();
  return page;
}

const scene = (object, goal) => ({
  version: 1,
  body1: 0,
  body2: 1,
  bodies: [
    { shape: "ball", radius: 10, angle: 0, dynamic: true, ...object },
    { shape: "bar", length: 40, thickness: 5, angle: 0, dynamic: false, ...goal },
  ],
});

test("a puzzle that can be solved: how many balls do, and the easiest only when it is asked for", async () => {
  const page = await openPuzzle(session, { fragment: "&panel=make", reducedMotion: true });
  await page.locator("#check-search").click();
  await page
    .locator("#check-words")
    .filter({ hasText: /\d balls/ })
    .waitFor();
  await page.locator("#check-search").filter({ hasText: "Search" }).waitFor({ timeout: 120_000 });
  const words = await page.locator("#check-words").textContent();
  assert.match(
    words,
    /It can be solved: [\d,]+ of [\d,]+ balls solve it, .*%\. \d+% of the benchmark’s puzzles are harder\./,
  );
  assert.equal(await page.locator("#check-ball").textContent(), "");
  assert.equal(page.url().includes("ball="), false);
  await page.locator("#check-reveal").click();
  await page.locator("#check-ball").filter({ hasText: "is in the scene" }).waitFor();
  await page.locator("#tab-play").click();
  assert.ok((await ball(page))[2] > 0);
  await page.locator("#run").click();
  await says(page, /^Solved/);
});

test("what is edited so that it may not be played is not searched, nor is what it was before", async () => {
  const page = await openScene(scene({ x: 60, y: 200 }, { x: 200, y: 10 }));
  await page.locator("#check-search").click();
  await page
    .locator("#check-words")
    .filter({ hasText: /\d balls/ })
    .waitFor();
  await page.locator("#scene").press("n");
  for (let step = 0; step < 8; step += 1) await page.locator("#scene").press("Shift+ArrowUp");
  await page.locator("#make-problems:visible").waitFor();
  await page.locator("#check-search:disabled").filter({ hasText: "Search" }).waitFor();
  await page
    .locator("#check-words")
    .filter({ hasText: /^Fix the problems above first/ })
    .waitFor();
  for (let step = 0; step < 4; step += 1) await page.locator("#scene").press("Shift+ArrowDown");
  // What was edited a moment ago is searched: its puzzle does not end the search when it comes.
  await page.locator("#check-search:enabled").click();
  await page
    .locator("#check-words")
    .filter({ hasText: /\d balls/ })
    .waitFor();
  await pause(page, 600);
  assert.match(await page.locator("#check-words").textContent(), /\d balls/);
});

test("the search can be stopped, and says what it has found so far", async () => {
  const page = await openPuzzle(session, { fragment: "&panel=make" });
  const stopped = pressDuring(page, "#check-search", "#check-words", { after: 1 });
  await page.locator("#check-search").click();
  assert.match((await stopped)[0], /so far/);
  await page.locator("#check-progress").waitFor({ state: "hidden" });
  const words = await page.locator("#check-words").textContent();
  await pause(page, 400);
  assert.equal(await page.locator("#check-words").textContent(), words);
});

test("a scene that nothing solves says none found, and one that solves itself says so", async () => {
  const impossible = await openScene(scene({ x: 60, y: 12 }, { x: 200, y: 250 }));
  await impossible.locator("#check-search").click();
  await impossible
    .locator("#check-words")
    .filter({ hasText: /^No solution found in [\d,]+ balls\. A ball between/ })
    .waitFor({ timeout: 120_000 });
  assert.equal(await impossible.locator("#check-reveal").isVisible(), false);
  const itself = await openScene(scene({ x: 100, y: 120 }, { x: 100, y: 10 }));
  await itself.locator("#make-alone").filter({ hasText: "solves itself" }).waitFor();
  await itself.locator("#check-search").click();
  await itself.locator("#check-words").filter({ hasText: "The scene solves itself" }).waitFor();
});

/** The example of docs/teaching.md: a lesson that shows nothing of the model, so that nothing has started it. */
const WITHOUT_MODEL = "&hide=puzzles,imagine,compare,predict,map,make";

test("in a lesson without the model: luck, and attempts are saved", async () => {
  const { solving } = await known();
  for (const [button, words] of [
    ["#luck-ask", "#luck-words"],
    ["#attempts-save", "#attempts-words"],
  ]) {
    const page = await openPuzzle(session, { fragment: WITHOUT_MODEL, reducedMotion: true });
    await type(page, solving);
    await page.locator("#run").click();
    await says(page, /^Solved/);
    if (button === "#attempts-save") await page.locator("#more-button").click();
    await page.locator(button).click();
    await page
      .locator(words)
      .filter({ hasText: /balls within a pixel|One attempt is saved/ })
      .waitFor();
  }
});

test("luck or plan, after a ball that solved and not before", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  const { solving, missing } = await known();
  await type(page, missing);
  await page.locator("#run").click();
  await says(page, /^Not solved/);
  assert.equal(await page.locator("#luck").isVisible(), false);
  await type(page, solving);
  await page.locator("#run").click();
  await says(page, /^Solved/);
  await page.locator("#luck-ask").click();
  await page
    .locator("#luck-words")
    .filter({ hasText: /of the \d+ balls within a pixel of yours in place and radius, \d+ solve it/ })
    .waitFor();
  await axeFindsNothing(page);
});
