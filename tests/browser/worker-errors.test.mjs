// The worker answers a call with an error: the panel that called says so, and can call again. After a trap or a panic
// in the wasm the worker is not used again, because its memory is in no known state.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { wait } from "./embedding.mjs";
import { start } from "./harness.mjs";
import { inMore, openPanel, openPuzzle, pause } from "./page-actions.mjs";

let session;
before(async () => (session = await start({ sources: true })));
after(() => session.stop());

/** Opens a puzzle whose first worker throws once at a call of this name: the first, or after some that go well. */
async function openFailing(call, error, fragment, well = 0) {
  const page = await session.open("");
  await page.context().route(
    "**/model/worker.js",
    async (route) => {
      const response = await route.fetch();
      const failing = `{
        const { ${call} } = calls;
        let well = ${well};
        calls.${call} = (...args) => {
          if (well-- > 0) return ${call}(...args);
          calls.${call} = ${call};
          throw ${error};
        };
      }`;
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

test("balls that cannot be saved are not saved later unasked, and are when the person asks again", async () => {
  const page = await openFailing("propose", FAILURE, "&panel=imagine");
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
  /** @type {string[]} */
  const saved = [];
  page.on("download", (file) => saved.push(file.suggestedFilename()));
  const announced = (words) => page.locator("#announcement").filter({ hasText: words }).waitFor();
  const save = () => inMore(page, () => page.locator("#proposal-save").click());
  await save();
  await announced("the soup is cold");
  await openPanel(page, "compare");
  await trouble(page, "proposals-trouble").getByRole("button", { name: "Try again" }).click();
  await page.locator("#proposals:visible").waitFor();
  assert.deepEqual(saved, []);
  await Promise.all([page.waitForEvent("download"), save()]);
});

test("whoever asks for the balls after the maps have failed gets them", async () => {
  const page = await openFailing("imagine", FAILURE, "&panel=imagine");
  await trouble(page, "imagine-trouble").waitFor();
  await Promise.all([page.waitForEvent("download"), inMore(page, () => page.locator("#proposal-save").click())]);
});

test("whoever asks for the balls of a model that has stopped starts it again", async () => {
  const page = await openFailing("imagine", "new WebAssembly.RuntimeError('unreachable')", "&panel=imagine");
  await page.locator("#imagine-trouble:visible").filter({ hasText: "model has stopped" }).waitFor();
  await Promise.all([
    page.waitForEvent("download"),
    inMore(page, async () => {
      await page.locator("#proposal-save").click();
      await page.locator("#announcement").filter({ hasText: "still loading" }).waitFor({ state: "attached" });
    }),
  ]);
});

test("an error while attempts are checked leaves no button, and nobody is said to have stopped", async () => {
  const page = await openFailing("verify", FAILURE, "&panel=imagine", 1);
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
  const buffer = Buffer.from('{"beach":true}\n'.repeat(60));
  await page.locator("#attempts-file").setInputFiles({ name: "beach.jsonl", mimeType: "application/jsonl", buffer });
  const words = page.locator("#attempts-words");
  await words.filter({ hasText: "the soup is cold" }).waitFor({ state: "attached" });
  const [said, listed] = [await words.textContent(), page.locator("#attempts-read")];
  assert.match(said, /^beach\.jsonl: 0 of 50 attempts come out the same to the bit\. /);
  assert.deepEqual([await listed.locator("li").count(), await listed.locator("button").count()], [50, 0]);
  await page.locator("#next").click();
  assert.equal(await words.textContent(), said, "also after the puzzle has been left");
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
    await wait(() => page.workers().length === 0, "the worker ends");
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
