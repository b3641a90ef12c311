// Weights that do not come, break off, are changed by a bit, or come slowly, and wasm that does not come: the page says
// so, the person plays on where there is wasm, and once the fault is gone a button brings what was missing.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { startFaultyProxy } from "./faulty-proxy.mjs";
import { start } from "./harness.mjs";
import { assertConsistent } from "./invariants.mjs";
import { EASY, attempts, ball, known, says, type } from "./page-actions.mjs";

const WEIGHTS = /\.safetensors$/;
const WASM = /\.wasm$/;

let session, proxy, balls;
before(async () => {
  session = await start();
  proxy = await startFaultyProxy(session.origin);
  balls = await known();
});
after(async () => {
  await session.stop();
  await proxy.stop();
});

/** Opens a puzzle through the proxy, with a fault. */
async function openWith(fault, fragment = "") {
  proxy.fault = fault;
  const page = await session.open("", { reducedMotion: "reduce" });
  await page.goto(`${proxy.origin}/#task=${EASY}${fragment}`);
  return page;
}

/** Plays a ball that solves; it is the n-th attempt. */
async function solves(page, count) {
  await page.locator("#tab-play").click();
  await type(page, balls.solving);
  await page.locator("#run").click();
  await says(page, /^Solved!/);
  assert.equal(await attempts(page), count);
  await assertConsistent(page);
}

const imagined = (page) =>
  page
    .locator("#imagined-in")
    .filter({ hasText: /Imagined in [\d,]+ ms/ })
    .waitFor({ timeout: 60_000 });

/** The browser itself tells of what it could not load. */
function assertOnlyNetwork() {
  const problems = session.takeProblems();
  assert.ok(
    problems.every((problem) => /Failed to load resource|net::ERR_|preload/.test(problem)),
    problems.join("\n"),
  );
}

for (const { kind, words } of /** @type {const} */ ([
  { kind: "gone", words: "could not be loaded" },
  { kind: "cut", words: "could not be loaded" },
  { kind: "bit", words: "it is damaged or old" },
])) {
  test(`weights with the fault “${kind}”`, async () => {
    const page = await openWith({ path: WEIGHTS, kind }, "&panel=imagine");
    await page.locator("#imagine-trouble:visible").filter({ hasText: words }).waitFor();
    await solves(page, 1);
    proxy.fault = null;
    await page.locator("#tab-imagine").click();
    await page.locator("#imagine-trouble").getByRole("button", { name: "Try again" }).click();
    await imagined(page);
    assert.equal(await attempts(page), 1);
    await assertConsistent(page);
    assertOnlyNetwork();
  });
}

test("weights over a slow line: how far they are is seen, and the puzzle plays meanwhile", async () => {
  const page = await openWith({ path: WEIGHTS, kind: "slow" }, "&panel=imagine");
  const progress = page.locator("#imagine-loading progress");
  await page.locator("#imagine-loading:visible").waitFor();
  const value = () => progress.evaluate((element) => /** @type {HTMLProgressElement} */ (element).value);
  await page.waitForFunction(
    () =>
      Number(
        /** @type {any} */ (document.getElementById("puzzle")).shadowRoot.querySelector("#imagine-loading progress")
          .value,
      ) > 0,
  );
  const before = await value();
  await solves(page, 1);
  await page.locator("#solved-next").click();
  await page.locator("#previous").click();
  assert.equal(await attempts(page), 1);
  await page.locator("#tab-imagine").click();
  assert.ok((await value()) > before, "the progress goes on");
  proxy.fault = null;
  await imagined(page);
  await assertConsistent(page);
});

for (const kind of /** @type {const} */ (["gone", "cut", "bit"])) {
  test(`wasm with the fault “${kind}”`, async () => {
    const page = await openWith({ path: WASM, kind }, "&ball=100,200,10");
    const notice = page.locator("#notice:visible");
    await notice.filter({ hasText: kind === "bit" ? "the file is damaged" : "wasm could not be loaded" }).waitFor();
    assert.ok(await page.locator("#puzzle").isHidden());
    proxy.fault = null;
    await notice.getByRole("button", { name: "Try again" }).click();
    await page.locator("#scene").waitFor();
    assert.deepEqual(await ball(page), [100, 200, 10]);
    await solves(page, 1);
    assertOnlyNetwork();
  });
}

test("wasm and weights damaged once are asked for again, past the caches, without a word", async () => {
  for (const path of [WASM, WEIGHTS]) {
    const page = await openWith({ path, kind: "bit once" }, "&panel=imagine");
    await imagined(page);
    assert.equal(proxy.fault, null);
    assert.ok(await page.locator("#notice").isHidden());
    await assertConsistent(page);
  }
});
