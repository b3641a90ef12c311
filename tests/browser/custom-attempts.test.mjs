// Attempts at custom puzzles are kept as those at the benchmark's are: they come back, go with the puzzle,
// and belong to what is played, whatever it is called.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { customScene } from "../../www/pkg/pathlight.js";
import { start } from "./harness.mjs";
import { EASY, attempts, inMore, known, modelLoaded, openPanel, playModelTurn, says, type } from "./page-actions.mjs";

let session;
let balls;
let scene;
before(async () => {
  session = await start({ sources: true });
  balls = await known();
  scene = { ...customScene(EASY), name: "Mine" };
});
after(() => session.stop());

const titles = (page, list) =>
  page
    .locator(`#${list} [data-act=replay]`)
    .evaluateAll((buttons) => buttons.map((button) => button.title + button.textContent));
const stored = (page) => page.evaluate(() => localStorage.getItem("pathlight.attempts.own"));

/** Opens the puzzle, which is kept in the grid too. */
async function openCustom() {
  const page = await session.open("/", { reducedMotion: "reduce" });
  await page.evaluate((scene) => localStorage.setItem("pathlight.own-puzzles", JSON.stringify([scene])), scene);
  await page.reload();
  const href = await page.locator('#custom-puzzles a[href*="scene="]').getAttribute("href");
  await page.goto(`${session.origin}/${href}`);
  await page.locator("#scene").waitFor();
  return page;
}

async function run(page, ball, words) {
  await type(page, ball);
  await page.locator("#run").click();
  await says(page, words);
}

/** A miss and a solution of the player's. */
async function played() {
  const page = await openCustom();
  await run(page, balls.missing, /^Not solved/);
  await page.locator("#reset").click();
  await run(page, balls.solving, /^Solved/);
  return page;
}

test("the attempts of both come back after a reload", async () => {
  const page = await played();
  await openPanel(page, "compare");
  await playModelTurn(page);
  const [player, model] = [await titles(page, "play-attempts"), await titles(page, "model-attempts")];
  assert.equal(player.length, 2);
  assert.ok(model.length >= 1);
  await page.reload();
  await page.locator("#model-attempts li").first().waitFor();
  assert.deepEqual(await titles(page, "play-attempts"), player);
  assert.deepEqual(await titles(page, "model-attempts"), model);
  await inMore(page, () => page.locator("#clear-attempts").click());
  await page.reload();
  await modelLoaded(page);
  assert.deepEqual([...(await titles(page, "play-attempts")), ...(await titles(page, "model-attempts"))], []);
  assert.equal(await stored(page), null);
});

test("a scene that is changed has attempts of its own, and one that is only renamed keeps its own", async () => {
  const page = await played();
  await page.locator("#tab-make").click();
  const waitForAttempts = (count) =>
    page
      .locator(count ? `#play-attempts li:nth-child(${count})` : "#play-attempts:not(:has(li))")
      .waitFor({ state: "attached" });
  await page.locator("#make-name").fill("Ours");
  await page.locator("#make-name").press("Enter");
  await page.locator("#puzzle-name").filter({ hasText: "Ours" }).waitFor();
  await waitForAttempts(2);
  await page.locator("[data-adds=ball]").click();
  await waitForAttempts(0);
  await page.locator("#make-undo").click();
  await waitForAttempts(2);
});

test("the grid says how it went; a puzzle that is deleted takes its attempts along, and brings them back", async () => {
  const page = await played();
  await page.locator("#home").click();
  const words = page.locator("#custom-puzzles em");
  await words.filter({ hasText: "✓ solved, in 2 attempts" }).waitFor();
  await page
    .locator("#progress-words")
    .filter({ hasText: /^Of your own puzzles you have tried 1 and solved 1, in 2 attempts\.$/ })
    .waitFor();
  await page.locator('#custom-puzzles button[aria-label="Delete Mine"]').click();
  await page.locator("#notice-text").filter({ hasText: "is deleted" }).waitFor();
  assert.equal(await stored(page), null);
  await page.locator("#progress").waitFor({ state: "hidden" });
  await page.locator("#notice button", { hasText: "Undo" }).click();
  await words.filter({ hasText: "✓ solved, in 2 attempts" }).waitFor();
  await page.locator('#custom-puzzles a[href*="scene="]').click();
  await page.locator("#play-attempts li").nth(1).waitFor();
});

