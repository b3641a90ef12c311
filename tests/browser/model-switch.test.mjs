// Another model is chosen on an open puzzle: what the first has done goes with it, on the page and in the device's
// store.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import {
  inMore,
  known,
  modelLoaded,
  openPanel,
  openPuzzle,
  pause,
  playModelTurn,
  says,
  type,
  unsolvedTask,
} from "./page-actions.mjs";

let session, first, second;
before(async () => {
  session = await start();
  const { models } = await (await fetch(`${session.origin}/assets/model.json`)).json();
  [first, second] = models.map(({ name }) => name);
});
after(() => session.stop());

const made = (page) => page.locator("#model-attempts li").count();
/** The attempts of a model that are stored, as lines; null if there are none. */
const stored = (page, model) =>
  page.evaluate((model) => {
    const lines = Object.entries(localStorage).flatMap(([key, text]) => (/attempts/.test(key) ? text.split("\n") : []));
    return lines.filter((line) => line.includes(`"by":"${model}"`)).join("\n") || null;
  }, model);

async function open(options) {
  const page = await openPuzzle(session, { fragment: "&panel=compare", reducedMotion: true, ...options });
  await modelLoaded(page, first);
  return page;
}

/** Chooses a model in the panel Imagine, and comes back. */
async function choose(page, name) {
  await page.locator("#tab-imagine").click();
  await inMore(page, () => page.locator("#model-select").selectOption(name));
  await modelLoaded(page, name);
  await openPanel(page, "compare");
}

test("the attempts of the first model go, the player’s stay, and no store takes one model’s result for the other’s", async () => {
  const page = await open({ fragment: "" });
  const { missing } = await known();
  await type(page, missing);
  await page.locator("#run").click();
  await says(page, /^Not solved/);
  await openPanel(page, "compare");
  await playModelTurn(page);
  const record = await stored(page, first);
  assert.ok(record, "the turn is kept for the first model");

  await choose(page, second);
  assert.equal(await made(page), 0);
  assert.equal(await page.locator("#play-attempts li").count(), 1);
  assert.deepEqual(
    await page.locator("#race-player, #race-model").allTextContents(),
    ["not yet, 1 attempt", "?"],
    "the other model has not played",
  );
  await page.locator("#model-turn:enabled").filter({ hasText: "Let the model play" }).waitFor();
  // Anything that changes the session.
  await page.locator("#scene").press("ArrowUp");
  assert.equal(await stored(page, second), null);

  await playModelTurn(page);
  assert.equal((await stored(page, second)).split("\n").length, await made(page));
  assert.equal(await stored(page, first), record);
});

test("a turn of the first model ends", async () => {
  const page = await open({ task: await unsolvedTask() });
  await page.locator("#model-turn:enabled").click();
  await page.locator("#model-attempts li").first().waitFor();
  await choose(page, second);
  await pause(page);
  assert.equal(await made(page), 0);
  assert.equal(await page.locator("#model-turn").textContent(), "Let the model play");
  assert.equal(await stored(page, second), null);
});

test("a model that is chosen by a link to the grid is the one of the next puzzle", async () => {
  const page = await open({ fragment: "" });
  await page.goto(`${session.origin}/#model=${second}`);
  await page.locator("#templates a").first().click();
  await page.locator("#scene").waitFor();
  await modelLoaded(page, second);
});

test("the balls one by one are those of the model that is loaded", async () => {
  const page = await open();
  const firstBall = async () => {
    await page.locator("#proposals:visible").waitFor();
    await page.locator("#proposal-next").click();
    await page.locator("#proposal-facts:visible").waitFor();
    return (
      (await page.locator("#proposal-ball").textContent()) + (await page.locator("#proposal-origin").textContent())
    );
  };
  const before = await firstBall();
  await choose(page, second);
  assert.equal(await page.locator("#proposal-number").textContent(), "–", "the ball of the first model is left");
  const switched = await firstBall();
  assert.notEqual(switched, before);
  await page.goto("about:blank");
  await page.goto(`${session.origin}/#task=00000:000&panel=compare&model=${second}`);
  assert.equal(await firstBall(), switched);
});

test("one worker is started for the second model, also while a ball of the first is looked at", async () => {
  const page = await open({ fragment: "&panel=compare&proposal=1" });
  await page.locator("#proposal-facts").waitFor();
  const started = await page.evaluateHandle(() => {
    const counted = { workers: 0 };
    window.Worker = class extends Worker {
      constructor(url, options) {
        super(url, options);
        counted.workers += 1;
      }
    };
    return counted;
  });
  await choose(page, second);
  assert.equal(await started.evaluate(({ workers }) => workers), 1);
});
