// Imagined against real: after a run its paths lie over the imagined ones, with their overlap as a number.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { inMore, known, openPanel, openPuzzle, picture, playModelTurn, says, type } from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

const run = (page, who) => page.locator(`#runs [data-runner=${who}]`);

/** The overlaps of a run, in percent: of the green object, and of the ball if there is one. */
async function overlapsOf(page, who) {
  const texts = await run(page, who).locator(".overlap-cards b").allTextContents();
  return texts.map((text) => Number(text.match(/^(\d+)%$/)[1]));
}

test("runs of the player, of the model and without a ball stand beside each other with their overlaps", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  const { solving } = await known();
  await page.locator("#watch").click();
  await page.locator("#tab-imagine").click();
  await page
    .locator("#overlap-words")
    .filter({ hasText: "Without a ball: green object" })
    .waitFor({ state: "attached" });
  assert.equal((await overlapsOf(page, "alone")).length, 1, "there is no ball to measure");

  await type(await tab(page, "play"), solving);
  await page.locator("#run").click();
  await says(page, /^Solved!/);
  await tab(page, "compare");
  await playModelTurn(page);
  await tab(page, "imagine");
  assert.equal(await run(page, "player").locator("h3").textContent(), "Your attempt 1");
  assert.match(await run(page, "model").locator("h3").textContent(), /^The model’s attempt \d+$/);
  for (const who of ["player", "model"]) {
    const overlaps = await overlapsOf(page, who);
    assert.equal(overlaps.length, 2);
    assert.ok(
      overlaps.every((overlap) => overlap > 0 && overlap <= 100),
      `${who}: ${overlaps}`,
    );
  }
  assert.match(
    await page.locator("#overlap-words").textContent(),
    /Your attempt 1: green object \d+%, red ball \d+%; The model’s attempt \d+: green object/,
  );
});

test("the line goes round the path of this run, and goes with its attempt", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  const { solving, missing } = await known();
  const pictures = [];
  for (const ball of [solving, missing]) {
    await type(await tab(page, "play"), ball);
    await page.locator("#run").click();
    await says(page, /olved/);
    await tab(page, "imagine");
    await run(page, "player").waitFor();
    pictures.push(await picture(page, "#runs [data-runner=player] .overlap-cards li:last-child canvas[role=img]"));
  }
  assert.notEqual(pictures[0], pictures[1]);
  await tab(page, "compare");
  await inMore(page, () => page.locator("#clear-attempts").click());
  await tab(page, "imagine");
  assert.equal(await run(page, "player").count(), 0);
  await page.locator("#overlap-empty:visible").waitFor();
});

async function tab(page, name) {
  await openPanel(page, name);
  return page;
}

test("a run keeps the number of its attempt when others are deleted, and goes with it", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  const { solving, missing } = await known();
  for (const ball of [missing, solving]) {
    await type(await tab(page, "play"), ball);
    await page.locator("#run").click();
    await says(page, /olved/);
  }
  await tab(page, "imagine");
  await run(page, "player").locator("h3", { hasText: "Your attempt 2" }).waitFor();
  const remove = async () => (await tab(page, "compare")).locator("#play-attempts [data-act=remove]").first().click();
  await remove();
  await tab(page, "imagine");
  await run(page, "player").locator("h3", { hasText: "Your attempt 1" }).waitFor();
  await remove();
  await tab(page, "imagine");
  await page.locator("#overlap-empty:visible").waitFor();
});
