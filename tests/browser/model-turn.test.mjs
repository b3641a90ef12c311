// The model's turn: its attempts fill a list until one solves or a hundred are made; player and model compared.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import {
  inMore,
  known,
  openPanel,
  openPuzzle,
  pause,
  picture,
  playModelTurn,
  says,
  type,
  unsolvedTask,
} from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

async function compare(options) {
  const page = await openPuzzle(session, { fragment: "&panel=compare", reducedMotion: true, ...options });
  await page.locator("#model-turn:enabled").waitFor();
  return page;
}

const made = (page) => page.locator("#model-attempts li").count();

test("the model plays until it has solved, or a hundred times", async () => {
  const page = await compare();
  await playModelTurn(page);
  const results = await page.locator("#model-attempts [data-act=replay]").allTextContents();
  const solved = results.map((text) => /solved after/.test(text));
  assert.ok(results.length >= 1 && results.length <= 100);
  if (solved.includes(true)) assert.equal(solved.indexOf(true), results.length - 1, "it stops when solved");
  else assert.equal(results.length, 100);
  await page.locator("#model-attempts [data-act=replay]").first().click();
  await says(page, /The model’s attempt 1:/);
  assert.equal(await page.locator("#play-attempts li").count(), 0, "the player has made none");
});

/**
 * Starts the turn, and clicks its button a number of times as soon as there is an attempt: a whole turn is over in half
 * a second.
 */
async function playThenClick(page, clicks) {
  await page.locator("#model-turn").evaluate((button, clicks) => {
    const list = button.getRootNode().querySelector("#model-attempts");
    const observer = new MutationObserver(() => {
      observer.disconnect();
      for (let count = 0; count < clicks; count += 1) button.click();
    });
    observer.observe(list, { childList: true });
    button.click();
  }, clicks);
}

test("its turn can be stopped, and taken up again with the same balls", async () => {
  const page = await compare({ task: await unsolvedTask() });
  await playThenClick(page, 1);
  await page.locator("#model-turn").filter({ hasText: "Let the model play" }).waitFor();
  const [first, count] = [
    await page.locator("#model-attempts [data-act=replay]").first().getAttribute("title"),
    await made(page),
  ];
  assert.ok(count >= 1 && count < 100, `${count} attempts`);
  await pause(page);
  assert.equal(await made(page), count, "a stopped model makes no more attempts");
  await playModelTurn(page);
  assert.equal(await made(page), 100);
  assert.equal(await page.locator("#model-attempts [data-act=replay]").first().getAttribute("title"), first);
});

test("a turn that is stopped and started again at once is played to its end", async () => {
  const page = await compare({ task: await unsolvedTask() });
  await playThenClick(page, 2);
  await page.locator("#model-turn").filter({ hasText: "The model has played" }).waitFor({ timeout: 120_000 });
  assert.equal(await made(page), 100);
});

test("player and model side by side, both paths over each other", async () => {
  const page = await compare();
  const { solving } = await known();
  await page.locator("#tab-play").click();
  await type(page, solving);
  await page.locator("#run").click();
  await says(page, /^Solved!/);
  await openPanel(page, "compare");
  const alone = await picture(page);
  await playModelTurn(page);
  await says(
    page,
    /^(Both solved it|You solved it, the model did not)\. Your attempt 1: .+; the model’s attempt \d+ \(dashed\): /,
  );
  assert.notEqual(await picture(page), alone, "the model’s path is drawn too");
  assert.match(
    await page.locator("#race-verdict").textContent(),
    /^You (and the model both solved it on attempt 1|solved it on attempt 1(, the model on attempt|\. The model has not, in 100))/,
  );
  await inMore(page, () => page.locator("#clear-attempts").click());
  assert.equal(await page.locator("#race-verdict").textContent(), "You first: drop a ball.");
  assert.equal(await made(page), 0);
});
