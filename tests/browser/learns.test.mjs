// "It learns while you watch": puzzles of a kind that is new to the model, one after the other, with a memory and
// without; paused, skipped, left, forgotten; by keyboard, without motion, and where the weights are missing.

import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { axeFindsNothing } from "./axe.mjs";
import { painted, start } from "./harness.mjs";

let session;
before(async () => (session = await start({ sources: true })));
after(() => session.stop());

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true };
/** A kind at which it needs few tries, so that a test is fast. */
const FAST = "Topple to the Wall";

const play = (page) => page.locator("#learns-play");
const played = (page) => page.locator("#learns-list li");
const status = (page) => page.locator("#learns-status");

async function open(options = {}) {
  const page = await session.open("/#view=learns", options);
  await page.locator("#learns-kinds input").first().waitFor();
  return page;
}

/** Waits until so many puzzles of a kind have been played. */
const until = (page, count) =>
  played(page)
    .nth(count - 1)
    .waitFor({ state: "attached", timeout: 120_000 });

/** Waits until the button says something. */
const says = (page, words) => play(page).filter({ hasText: words }).waitFor({ timeout: 120_000 });

test("from the home page: twenty puzzles, which take it fewer attempts than without memory", async () => {
  const page = await session.open("/");
  await page.locator("[data-pick=learns] a").click();
  await page.locator("#learns-kinds input").first().waitFor();
  assert.equal(await page.locator("#learns-kinds input").count(), 5);
  assert.equal(await page.locator("#learns-kinds label:has(:checked)").textContent(), "Cradle");
  assert.match(await page.title(), /^It learns while you watch/);
  assert.equal(await page.locator("#learns-memory").textContent(), "It remembers nothing yet.");
  await page.getByText("This is a single run in a fixed order, not an average.").waitFor();
  await play(page).click();
  await page.locator("#learns-finish").click();
  await until(page, 20);
  await says(page, "Play 20 more");
  const words = await page.locator("#learns-total").textContent();
  const [, learned, fresh] =
    /^In this one run, 20 puzzles took it ([\d,]+) attempts with its memory, and ([\d,]+) attempts without\.$/.exec(
      words,
    ) ?? [];
  const [withMemory, without] = [learned, fresh].map((number) => Number(number.replace(",", "")));
  assert.ok(withMemory < without, words);
  const rows = await played(page).allTextContents();
  assert.match(
    rows.join("\n"),
    /solved at once, helped by puzzle \d+\. Without memory: (on attempt|not solved in 100)/,
  );
  assert.equal(await page.locator("#learns-chart :is(circle, path.mark.learned)").count(), 20);
  assert.equal(await page.locator("#learns-chart :is(rect, path.mark.fresh)").count(), 20);
  assert.equal(await page.locator("#learns-memory").textContent(), "It remembers 20 puzzles.");
  await page.locator("#learns-puzzles summary").click();
  await axeFindsNothing(page, "after twenty puzzles");
  await played(page).first().locator("a").click();
  await page.locator("#compare:visible").waitFor();
  assert.match(page.url(), /task=00015:014&model=cross-0&panel=compare$/);
  await page.goBack();
  await says(page, "Play 20 more");
  assert.equal(await played(page).count(), 20, "what was played stays");
});

test("the tries at a puzzle are shown in short; it pauses, goes on, and skips to the next", async () => {
  const page = await open(PHONE);
  await play(page).tap();
  const tries = page.locator("#learns-fresh .tries");
  await tries.filter({ hasText: /^Attempt \d+$/ }).waitFor({ timeout: 120_000 });
  assert.equal(await played(page).count(), 0);
  await play(page).tap();
  await says(page, "Go on");
  const frame = () => page.locator("#learns-fresh canvas").evaluate((canvas) => canvas.toDataURL());
  const paused = await frame();
  await painted(page);
  assert.equal(await frame(), paused, "nothing moves");
  await page.locator("#learns-next").tap();
  await until(page, 1);
  await says(page, "Pause");
  await until(page, 2);
  assert.notEqual(await frame(), paused);
  assert.match(await status(page).textContent(), /^Puzzle \d: (solved|not solved)/);
});