test("of two puzzles that differ in their names alone, one that is deleted leaves the attempts to the other", async () => {
  const page = await played();
  await page.locator("#home").click();
  const other = {
    name: "other.json",
    mimeType: "application/json",
    buffer: Buffer.from(
      JSON.stringify([
        { ...scene, name: "One" },
        { ...scene, name: "Other" },
      ]),
    ),
  };
  await page.locator("#custom-file").setInputFiles(other);
  await page.locator("#custom-puzzles li").nth(2).waitFor();
  await page.locator('#custom-puzzles button[aria-label="Delete Mine"]').click();
  await page.locator("#custom-puzzles li").nth(2).waitFor({ state: "detached" });
  assert.deepEqual(await page.locator("#custom-puzzles em").allTextContents(), [
    "✓ solved, in 2 attempts",
    "✓ solved, in 2 attempts",
  ]);
});

test("attempts are saved with the progress, and read back on another device, also from a file of attempts", async () => {
  const page = await played();
  const [lines] = await Promise.all([
    page.waitForEvent("download"),
    inMore(page, () => page.locator("#attempts-save").click()),
  ]);
  await page.locator("#home").click();
  const [progress] = await Promise.all([page.waitForEvent("download"), page.locator("#progress-save").click()]);
  assert.deepEqual(
    JSON.parse(await readFile(await progress.path(), "utf8")).attempts.map(({ scene, status }) => [
      /^[0-9a-f]{64}$/.test(scene),
      status,
    ]),
    [
      [true, "not_solved"],
      [true, "solved"],
    ],
  );
  for (const file of [progress, lines]) {
    const elsewhere = await session.open("/", { reducedMotion: "reduce" });
    await elsewhere.locator("#templates a").first().waitFor();
    await elsewhere.locator("#progress-file").setInputFiles(await file.path());
    await elsewhere.locator("#notice-text").filter({ hasText: "Loaded: 1 puzzle, with 2 attempts." }).waitFor();
    await elsewhere.goto(page.url().replace(/#.*/, await hashOf(elsewhere)));
    await elsewhere.locator("#play-attempts li").nth(1).waitFor();
  }
});

/** The fragment of the link to the puzzle. */
async function hashOf(page) {
  return `#scene=${await page.evaluate(async (scene) => (await import("/editor/scene-link.js")).textOfScene(scene), scene)}`;
}

test("attempts of two tabs stay both, and the grid of the other tab says so", async () => {
  const page = await openCustom();
  const other = await page.context().newPage();
  await other.emulateMedia({ reducedMotion: "reduce" });
  await other.goto(page.url());
  const grid = await page.context().newPage();
  await grid.goto(`${session.origin}/`);
  await grid.locator("#custom-puzzles a").waitFor();
  await run(page, balls.missing, /^Not solved/);
  await run(other, balls.solving, /^Solved/);
  await grid.locator("#custom-puzzles em").filter({ hasText: "✓ solved, in 2 attempts" }).waitFor();
  await page.reload();
  await page.locator("#play-attempts li").nth(1).waitFor();
});

test("a store that is full keeps the attempts as long as the page is open", async () => {
  const page = await openCustom();
  await page.evaluate(
    () =>
      (Storage.prototype.setItem = () => {
        throw new DOMException("full", "QuotaExceededError");
      }),
  );
  await run(page, balls.missing, /^Not solved/);
  await page.locator("#home").click();
  await page.locator("#custom-puzzles em").filter({ hasText: "× not solved, in 1 attempt" }).waitFor();
  await page.locator("#custom-puzzles a").click();
  await page.locator("#play-attempts li").waitFor();
  assert.equal(await attempts(page), 1);
});

test("of very many attempts at custom puzzles the oldest go", async () => {
  const page = await openCustom();
  const line = (digest, x) =>
    JSON.stringify({
      scene: digest.repeat(64),
      by: "player",
      ball: [x, 240, 8],
      status: "not_solved",
      steps: 900,
      simulator: 3,
    });
  const lines = [..."0123456789"].flatMap((digest) =>
    Array.from({ length: 100 }, (_, index) => line(digest, 20 + index)),
  );
  await page.evaluate((text) => localStorage.setItem("pathlight.attempts.own", text), lines.join("\n"));
  await run(page, balls.missing, /^Not solved/);
  const kept = (await stored(page))
    .trim()
    .split("\n")
    .map((one) => JSON.parse(one));
  assert.equal(kept.length, lines.length);
  assert.deepEqual([kept[0].ball[0], kept.at(-1).ball], [21, balls.missing]);
});
