// Player against model over all puzzles that both have played, kept on the device.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { EASY, known, openPuzzle, playModelTurn, says, type } from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

const rows = (page) => page.locator("#score-rows tr");

/** The player misses, then solves the puzzle, and the model plays. */
async function playBoth(page) {
  const { solving, missing } = await known();
  for (const ball of [missing, solving]) {
    await page.locator("#tab-play").click();
    await type(page, ball);
    await page.locator("#run").click();
    await says(page, /olved/);
  }
  await page.locator("#tab-compare").click();
  await playModelTurn(page);
}

test("a puzzle counts once both have played, by the same measure, and is kept", async () => {
  const page = await openPuzzle(session, { fragment: "&panel=compare", reducedMotion: true });
  await page.locator("#score-empty:visible").waitFor();
  await playBoth(page);
  assert.equal(await rows(page).count(), 1);
  assert.equal(await rows(page).locator("th").textContent(), "Two Drops, 1 of 100");
  assert.equal(await rows(page).locator("td").first().textContent(), "✓ on attempt 2");
  const made = await page.locator("#model-attempts li").count();
  assert.match(await rows(page).locator("td").last().textContent(), new RegExp(`^(✓ on attempt|× in) ${made}$`));
  // PHYRE's value for one task that is solved on the second attempt.
  assert.equal(Number(await page.locator("#score-player").textContent()).toFixed(0), "85");
  // The link follows a moment later.
  await page.waitForURL(/panel=compare/);
  const kept = await page.locator("#score-table").innerText();
  await page.reload();
  await page.locator("#score-table:visible").waitFor();
  assert.equal(await page.locator("#score-table").innerText(), kept);
});

/** A page on a device that remembers this. */
async function remembering(entries) {
  const localStorage = Object.entries(entries).map(([name, value]) => ({ name, value }));
  const storageState = { cookies: [], origins: [{ origin: session.origin, localStorage }] };
  const page = await openPuzzle(session, { fragment: "&panel=compare", storageState });
  await page.locator("#model-turn:enabled").waitFor();
  return page;
}

const record = (tasks) => JSON.stringify({ tasks });

test("what one has not solved counts nothing for it, and what only one has played does not count", async () => {
  const name = await modelName();
  const page = await remembering({
    "pathlight.progress": record({
      "00001:001": { attempts: 1, solved: 1 },
      "00001:002": { attempts: 7, solved: null },
      "00003:003": { attempts: 3, solved: 3 },
    }),
    [`pathlight.model.${name}`]: record({
      "00001:001": { attempts: 100, solved: null },
      "00001:002": { attempts: 1, solved: 1 },
      "00009:009": { attempts: 1, solved: 1 },
    }),
  });
  await page.locator("#score-table:visible").waitFor();
  assert.deepEqual(await rows(page).locator("th").allTextContents(), [
    "Tray with Lips, 2 of 100",
    "Tray with Lips, 3 of 100",
  ]);
  assert.equal(await page.locator("#score-player").textContent(), "50.0");
  assert.equal(await page.locator("#score-model").textContent(), "50.0");
  assert.deepEqual(await rows(page).first().locator("td").allTextContents(), ["✓ on attempt 1", "× in 100"]);
  // The model that the address names is kept on the way to another puzzle.
  await page.goto(`${session.origin}/#task=${EASY}&panel=compare&model=${name}`);
  await page.locator(`#score-rows a[href*="task=00001:001"][href*="model=${name}"]`).waitFor();
});

test("a damaged store costs the score, not the page", async () => {
  const name = await modelName();
  for (const soup of ["soup", "[]", "null", '{"tasks":{"00001:001":{"attempts":"x"}}}', '{"tasks":7}']) {
    const page = await remembering({ "pathlight.progress": soup, [`pathlight.model.${name}`]: soup });
    await page.locator("#score-empty:visible").waitFor();
    await page.context().close();
  }
});

test("a store that is forbidden does not stop anybody", async () => {
  const page = await openPuzzle(session, { fragment: "&panel=compare", reducedMotion: true });
  await page.addInitScript(() =>
    Object.defineProperty(window, "localStorage", {
      get() {
        throw new DOMException("no", "SecurityError");
      },
    }),
  );
  await page.reload();
  await page.locator("#model-turn:enabled").waitFor();
  await playBoth(page);
  assert.equal(await rows(page).count(), 1);
});

async function modelName() {
  const answer = await fetch(`${session.origin}/assets/model.json`);
  return (await answer.json()).models[0].name;
}

test("a turn that has ended takes the place of a longer one of older agents", async () => {
  const name = await modelName();
  const page = await remembering({
    "pathlight.progress": record({ [EASY]: { attempts: 1, solved: 1 } }),
    [`pathlight.model.${name}`]: record({ [EASY]: { attempts: 90, solved: 90 } }),
  });
  assert.equal(await rows(page).locator("td").last().textContent(), "✓ on attempt 90");
  await page.emulateMedia({ reducedMotion: "reduce" });
  await playModelTurn(page);
  const made = await page.locator("#model-attempts li").count();
  await rows(page)
    .locator("td")
    .last()
    .filter({ hasText: `✓ on attempt ${made}` })
    .waitFor();
  assert.ok(made < 90);
});
