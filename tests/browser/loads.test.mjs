// The page loads: served by the real binary, its wasm compiled, and without errors in the console.

import assert from "node:assert/strict";
import { mkdtemp, rm } from "node:fs/promises";
import { get } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { writeBundledPage } from "../../scripts/bundle-page.mjs";
import { start } from "./harness.mjs";
import { EASY, assertPolicyHolds, known, openImagined, says, type } from "./page-actions.mjs";

/** The sources as they are. */
let session;
/** What `make play` serves. */
let bundled;
let folder;
before(async () => {
  session = await start({ sources: true });
  folder = await mkdtemp(join(tmpdir(), "pathlight-"));
  await writeBundledPage(folder);
  bundled = await start({ serve: ["--dir", folder] });
});
after(async () => {
  await session.stop();
  await bundled.stop();
  await rm(folder, { recursive: true });
});

test("the page loads and says what it is", async () => {
  const page = await session.open("/");
  assert.match(await page.title(), /Pathlight/);
});

test("the wasm package is compiled under the page's own policy", async () => {
  const page = await session.open("/");
  const names = await page.evaluate(async () => {
    const package_ = await import("/pkg/pathlight.js");
    await package_.default();
    return package_.templates().map((template) => template.id);
  });
  assert.equal(names.length, 25);
  assert.equal(names[7], "00007");
});

test("the first picture of a puzzle waits for no panel", async () => {
  const page = await session.open("");
  await page.addInitScript(() => {
    const look = () => {
      const canvas = document.querySelector("#puzzle")?.shadowRoot?.querySelector("canvas");
      const drawn =
        canvas &&
        canvas.width > 1 &&
        canvas.getContext("2d")?.getImageData(canvas.width >> 1, canvas.width >> 1, 1, 1).data[3];
      if (drawn)
        Object.assign(window, {
          loaded: performance.getEntriesByType("resource").map(({ name }) => new URL(name).pathname),
        });
      // Right after the frame: until the next one, panels may come.
      else requestAnimationFrame(() => setTimeout(look));
    };
    requestAnimationFrame(() => setTimeout(look));
  });
  await page.goto(`${session.origin}/#task=${EASY}`);
  const loaded = await (await page.waitForFunction(() => /** @type {any} */ (window).loaded)).jsonValue();
  assert.ok(loaded.includes("/play/canvas.js"), String(loaded));
  const early = loaded.filter(
    (path) =>
      path.startsWith("/panels/") || ["/editor/editor.js", "/model/worker.js", "/page/results-view.js"].includes(path),
  );
  assert.deepEqual(early, []);
  await page.locator("#tab-make").click();
  await page.locator("#make-bodies button").first().waitFor();
});

test("what make play serves loads three scripts, and one more for the model", async () => {
  const page = await openImagined(bundled, { reducedMotion: true });
  const scripts = () =>
    performance
      .getEntriesByType("resource")
      .map(({ name }) => new URL(name).pathname)
      .filter((path) => path.endsWith(".js"));
  // Some are loaded side by side, so their order is open.
  assert.deepEqual((await page.evaluate(scripts)).sort(), [
    "/loading/compile-wasm.js",
    "/loading/first-look.js",
    "/model/worker.js",
    "/page/main.js",
  ]);
  const bytes = await page.evaluate(
    () =>
      /** @type {PerformanceResourceTiming[]} */ (performance.getEntriesByType("resource")).find(({ name }) =>
        name.endsWith("/page/main.js"),
      )?.decodedBodySize,
  );
  // Of these are 42,000 the English words, 14,000 the constants with the names of all tasks, and 8,000 the moving scene
  // of the home page, which the page needs before the wasm is there.
  assert.ok(
    bytes > 100_000 && bytes < 328_000,
    `${bytes} bytes: what comes with every page should come when it is asked for`,
  );
  assert.deepEqual(await page.workers()[0].evaluate(scripts), []);
  await page.locator("#tab-play").click();
  await type(page, (await known()).solving);
  await page.locator("#run").click();
  await says(page, /^Solved!/);
});

