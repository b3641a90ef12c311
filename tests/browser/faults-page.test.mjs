// What breaks in the browser itself: traps, a worker that is killed in the middle of a turn, a store that is denied,
// full or full of garbage, an hour asleep, canvases without memory. The page goes on, and the person's attempts are
// kept.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { assertConsistent } from "./invariants.mjs";
import {
  EASY,
  attempts,
  known,
  modelLoaded,
  openPanel,
  openPuzzle,
  picture,
  playModelTurn,
  says,
  type,
  unsolvedTask,
} from "./page-actions.mjs";

let session, balls;
before(async () => {
  session = await start({ sources: true });
  balls = await known();
});
after(() => session.stop());

/** Opens a puzzle in a page in which `spoil` runs before any other script. */
async function openSpoilt(spoil, options = {}) {
  const context = await session.browser.newContext({ reducedMotion: "reduce", ...options });
  await context.addInitScript(spoil);
  const page = await session.openIn(context, `/#task=${EASY}`);
  await page.locator("#scene").waitFor();
  return page;
}

async function run(page, ball, words) {
  if (await page.locator("#reset").isEnabled()) await page.locator("#reset").click();
  await type(page, ball);
  await page.locator("#run").click();
  await says(page, words);
}

/** A miss and a solution. */
async function play(page) {
  await run(page, balls.missing, /^Not solved/);
  await run(page, balls.solving, /^Solved!/);
}

test("a trap in the page’s wasm is a sentence; the page loads anew with all attempts", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  await play(page);
  await page.evaluate(async () => {
    const { Game } = await import("/pkg/pathlight.js");
    Game.prototype.watch = () => {
      throw new WebAssembly.RuntimeError("unreachable");
    };
  });
  await page.locator("#watch").click();
  const notice = page.locator("#notice:visible").filter({ hasText: /broke: unreachable/ });
  await notice.getByRole("button", { name: "Load it again" }).click();
  await page.locator("#notice").waitFor({ state: "hidden" });
  await page.locator("#play-attempts li").nth(1).waitFor();
  await assertConsistent(page);
  await page.locator("#watch").click();
  await says(page, /without a ball/);
  assert.match(session.takeProblems().join(), /unreachable/);
});

test("a worker that is killed in the middle of a turn: what it has tried stays, another one goes on", async () => {
  const page = await openPuzzle(session, { task: await unsolvedTask(), fragment: "&panel=compare" });
  await page.locator("#model-turn:enabled").click();
  await page.locator("#model-attempts li").nth(2).waitFor({ timeout: 60_000 });
  await page.workers()[0].evaluate(
    () =>
      void setTimeout(() => {
        throw new Error("killed");
      }),
  );
  const trouble = page.locator("#compare-trouble:visible").filter({ hasText: /model has stopped.*killed/ });
  await trouble.waitFor();
  await assertConsistent(page);
  await trouble.getByRole("button", { name: "Try again" }).click();
  await playModelTurn(page);
  assert.equal(await page.locator("#model-attempts li").count(), 100);
  await assertConsistent(page);
  session.takeProblems();
});

for (const { what, spoil } of [
  {
    what: "denied",
    spoil: () =>
      Object.defineProperty(window, "localStorage", {
        get: () => {
          throw new DOMException("The operation is insecure.", "SecurityError");
        },
      }),
  },
  {
    what: "full",
    spoil: () => {
      Storage.prototype.setItem = () => {
        throw new DOMException("The quota has been exceeded.", "QuotaExceededError");
      };
    },
  },
]) {
  test(`a store that is ${what}: attempts last as long as the page`, async () => {
    const page = await openSpoilt(spoil);
    await play(page);
    await page.locator("#next").click();
    assert.equal(await attempts(page), 0);
    await page.locator("#previous").click();
    assert.equal(await attempts(page), 2);
    await page.locator("#home").click();
    await page
      .locator("#progress-words")
      .filter({ hasText: /solved 1/ })
      .waitFor();
  });
}

