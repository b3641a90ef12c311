// The model's turn as a show: its misses go by as ghosts, with a counter; it can be stopped and skipped; then its
// solution runs.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import {
  MODEL_TRIES_AGAIN,
  click,
  known,
  openPanel,
  openPuzzle,
  pause,
  pressDuring,
  says,
  solvedTask,
  type,
  unsolvedTask,
} from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

const turn = (page) => page.locator("#model-turn");
const made = (page) => page.locator("#model-attempts li").count();

/** All that the status line says from now on. */
function said(page) {
  return page.locator("#status").evaluateHandle((status) => {
    const words = [];
    new MutationObserver(() => words.push(status.textContent)).observe(status, {
      childList: true,
      characterData: true,
      subtree: true,
    });
    return words;
  });
}

test("its misses are counted one after the other, then its solution runs to “Solved!”", async () => {
  const [task, attempts] = await solvedTask((attempt) => attempt >= 4 && attempt <= 8);
  const page = await openPuzzle(session, { task, fragment: "&panel=compare" });
  const seen = await said(page);
  await turn(page).click();
  await page.locator(".scene.models").waitFor();
  await says(page, /^Solved! The model’s attempt \d+: solved after/, 60_000);
  const words = await seen.jsonValue();
  for (let number = 1; number < attempts; number += 1)
    assert.ok(words.includes(`The model tries: attempt ${number}.`), `attempt ${number}: ${words.join(" ")}`);
  assert.equal(await made(page), attempts);
  assert.equal(await page.locator("#goal-meter").getAttribute("aria-valuenow"), "3.0", "with its ring");
  assert.equal((await turn(page).textContent()).trim(), "The model has played");
});

test("the show can be stopped; only what was shown counts", async () => {
  const page = await openPuzzle(session, { task: await unsolvedTask(), fragment: "&panel=compare" });
  const stopped = pressDuring(page, "#model-turn", "#status", { after: 3 });
  await turn(page).click();
  assert.equal((await stopped).at(-1), "The model tries: attempt 3.");
  await turn(page).filter({ hasText: "Let the model play" }).waitFor();
  const count = await made(page);
  assert.ok(count >= 3 && count < 10, `${count} attempts`);
  await pause(page, 1000);
  assert.equal(await made(page), count);
  await says(page, /place the red ball/);
  const words = await said(page);
  await turn(page).click();
  await page.waitForFunction(
    ([words, next]) => words.includes(next),
    /** @type {const} */ ([words, `The model tries: attempt ${count + 2}.`]),
  );
  assert.equal(
    (await words.jsonValue()).find((one) => one.startsWith("The model tries")),
    `The model tries: attempt ${count + 1}.`,
    "it goes on where it was",
  );
});

test("the show can be skipped, by keyboard too", async () => {
  const page = await openPuzzle(session, { task: await unsolvedTask(), fragment: "&panel=compare" });
  await turn(page).click();
  await says(page, MODEL_TRIES_AGAIN);
  await page.locator("#model-skip").focus();
  await page.keyboard.press("Enter");
  await turn(page).filter({ hasText: "The model has played" }).waitFor({ timeout: 60_000 });
  assert.equal(await made(page), 100);
  assert.ok(await page.locator("#model-skip").isHidden());
});

test("another puzzle ends the show", async () => {
  const page = await openPuzzle(session, { task: await unsolvedTask(), fragment: "&panel=compare" });
  await turn(page).click();
  await says(page, MODEL_TRIES_AGAIN);
  await page.locator("#next").click();
  await says(page, /place the red ball/);
  await pause(page);
  await says(page, /place the red ball/);
  assert.equal(await made(page), 0);
});

test("with reduced motion only the result is shown", async () => {
  const [task, attempts] = await solvedTask((attempt) => attempt >= 4 && attempt <= 8);
  const page = await openPuzzle(session, { task, fragment: "&panel=compare", reducedMotion: true });
  await turn(page).click();
  await says(page, new RegExp(`^Solved! The model’s attempt ${attempts}: solved after`), 60_000);
});

test("what the person does meanwhile is not overridden by the result", async () => {
  const page = await openPuzzle(session, { task: await unsolvedTask(), fragment: "&panel=compare" });
  await turn(page).click();
  await says(page, MODEL_TRIES_AGAIN);
  await click(page, 128, 240);
  assert.equal(await page.locator(".scene.models").count(), 0, "the scene is the person’s again");
  await turn(page).filter({ hasText: "The model has played" }).waitFor({ timeout: 60_000 });
  await pause(page);
  await says(page, /^(Ready|Not here)/);
});

test("a run that begins before the model’s first attempt is there plays on", async () => {
  const [task] = await solvedTask((attempt) => attempt >= 4 && attempt <= 8);
  const { missing } = await known(task);
  const page = await openPuzzle(session, { task });
  await type(page, missing);
  await openPanel(page, "compare");
  await page.locator("#model-turn:enabled").waitFor();
  // Longer than the model takes for its turn.
  await page.locator("#speed").selectOption("0.25");
  const words = await said(page);
  await page.locator("#model-turn").evaluate((button) => {
    button.click();
    button.getRootNode().querySelector("#run").click();
  });
  await turn(page).filter({ hasText: "The model has played" }).waitFor({ timeout: 60_000 });
  await says(page, /^Your attempt/);
  assert.ok(
    !(await words.jsonValue()).some((one) => one.startsWith("The model tries")),
    "no miss of the model is shown",
  );
});
