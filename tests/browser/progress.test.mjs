// What was tried and solved is kept on the device, shown on the grid and in the picker, saved to a file and cleared;
// a store that is damaged or forbidden never breaks the page.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import {
  EASY,
  attempts,
  known,
  modelLoaded,
  openPanel,
  openPuzzle,
  playModelTurn,
  says,
  type,
} from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

const KEY = "pathlight.progress";
const label = (page, task = EASY) => page.locator(`#task option[value="${task}"]`).textContent();
const mark = (page) => page.locator("#templates li").first().locator("em");

async function run(page, ball, words) {
  await type(page, ball);
  await page.locator("#run").click();
  await says(page, words);
}

/** A miss, then a solution, on the easy puzzle. */
async function played(page) {
  const { missing, solving } = await known();
  await run(page, missing, /^Not solved/);
  assert.equal(await label(page), "1: missed, 1 try");
  await page.locator("#reset").click();
  await run(page, solving, /^Solved/);
  assert.equal(await label(page), "1: solved at try 2");
}

test("progress is told on the grid and in the picker, and outlasts the page", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  await played(page);
  await page.locator("#home").click();
  assert.equal(await mark(page).textContent(), "✓ 1 of 100 solved, in 2 attempts");
  await page.reload();
  await page
    .locator("#progress:visible")
    .filter({ hasText: "So far you have tried 1 puzzle and solved 1, in 2 attempts." })
    .waitFor();
  assert.equal(await mark(page).textContent(), "✓ 1 of 100 solved, in 2 attempts");
  await page.locator("#templates a").first().click();
  assert.equal(await label(page), "1: solved at try 2");
});

test("the picker shows its whole words", async () => {
  for (const viewport of [
    { width: 1280, height: 800 },
    { width: 390, height: 844 },
  ]) {
    const page = await openPuzzle(session, { reducedMotion: true, viewport });
    const { missing } = await known();
    await run(page, missing, /^Not solved/);
    const room = await page.locator("#task").evaluate((select) => {
      const style = getComputedStyle(select);
      const context = new OffscreenCanvas(1, 1).getContext("2d");
      if (!context) throw new Error("no 2D canvas");
      context.font = `${style.fontSize} ${style.fontFamily}`;
      const words = (select.selectedOptions[0].textContent ?? "").replace(/^1/, "97").replace(/1$/, "12");
      // The arrow takes some 20 px.
      return select.clientWidth - 20 - parseFloat(style.paddingLeft) - context.measureText(words).width;
    });
    assert.ok(room >= 0, `${viewport.width} px: ${room} px too few`);
  }
});

test("an attempt is not told before it has run, and counts when it is left", async () => {
  const page = await openPuzzle(session);
  const { solving } = await known();
  await run(page, solving, /is running/);
  assert.equal(await label(page), "1 of 100");
  await page.locator("#next").click();
  await page.locator("#previous").click();
  assert.equal(await label(page), "1: solved at try 1");
  assert.equal(await attempts(page), 1);
});

test("another tab’s attempts are seen, and added to", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  const other = await page.context().newPage();
  await other.goto(page.url());
  const { missing, solving } = await known();
  await run(page, missing, /^Not solved/);
  await other.locator("#task option:checked").filter({ hasText: "1: missed, 1 try" }).waitFor({ state: "attached" });
  await other.emulateMedia({ reducedMotion: "reduce" });
  await run(other, solving, /^Solved/);
  assert.equal(await label(other), "1: solved at try 2");
});