test("a store that becomes full hides nothing that it holds, and can be cleared", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  await play(page);
  await page.reload();
  await page.evaluate(
    () =>
      void (Storage.prototype.setItem = () => {
        throw new DOMException("The quota has been exceeded.", "QuotaExceededError");
      }),
  );
  await page.locator("#next").click();
  await run(page, balls.missing, /./);
  await page.locator("#previous").click();
  assert.equal(await attempts(page), 2);
  await page.locator("#next").click();
  await page.locator("#home").click();
  await page.locator("#progress-forget").click();
  await page.locator("#forget-dialog button[value=forget]").click();
  await page.reload();
  await page.locator("#templates a").first().waitFor();
  assert.ok(await page.locator("#progress").isHidden());
  await page.goto(`${session.origin}/#task=${EASY}`);
  assert.equal(await attempts(page), 0);
});

test("a store with garbage, and with what another version has written", async () => {
  const page = await openSpoilt(() => {
    if (localStorage.length > 0) return;
    const line = { task: "00000:000", by: "player", ball: [1, 2], status: "melted", steps: -1 };
    for (const [key, text] of Object.entries({
      "pathlight.progress": '{"tasks":{"00000:000":{"attempts":"many"},"soup":1},"version":9}',
      "pathlight.attempts.00000:000": `soup\n${JSON.stringify(line)}\n${JSON.stringify({ ...line, ball: [1e9, -5, 3], status: "solved", steps: 5 })}\n{"task":"00000:000","version":9}`,
      "pathlight.attempts.soup": "\u0000",
      "pathlight.model.within-0": "[]",
      "pathlight.puzzles": "soup",
      "pathlight.guide": "{",
    }))
      localStorage.setItem(key, text);
  });
  assert.equal(await attempts(page), 0);
  await play(page);
  await page.reload();
  await page.locator("#play-attempts li").nth(1).waitFor();
  await openPanel(page, "compare");
  await playModelTurn(page);
  await page.locator("#home").click();
  await page
    .locator("#progress-words")
    .filter({ hasText: /solved 1/ })
    .waitFor();
});

test("an hour asleep, and the clock moved by years: an attempt has run to its end, and the page goes on", async () => {
  const page = await session.open("");
  await page.clock.install();
  await page.goto(`${session.origin}/#task=${EASY}`);
  await page.locator("#scene").waitFor();
  await type(page, balls.missing);
  await page.locator("#run").click();
  await says(page, /is running/);
  await page.clock.setSystemTime(new Date("2099-12-31"));
  await page.clock.fastForward("01:00:00");
  await page.clock.runFor(100);
  await says(page, /^Not solved/);
  assert.equal(await attempts(page), 1);
  await page.clock.setSystemTime(new Date("2001-01-01"));
  await page.emulateMedia({ reducedMotion: "reduce" });
  await run(page, balls.solving, /^Solved!/);
  assert.equal(await attempts(page), 2);
  await assertConsistent(page);
});

test("an hour asleep in the middle of the model’s turn", async () => {
  const page = await session.open("");
  await page.clock.install();
  await page.goto(`${session.origin}/#task=${await unsolvedTask()}&panel=compare`);
  await page.locator("#model-turn:enabled").click();
  await page.locator("#model-attempts li").nth(2).waitFor({ timeout: 60_000 });
  await page.clock.fastForward("01:00:00");
  await page.locator("#model-turn").filter({ hasText: "The model has played" }).waitFor({ timeout: 120_000 });
  await assertConsistent(page);
});

test("canvases without memory: a sentence says so, and what to do", async () => {
  const context = await session.browser.newContext();
  await context.addInitScript(() => void (HTMLCanvasElement.prototype.getContext = () => null));
  const sentence = (page) =>
    page
      .getByText(/no canvas to draw on.*load the page again/i)
      .first()
      .waitFor();
  const page = await session.openIn(context, `/#task=${EASY}`);
  await sentence(page);
  // It stays when the rest of the page comes later.
  let late = false;
  await context.route("**/page/page.js", async (route) => {
    await sentence(page);
    late = true;
    await route.continue();
  });
  const loaded = page.waitForResponse("**/page/page.js");
  await page.reload({ waitUntil: "commit" });
  await loaded;
  assert.ok(late);
  await page.locator("#title").waitFor();
  await sentence(page);
  session.takeProblems();
});

test("a scene whose canvas the browser has emptied is drawn again", async () => {
  const page = await openPuzzle(session);
  await modelLoaded(page);
  const before = await picture(page);
  await page.locator("#scene").evaluate((canvas) => {
    canvas.getContext("2d").reset();
    canvas.dispatchEvent(new Event("contextrestored"));
  });
  assert.equal(await picture(page), before);
});
