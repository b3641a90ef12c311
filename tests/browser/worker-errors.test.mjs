// The worker answers a call with an error: the panel that called says so, and can call again. After a trap or a panic
// in the wasm the worker is not used again, because its memory is in no known state.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { openPuzzle, pause } from "./page-actions.mjs";

let session;
before(async () => (session = await start({ sources: true })));
after(() => session.stop());

/** Opens a puzzle whose first worker throws at the first call of this name. */
async function openFailing(call, error, fragment) {
  const page = await session.open("");
  await page.context().route(
    "**/model/worker.js",
    async (route) => {
      const response = await route.fetch();
      const failing = `{ const { ${call} } = calls; calls.${call} = () => { calls.${call} = ${call}; throw ${error}; }; }`;
      await route.fulfill({ response, body: `${await response.text()}\n${failing}` });
    },
    { times: 1 },
  );
  await page.goto(`${session.origin}/#task=00000:000${fragment}`);
  return page;
}

const FAILURE = "new Error('the soup is cold')";
const trouble = (page, id) => page.locator(`#${id}:visible`).filter({ hasText: "the soup is cold" });

test("an error for the maps", async () => {
  const page = await openFailing("imagine", FAILURE, "&panel=imagine");
  await trouble(page, "imagine-trouble").getByRole("button", { name: "Try again" }).click();
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
  await page.locator("#imagine-trouble").waitFor({ state: "hidden" });
});

test("an error in the turn", async () => {
  const page = await openFailing("turn", FAILURE, "&panel=compare");
  await page.locator("#model-turn:enabled").click();
  await trouble(page, "compare-trouble").getByRole("button", { name: "Try again" }).click();
  await page.locator("#model-turn").filter({ hasText: "The model has played" }).waitFor({ timeout: 120_000 });
  assert.ok(await page.locator("#compare-trouble").isHidden());
});

test("an error for the proposals", async () => {
  const page = await openFailing("propose", FAILURE, "&panel=compare");
  await trouble(page, "proposals-trouble").getByRole("button", { name: "Try again" }).click();
  await page.locator("#proposals:visible").waitFor();
  assert.ok(await page.locator("#proposals-trouble").isHidden());
});

test("an error in the search for all solutions", async () => {
  const page = await openFailing("solve", FAILURE, "&panel=map&ball=128,200,32");
  await page.locator("#solve-map-search").click();
  await trouble(page, "solve-map-words").waitFor();
  await page.locator("#solve-map-search").filter({ hasText: "Try every place" }).click();
  await page.locator("#solve-map-words").filter({ hasText: "tried" }).waitFor();
});

for (const { what, error, words } of [
  { what: "trapped", error: "new WebAssembly.RuntimeError('unreachable')", words: "model has stopped (unreachable)" },
  {
    what: "panicked",
    error: "Object.assign(new Error('no such cell'), { code: 'panic' })",
    words: "model has stopped (no such cell)",
  },
]) {
  test(`a worker whose wasm has ${what} is not used again`, async () => {
    const page = await openFailing("propose", error, "&panel=compare");
    const box = page.locator("#compare-trouble:visible").filter({ hasText: words });
    await box.waitFor();
    assert.equal(page.workers().length, 0);
    await box.getByRole("button", { name: "Try again" }).click();
    await page.locator("#proposals:visible").waitFor();
    assert.equal(page.workers().length, 1);
  });
}

test("a search after a trap starts another worker", async () => {
  const page = await openFailing(
    "imagine",
    "new WebAssembly.RuntimeError('unreachable')",
    "&panel=map&ball=128,200,32",
  );
  await page.locator("#imagine-trouble").filter({ hasText: "model has stopped" }).waitFor({ state: "attached" });
  await page.locator("#solve-map-search").click();
  await page.locator("#solve-map-words").filter({ hasText: "tried" }).waitFor();
});

test("a late answer to a puzzle that was left is dropped", async () => {
  const page = await openPuzzle(session, { fragment: "&panel=imagine" });
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
  const labels = () =>
    page.locator("#maps canvas[role=img]").evaluateAll((maps) => maps.map((map) => map.getAttribute("aria-label")));
  await page.evaluate(() => {
    for (const task of ["00007:008", "00011:004", "00000:000"]) {
      history.pushState(null, "", `#task=${task}&panel=imagine`);
      dispatchEvent(new PopStateEvent("popstate"));
    }
  });
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
  const settled = await labels();
  await pause(page);
  assert.deepEqual(await labels(), settled);
  const fresh = await openPuzzle(session, { fragment: "&panel=imagine" });
  await fresh.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
  assert.deepEqual(
    settled,
    await fresh
      .locator("#maps canvas[role=img]")
      .evaluateAll((maps) => maps.map((map) => map.getAttribute("aria-label"))),
  );
});
