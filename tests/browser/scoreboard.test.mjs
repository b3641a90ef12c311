// Player against model over all puzzles that both have played, kept on the device.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { EASY, known, openPanel, openPuzzle, playModelTurn, says, type } from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

const score = (page, words) => page.locator("#score-words", { hasText: words }).waitFor();

/** The player misses, then solves the puzzle, and the model plays. */
async function playBoth(page) {
  const { solving, missing } = await known();
  for (const ball of [missing, solving]) {
    await page.locator("#tab-play").click();
    await type(page, ball);
    await page.locator("#run").click();
    await says(page, /olved/);
  }
  await openPanel(page, "compare");
  await playModelTurn(page);
}

test("a puzzle counts once both have played, by the same measure, and is kept", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  await page.locator("#race-verdict", { hasText: "You first" }).waitFor();
  assert.ok(await page.locator("#score").isHidden());
  await playBoth(page);
  // PHYRE's value for one task that is solved on the second attempt.
  await score(page, /^Points over one puzzle: you 85, the model \d+$/);
  const kept = await page.locator("#score-words").textContent();
  await page.reload();
  await score(page, kept);
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
  await score(page, /^Points over 2 puzzles: you 50, the model 50$/);
});

test("a damaged store costs the score, not the page", async () => {
  const name = await modelName();
  for (const soup of ["soup", "[]", "null", '{"tasks":{"00001:001":{"attempts":"x"}}}', '{"tasks":7}']) {
    const page = await remembering({ "pathlight.progress": soup, [`pathlight.model.${name}`]: soup });
    assert.ok(await page.locator("#score").isHidden());
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
  await score(page, "over one puzzle");
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
  await score(page, /the model [0-9]$/);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await playModelTurn(page);
  await score(page, /the model [0-9]{2,3}$/);
});
