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

let session;
before(async () => (session = await start()));
after(() => session.stop());

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

test("wasm and weights are small to download", async (context) => {
  const size = async (path) => {
    const { headers } = await new Promise((answer, failed) =>
      get(new URL(path, session.origin), { headers: { "accept-encoding": "br" } }, answer).on("error", failed),
    );
    return { bytes: Number(headers["content-length"]), encoding: headers["content-encoding"] };
  };
  const wasm = await size("/pkg/pathlight_bg.wasm");
  assert.equal(wasm.encoding, "br");
  context.diagnostic(`wasm: ${wasm.bytes} bytes with brotli`);
  assert.ok(wasm.bytes > 0 && wasm.bytes <= 700_000, `${wasm.bytes} bytes`);
  const { models } = await (await fetch(new URL("/assets/model.json", session.origin))).json();
  for (const { file } of models) {
    const { bytes } = await size(`/assets/${file}`);
    context.diagnostic(`${file}: ${bytes} bytes`);
    assert.ok(bytes > 0 && bytes <= 7_000_000, `${file}: ${bytes} bytes`);
  }
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
      else requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  });
  await page.goto(`${session.origin}/#task=${EASY}`);
  const loaded = await (await page.waitForFunction(() => /** @type {any} */ (window).loaded)).jsonValue();
  assert.ok(loaded.includes("/play/canvas.js"), String(loaded));
  const early = loaded.filter(
    (path) =>
      path.startsWith("/panels/") || ["/workshop/bend.js", "/model/worker.js", "/page/results-view.js"].includes(path),
  );
  assert.deepEqual(early, []);
  await page.locator("#tab-bend").click();
  await page.locator("#bend-bodies button").first().waitFor();
});

test("what make play serves loads two scripts, and one more for the model", async () => {
  const folder = await mkdtemp(join(tmpdir(), "pathlight-"));
  await writeBundledPage(folder);
  const bundled = await start({ serve: ["--dir", folder] });
  const page = await openImagined(bundled, { reducedMotion: true });
  const scripts = () =>
    performance
      .getEntriesByType("resource")
      .map(({ name }) => new URL(name).pathname)
      .filter((path) => path.endsWith(".js"));
  assert.deepEqual(await page.evaluate(scripts), ["/loading/compile-wasm.js", "/page/main.js", "/model/worker.js"]);
  const bytes = await page.evaluate(
    () =>
      /** @type {PerformanceResourceTiming[]} */ (performance.getEntriesByType("resource")).find(({ name }) =>
        name.endsWith("/page/main.js"),
      )?.decodedBodySize,
  );
  assert.ok(
    bytes > 100_000 && bytes < 250_000,
    `${bytes} bytes: what comes with every page should come when it is asked for`,
  );
  assert.deepEqual(await page.workers()[0].evaluate(scripts), []);
  await page.locator("#tab-play").click();
  await type(page, (await known()).solving);
  await page.locator("#run").click();
  await says(page, /^Solved!/);
  await bundled.stop();
  await rm(folder, { recursive: true });
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