test("what make play serves is compressed, over plain http too", async (context) => {
  const sizeOf = async (path, encoding) => {
    const { headers } = await new Promise((answer, failed) =>
      get(new URL(path, bundled.origin), { headers: { "accept-encoding": encoding } }, answer).on("error", failed),
    );
    return { bytes: Number(headers["content-length"]), encoding: headers["content-encoding"] };
  };
  const { models } = await (await fetch(new URL("/assets/model.json", bundled.origin))).json();
  const limits = {
    // Of these are 1,200 the stories of the puzzles, which are read while all the rest is on its way.
    "/": { br: 6_500, gzip: 7_000 },
    "/page/main.js": { br: 103_500, gzip: 110_000 },
    "/pkg/pathlight_bg.wasm": { br: 700_000, gzip: 860_000 },
    ...Object.fromEntries(models.map(({ file }) => [`/assets/${file}`, { br: 3_500_000, gzip: 4_000_000 }])),
  };
  for (const [path, forms] of Object.entries(limits))
    for (const [encoding, limit] of Object.entries(forms)) {
      const sent = await sizeOf(path, encoding);
      context.diagnostic(`${path}: ${sent.bytes} bytes with ${encoding}`);
      assert.equal(sent.encoding, encoding, path);
      assert.ok(sent.bytes > 0 && sent.bytes <= limit, `${path}: ${sent.bytes} bytes`);
    }
});

test("the policy keeps scripts from elsewhere out", async () => {
  const page = await session.open("/");
  await assertPolicyHolds(session, page);
});

test("a puzzle is drawn and played before the weights are there", async () => {
  const page = await session.open("", { reducedMotion: "reduce" });
  let asked;
  const held = new Promise((resolve) => {
    asked = resolve;
  });
  await page.context().route("**/assets/*.safetensors", asked);
  await page.goto(`${session.origin}/#task=${EASY}&panel=imagine`);
  const weights = await held;
  await page.locator("#imagine-loading:visible").filter({ hasText: "Loading the model" }).waitFor();
  await page.locator("#tab-play").click();
  await type(page, (await known()).solving);
  await page.locator("#run").click();
  await says(page, /^Solved!/);
  await weights.continue();
  await page.locator("#tab-imagine").click();
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
});

for (const { fragment, told } of [
  { fragment: "", told: true },
  { fragment: "&hide=story", told: false },
])
  test(`while the wasm is on its way, a link to a puzzle tells its story${told ? "" : ", unless it hides that"}`, async () => {
    const page = await session.open("");
    let open = () => {};
    const gate = new Promise((resolve) => (open = () => resolve(null)));
    await page.route("**/*.wasm", (route) => gate.then(() => route.continue()));
    await page.goto(`${session.origin}/#task=00000:000${fragment}`, { waitUntil: "commit" });
    await page.waitForFunction(() => document.querySelector("#languages a"));
    const story = page.locator("#loading-story");
    if (told) await story.filter({ hasText: "Two balls fall" }).waitFor();
    else assert.ok(await story.isHidden());
    open();
    await page.locator("#scene").waitFor();
    assert.ok(await story.isHidden());
  });

for (const { query, fragment, told } of [
  { query: "", fragment: "", told: "Two balls fall" },
  { query: "", fragment: "&hide=story", told: null },
  { query: "?lang=de", fragment: "", told: null },
])
  test(`before the modules are there, too, in English: ${query}#task=…${fragment}`, async () => {
    const page = await session.open("");
    let open = () => {};
    const gate = new Promise((resolve) => (open = () => resolve(null)));
    await page.route("**/page/main.js", (route) => gate.then(() => route.continue()));
    await page.goto(`${session.origin}/${query}#task=00000:000${fragment}`, { waitUntil: "commit" });
    const story = page.locator("#loading-story");
    await page.waitForFunction(() => document.querySelector("#share-dialog"));
    // What is hidden is so once the style sheet has come.
    await (told ? story.filter({ hasText: told }).waitFor() : story.waitFor({ state: "hidden" }));
    open();
    await page.locator("#scene").waitFor();
    assert.ok(await story.isHidden());
  });
