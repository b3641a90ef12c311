// Two models side by side on one puzzle: what each has seen, imagines and tries, and which needs fewer attempts.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { axeFindsNothing } from "./axe.mjs";
import { start } from "./harness.mjs";
import { inMore, modelLoaded, openPuzzle, says } from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

/** When a model solves its test tasks: each with the attempt. */
async function solvedAt(model) {
  const { agents } = JSON.parse(
    await readFile(new URL(`../../results/shipped/${model}.json`, import.meta.url), "utf8"),
  );
  return agents.find(({ agent }) => agent === "online").first_solved;
}

/** A puzzle of the second model's test tasks, and when that solves it. */
async function measured() {
  return (await solvedAt("cross-0")).find(([, first]) => first > 1 && first < 20);
}

const column = (page, index) => page.locator("#pair-columns > div").nth(index);

async function sideBySide(options) {
  const [task, first] = await measured();
  const page = await openPuzzle(session, { task, fragment: "&panel=compare", ...options });
  await page.locator("#more-button").click();
  await page.locator("#model-pair:visible").waitFor();
  await page.locator("#pair-run").press("Enter");
  await column(page, 1).waitFor();
  return { page, task, first };
}

test("each is named with what it has seen, its map, its balls and when it solves, as it was measured", async () => {
  const { page, first } = await sideBySide();
  assert.equal(await page.locator("#pair-columns h3").allTextContents().then(String), "within-0,cross-0");
  assert.equal(await column(page, 1).locator(".model-badge").innerText(), "new to the model");
  assert.match(
    await column(page, 1).locator(".pair-outcome").textContent(),
    new RegExp(`^Solved on attempt ${first}\\. Its own guess for its first ball: .+ \\(.+%\\)\\.$`),
  );
  await page
    .locator("#pair-words")
    .filter({
      hasText:
        /^((within|cross)-0 needs fewer attempts: \d+ instead of \d+|Only (within|cross)-0 solves this puzzle|Both solve it on attempt \d+)\.$/,
    })
    .waitFor();
  const place = await column(page, 0).locator(".pair-place").textContent();
  assert.match(place, /^Most sure .+\.$/);
  await page.locator("#pair-map-name").selectOption("action");
  assert.match(await column(page, 0).locator("canvas[role=img]").getAttribute("aria-label"), /^What red must do: /);

  await column(page, 1).locator("button").click();
  await says(page, new RegExp(`The model’s ball ${first} is running`));
  assert.equal(await page.locator("#model-attempts li").count(), 0, "looking is no attempt");
  await page.locator("#next").click();
  assert.equal(await page.locator("#pair-columns > div").count(), 0, "they are not told of the next puzzle");
});

test("another model instead of the first clears them", async () => {
  const { page } = await sideBySide();
  await page.locator("#model-select").selectOption("cross-0");
  assert.equal(await page.locator("#pair-columns > div").count(), 0);
  await page.locator("#pair-model option", { hasText: "within-0" }).waitFor({ state: "attached" });
});

test("a second model that cannot be loaded is a sentence", async () => {
  const [task] = await measured();
  const page = await openPuzzle(session, { task, fragment: "&panel=compare" });
  await page.context().route("**/cross-0.safetensors", (route) => route.fulfill({ status: 404 }));
  await page.locator("#more-button").click();
  await page.locator("#pair-run").click();
  await page.locator("#pair-words").filter({ hasText: "weights are missing here" }).waitFor();
  assert.match(await page.locator("#announcement").textContent(), /weights are missing here/);
  session.takeProblems();
});

for (const [screen, options] of Object.entries({
  "a desktop, dark": { viewport: { width: 1280, height: 800 }, colorScheme: "dark" },
  "a phone": { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true },
})) {
  test(`axe finds nothing on ${screen}`, async () => {
    const { page } = await sideBySide(options);
    await axeFindsNothing(page);
  });
}

test("a model that is chosen while the other one is loaded ends what was asked", async () => {
  const [task] = await measured();
  const page = await openPuzzle(session, { task, fragment: "&panel=compare" });
  await page.locator("#more-button").click();
  await page.locator("#model-pair:visible").waitFor();
  let open = () => {};
  const gate = new Promise((resolve) => (open = () => resolve(null)));
  await page.context().route("**/cross-0.safetensors", (route) => gate.then(() => route.continue()));
  await page.locator("#pair-run").click();
  await page.locator("#pair-words").filter({ hasText: "Both models are playing" }).waitFor();
  assert.match(await page.locator("#announcement").textContent(), /Both models are playing/);
  await page.locator("#model-select").selectOption("cross-0");
  open();
  await modelLoaded(page, "cross-0");
  assert.equal(await page.locator("#pair-words").textContent(), "", "nobody plays any longer");
  assert.equal(await page.locator("#pair-columns > div").count(), 0);
  await page.locator("#pair-model option", { hasText: "within-0" }).waitFor({ state: "attached" });
});

test("a ball of the other model is not taken for the one that is looked at", async () => {
  for (const [task, first] of (await solvedAt("within-0")).filter(([, first]) => first === 2).slice(0, 10)) {
    const page = await openPuzzle(session, { task, fragment: "&panel=compare&model=cross-0", reducedMotion: true });
    await page.locator("#proposals:visible").waitFor();
    // The first model needs a longer list.
    if (Number(await page.locator("#proposal-slider").getAttribute("max")) > first) {
      await inMore(page, async () => {
        await page.locator("#pair-run").click();
        await column(page, 1).waitFor();
      });
      for (let number = 1; number <= first; number += 1) await page.locator("#proposal-next").click();
      await page.waitForFunction((first) => location.hash.includes(`proposal=${first}`), first);
      await inMore(page, () => column(page, 1).locator("button").click());
      await page.waitForFunction(() => !location.hash.includes("proposal="));
      return;
    }
    await page.close();
  }
  assert.fail("the first model solves all of these puzzles as fast as the other one");
});