test("another kind starts its own chart; all is forgotten at a press", async () => {
  const page = await open({ reducedMotion: "reduce" });
  const forget = page.locator("#learns-forget");
  assert.ok(await forget.isDisabled());
  await page.getByLabel(FAST).check();
  await play(page).click();
  await until(page, 2);
  await page.getByLabel("Over the Divide").check();
  await says(page, "Let it play 20");
  assert.equal(await played(page).count(), 0);
  await page.getByLabel(FAST).check();
  await says(page, /Play (18|17|16) more|Play 20 more/);
  assert.ok((await played(page).count()) >= 2);
  await forget.click();
  assert.equal(await status(page).textContent(), "It has forgotten everything.");
  assert.equal(await played(page).count(), 0);
  assert.ok(await forget.isDisabled());
  assert.ok(await play(page).evaluate((button) => button === document.activeElement));
});

test("by keyboard, with nothing that moves, in dark colours", async () => {
  const page = await open({ reducedMotion: "reduce", colorScheme: "dark" });
  await page.locator("#learns-kinds :checked").focus();
  for (const key of ["ArrowLeft", "ArrowLeft", "ArrowLeft"]) await page.keyboard.press(key);
  assert.equal(await page.locator("#learns-kinds label:has(:checked)").textContent(), FAST);
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  await page.keyboard.press("Tab");
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  await until(page, 20);
  await says(page, "Play 20 more");
  assert.equal(await page.evaluate(() => document.activeElement?.id), "learns-play", "the focus is not lost");
  await axeFindsNothing(page, "dark");
});

test("who leaves in the middle finds what was played, and the worker is let go", async () => {
  const page = await open();
  await page.getByLabel(FAST).check();
  await play(page).click();
  await page.locator("#learns-next").click();
  await until(page, 1);
  assert.equal(page.workers().length, 1);
  const [worker] = page.workers();
  const closed = worker.waitForEvent("close");
  await page.locator("#home").click();
  await closed;
  await page.goBack();
  await says(page, /^Play \d+ more$/);
  const before = await played(page).count();
  assert.ok(before >= 1);
  await play(page).click();
  await until(page, before + 1);
});

test("missing weights are named, and asked for again", async () => {
  const page = await session.open("");
  await page.route("**/cross-0.safetensors", (route) => route.abort());
  await page.goto(`${session.origin}/#view=learns`);
  await play(page).click();
  await page.locator("#learns-failure-words").filter({ hasText: "could not be loaded" }).waitFor();
  session.takeProblems();
  await page.unroute("**/cross-0.safetensors");
  await page.locator("#learns-retry").click();
  assert.ok(await page.locator("#learns-failure").isHidden());
  await play(page).click();
  await page.locator("#learns-next").click();
  await until(page, 1);
});

test("a link that hides the model or the puzzles does not show it", async () => {
  for (const hidden of ["imagine", "compare", "puzzles"]) {
    const page = await session.open(`/#view=learns&hide=${hidden}`);
    await page.locator(hidden === "puzzles" ? "#notice:visible" : "#gallery:visible").waitFor();
    assert.ok(await page.locator("#learns").isHidden());
    assert.ok(await page.locator("[data-pick=learns] a").isHidden());
  }
});

test("a carried run in the browser leaves the memory that it leaves in Node", async (context) => {
  /**
   * The memory after six puzzles of a kind. Runs in the page too.
   * @param {[api: string, options: object]} from
   */
  const memoryAfter = async ([api, options]) => {
    const { load } = await import(api);
    const pathlight = await load(options);
    const memory = pathlight.memory();
    const { tasks } = pathlight.templates()[14];
    for (const task of tasks.slice(0, 6)) Array.from(pathlight.turn(task, { memory }));
    return memory.toJson();
  };
  const root = new URL("../../", import.meta.url);
  const weights = await readFile(new URL("assets/cross-0.safetensors", root));
  const page = await session.open("/");
  const inPage = await page.evaluate(memoryAfter, ["/api/index.js", { model: "cross-0" }]);
  const inNode = await memoryAfter([new URL("www/api/index.js", root).href, { weights }]);
  assert.equal(inPage, inNode);
  assert.ok(JSON.parse(inNode).puzzles.length === 6);
  context.diagnostic(`SHA-256 of the memory: ${createHash("sha256").update(inNode).digest("hex")}`);
});
