// The race in Play: you and the model side by side. Nothing of the model's result is told before it has run, and the
// verdict names who won.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { EASY, known, openPuzzle, palette, pixels, says, solvedTask, type } from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

const race = (page) => page.locator("#race-it");
const verdict = (page, words) => page.locator("#race-verdict").filter({ hasText: words }).waitFor({ timeout: 60_000 });

/** Opens a task and runs a ball of the player's. */
async function played(task, outcome, options = {}) {
  const balls = await known(task);
  const page = await openPuzzle(session, { task, ...options });
  await page.locator("#race-verdict", { hasText: "You first: drop a ball." }).waitFor();
  assert.ok(await race(page).isDisabled());
  assert.equal(await page.locator("#race-model").textContent(), "?");
  await type(page, balls[outcome]);
  await page.locator("#speed").selectOption("4");
  await page.locator("#run").click();
  await says(page, outcome === "solving" ? /^Solved!/ : /^Not solved/);
  return page;
}

test("the player wins, and nothing is told before both have run", async () => {
  const [task, attempts] = await solvedTask((attempt) => attempt >= 2 && attempt <= 4);
  const page = await played(task, "solving");
  // All that is told of the model, each with whether the race has been shown to its end.
  const told = await page.evaluateHandle(() => {
    const root = /** @type {ShadowRoot} */ (document.querySelector("#puzzle")?.shadowRoot);
    const text = (id) => root.getElementById(id)?.textContent ?? "";
    const log = [];
    new MutationObserver(() =>
      log.push({
        over: /solved it/.test(text("status")),
        words: ["race-verdict", "race-model", "model-count"].map(text).join(" | "),
        rows: [...root.querySelectorAll("#model-attempts .mark.solved")].length,
      }),
    ).observe(root, { childList: true, characterData: true, subtree: true });
    return log;
  });
  // So slow that it can be paused before it has ended.
  await page.locator("#speed").selectOption("0.25");
  await race(page).click();
  await says(page, /over each other; the second is dashed/, 60_000);
  await page.locator("#run").click();
  await page.locator("#time").fill("0");
  const { green } = palette;
  const early = await pixels(page, green);
  await page.locator("#time").press("End");
  await verdict(page, /^You solved it on attempt 1, the model on attempt \d+\. You were quicker\.$/);
  assert.equal(await page.locator("#race-model").textContent(), `✓ on attempt ${attempts}`);
  await says(page, /^Both solved it\. Your attempt 1: solved .+; the model’s attempt \d+ \(dashed\): solved/);
  assert.ok((await pixels(page, green)) > early, "the paths are drawn as they run");
  for (const { over, words, rows } of await told.jsonValue())
    assert.ok(over || (rows === 0 && !/solved it on|✓ on attempt|solved on attempt/.test(words)), words);
});

test("the player loses: the model is right at once, and no good news is told", async () => {
  const [task] = await solvedTask((attempt) => attempt === 1);
  const page = await played(task, "missing", { reducedMotion: true });
  await race(page).click();
  await verdict(page, /^The model solved it on attempt 1\. You have not yet, in 1 attempt\.$/);
  await says(page, /^The model solved it, you did not\. Your attempt 1: /);
  assert.equal(await page.locator("#status").getAttribute("data-kind"), "missed");
  await race(page).filter({ hasText: "Watch it again" }).click();
  await says(page, /^The model solved it, you did not\./);
});

test("it can be stopped, and goes on", async () => {
  const page = await played(EASY, "missing");
  await race(page).evaluate((button) => {
    button.click();
    button.click();
  });
  await race(page).filter({ hasText: "Race it" }).waitFor();
  await race(page).click();
  await verdict(page, /^The model solved it/);
});

test("a link that hides it has no race", async () => {
  const page = await openPuzzle(session, { fragment: "&hide=compare" });
  assert.ok(await page.locator("#race").isHidden());
});