test("progress is saved to a file, and forgotten only when the person is sure", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  await played(page);
  await page.locator("#home").click();
  const [file] = await Promise.all([page.waitForEvent("download"), page.locator("#progress-save").click()]);
  assert.equal(file.suggestedFilename(), "pathlight-progress.json");
  assert.deepEqual(JSON.parse(await readFile(await file.path(), "utf8")).tasks, { [EASY]: { attempts: 2, solved: 2 } });

  await page.locator("#progress-forget").click();
  await page.keyboard.press("Escape");
  assert.ok(await page.locator("#progress").isVisible());
  await page.locator("#progress-forget").click();
  await page.locator("#forget-dialog button[value=keep]").click();
  assert.ok(await page.locator("#progress").isVisible());
  await page.locator("#progress-forget").click();
  // At once: whoever leaves the page now means it too.
  const left = await page.locator("#forget-dialog button[value=forget]").evaluate((button) => {
    /** @type {HTMLButtonElement} */ (button).click();
    // How a person likes the page is no attempt.
    return Object.keys(localStorage).filter((key) => !/guess|story/.test(key));
  });
  assert.deepEqual(left, []);
  await page.locator("#progress").waitFor({ state: "hidden" });
  assert.equal(await mark(page).textContent(), "");

  // The answer of the time before does not count.
  await page.locator("#templates a").first().click();
  await run(page, (await known()).missing, /^Not solved/);
  await page.locator("#home").click();
  await page.locator("#progress-forget").click();
  await page.keyboard.press("Escape");
  assert.ok((await page.locator("#forget-dialog").isHidden()) && (await page.locator("#progress").isVisible()));
});

test("what is forgotten are the models’ attempts too, also what older versions have counted", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  await page.evaluate(() =>
    localStorage.setItem("pathlight.model.cross-0", '{"tasks":{"00001:001":{"attempts":3,"solved":3}}}'),
  );
  await page.reload();
  await modelLoaded(page);
  await type(page, (await known()).missing);
  await page.locator("#run").click();
  await says(page, /^Not solved/);
  await openPanel(page, "compare");
  await playModelTurn(page);
  await page.locator("#home").click();
  const saved = async () => {
    const [file] = await Promise.all([page.waitForEvent("download"), page.locator("#progress-save").click()]);
    return JSON.parse(await readFile(await file.path(), "utf8"));
  };
  assert.deepEqual(Object.keys((await saved()).models), ["cross-0", "within-0"]);
  await page.locator("#progress-forget").click();
  await page.locator("#forget-dialog button[value=forget]").click();
  assert.deepEqual(await page.evaluate(() => Object.keys(localStorage).filter((key) => !/guess|story/.test(key))), []);
  await page.reload();
  await page.locator("#templates a").first().click();
  await run(page, (await known()).missing, /^Not solved/);
  await page.locator("#home").click();
  assert.deepEqual((await saved()).models, {});
});

for (const [what, kept, tried] of [
  ["no JSON", '{"tasks": {', 0],
  ["another form", "[1, 2]", 0],
  ["nothing", "null", 0],
  [
    "partly nonsense",
    JSON.stringify({
      tasks: {
        [EASY]: { attempts: 2, solved: null },
        soup: { attempts: 1, solved: 1 },
        "00001:000": { attempts: 1, solved: 7 },
        "00002:000": null,
        "00003:000": { attempts: -1e99, solved: null },
      },
    }),
    1,
  ],
]) {
  test(`a store that holds ${what} does no harm`, async () => {
    const page = await session.open("/");
    await page.evaluate(([key, kept]) => localStorage.setItem(key, kept), [KEY, kept]);
    await page.reload();
    await page.locator("#templates a").first().waitFor();
    assert.equal((await page.locator("#templates em").allTextContents()).filter(Boolean).length, tried);
    await page.emulateMedia({ reducedMotion: "reduce" });
    await page.locator("#templates a").first().click();
    await run(page, (await known()).solving, /^Solved/);
    assert.equal(await label(page), `1: solved at try ${tried ? 3 : 1}`);
  });
}

for (const [what, words, forbid] of [
  [
    "asked",
    "does not let the page store anything",
    () =>
      Object.defineProperty(globalThis, "localStorage", {
        get: () => {
          throw new DOMException("no", "SecurityError");
        },
      }),
  ],
  [
    "written",
    "has no room left: 2 attempts are lost when you close the page",
    () => {
      Storage.prototype.setItem = () => {
        throw new DOMException("full", "QuotaExceededError");
      };
    },
  ],
]) {
  test(`a store that may not be ${what} lasts as long as the page, which says so`, async () => {
    const page = await session.open(`/#task=${EASY}`, { reducedMotion: "reduce" });
    await page.addInitScript(forbid);
    await page.reload();
    await page.locator("#scene").waitFor();
    await played(page);
    await page.locator("#home").click();
    await page.locator("#progress:visible").filter({ hasText: words }).waitFor();
    assert.equal(await mark(page).textContent(), "✓ 1 of 100 solved, in 2 attempts");
    assert.ok(await page.locator("#notice").isHidden());
  });
}
