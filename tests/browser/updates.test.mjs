// Another version of dist/ is offered to an open page and never forced, and one that does not work takes no other's
// place.

import assert from "node:assert/strict";
import { appendFile, cp } from "node:fs/promises";
import { join } from "node:path";
import { after, before, beforeEach, test } from "node:test";
import { axeFindsNothing } from "./axe.mjs";
import { cachedVersions, comeBack, eventually, imagine, kept, sentence, solve, versionOf } from "./dist-page.mjs";
import { changedDist, plainDist, temporaryFolder } from "./dist-versions.mjs";
import { startOn } from "./harness.mjs";
import { EASY, focused, inMore, modelLoaded, openPuzzle } from "./page-actions.mjs";
import { serveStatic } from "./static-server.mjs";

let first;
let second;
let server;
let session;
before(async () => {
  [first, second] = [await plainDist(), await changedDist()];
  server = await serveStatic(first.folder);
  session = await startOn(server);
});
beforeEach(() => (server.folder = first.folder));
after(() => session.stop());

test("an update while the page is open is offered, and taken when the person says so", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  await kept(page);
  const old = await versionOf(page);
  server.folder = second.folder;
  await comeBack(page);
  await sentence(page).waitFor();

  // The server has no file of the old version any more; the worker and the weights are loaded only now.
  await page.locator("#next").click();
  await imagine(page);
  await inMore(page, () => page.locator("#model-select").selectOption("cross-0"));
  await modelLoaded(page, "cross-0");
  await page.locator("#previous").click();
  await solve(page);
  assert.equal(await versionOf(page), old);
  await sentence(page).waitFor();

  await page.waitForURL(/ball=/);
  const address = page.url();
  await sentence(page).getByRole("button", { name: "Load the new version" }).click();
  await page.waitForFunction(
    (old) => document.querySelector('script[src$="/main.js"]')?.getAttribute("src")?.startsWith(old) === false,
    old,
  );
  assert.equal(page.url(), address);
  await solve(page);
  assert.equal(await sentence(page).count(), 0);
  // The old version is not kept any longer.
  await eventually(() => cachedVersions(page), [await versionOf(page)]);
  await page.context().close();
});

for (const [screen, size] of Object.entries({
  "a desktop": { viewport: { width: 1280, height: 800 } },
  "a phone": { viewport: { width: 360, height: 740 } },
})) {
  for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
    test(`the sentence covers no part of the puzzle on ${screen}, ${colorScheme}`, async () => {
      const page = await openPuzzle(session, { ...size, colorScheme });
      await kept(page);
      const scene = await page.locator("#scene").boundingBox();
      server.folder = second.folder;
      await comeBack(page);
      await sentence(page).waitFor();
      assert.deepEqual(await page.locator("#scene").boundingBox(), scene);
      const bar = await page.locator("#update").boundingBox();
      assert.ok(bar.height < 100, `it is ${bar.height} px high`);
      for (const id of ["scene", "run", "status", "tab-play", "radius"]) {
        await page.locator(`#${id}`).scrollIntoViewIfNeeded();
        const box = await page.locator(`#${id}`).boundingBox();
        assert.ok(box.x + box.width <= bar.x + 1 || box.y + box.height <= bar.y + 1, `it covers #${id}`);
      }
      await axeFindsNothing(page, "", { within: "#update", all: true });
      await page.context().close();
    });
  }
}

test("“Later” puts the new version off until no page is open", async () => {
  const page = await openPuzzle(session);
  await kept(page);
  const old = await versionOf(page);
  server.folder = second.folder;
  await comeBack(page);
  await page.locator("#run").focus();
  await sentence(page).getByRole("button", { name: "Load the new version" }).focus();
  const later = sentence(page).getByRole("button", { name: "Later" });
  await later.focus();
  await later.press("Enter");
  assert.equal(await sentence(page).count(), 0);
  assert.equal(await (await focused(page)).getAttribute("id"), "run");
  await page.reload();
  assert.equal(await versionOf(page), old);
  const context = page.context();
  await page.close();
  let pause = 500;
  const visit = async () => {
    // The browser replaces the service worker some time after the last page was closed: the later, the busier the
    // machine.
    await new Promise((resume) => setTimeout(resume, pause));
    pause *= 2;
    const next = await session.openIn(context);
    await next.locator("#templates canvas.drawn").first().waitFor();
    const version = await versionOf(next);
    await next.close();
    return version !== old;
  };
  await eventually(visit, true);
  await context.close();
});

test("of two open pages one takes the new version, and the other goes on in the old one", async () => {
  const one = await openPuzzle(session, { reducedMotion: true });
  await kept(one);
  const context = one.context();
  const other = await session.openIn(context, `/#task=${EASY}`);
  const old = await versionOf(one);
  server.folder = second.folder;
  await comeBack(one);
  await sentence(other).waitFor();
  await sentence(one).getByRole("button", { name: "Load the new version" }).click();
  await one.waitForFunction(
    (old) => document.querySelector('script[src$="/main.js"]')?.getAttribute("src")?.startsWith(old) === false,
    old,
  );
  const renewed = await versionOf(one);

  // Its worker is started anew, and fetches the weights of the other model.
  await imagine(other);
  await inMore(other, () => other.locator("#model-select").selectOption("cross-0"));
  await modelLoaded(other, "cross-0");
  assert.equal(await versionOf(other), old);
  assert.deepEqual((await cachedVersions(other)).sort(), [old, renewed].sort());

  await other.locator("#home").click();
  await sentence(other).getByRole("button", { name: "Load the new version" }).click();
  await other.waitForFunction(
    (old) => document.querySelector('script[src$="/main.js"]')?.getAttribute("src")?.startsWith(old) === false,
    old,
  );
  await eventually(() => cachedVersions(other), [renewed]);
  await context.close();
});

test("a version that arrives damaged is not taken", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  await kept(page);
  const old = await versionOf(page);
  const damaged = await temporaryFolder();
  await cp(second.folder, damaged, { recursive: true });
  await appendFile(
    join(damaged, [...second.files.keys()].find((path) => path.endsWith("/page/main.js")) ?? ""),
    "// half of another version\n",
  );
  server.folder = damaged;
  const context = page.context();
  const failed = page.evaluate(async () => {
    const registration = await navigator.serviceWorker.ready;
    return new Promise((resolve) =>
      registration.addEventListener("updatefound", () => {
        const { installing } = registration;
        installing?.addEventListener("statechange", () => resolve(installing.state));
      }),
    );
  });
  await comeBack(page);
  assert.equal(await failed, "redundant");
  assert.equal(await sentence(page).count(), 0);
  await context.setOffline(true);
  await page.reload();
  assert.equal(await versionOf(page), old);
  await solve(page);
  await context.close();
});

test("a version that fails to start is replaced by the next one", async () => {
  server.folder = (await changedDist("page/page.js", "throw new Error('a mistake in this version');")).folder;
  const page = await session.open(`/#task=${EASY}`, { reducedMotion: "reduce" });
  await kept(page);
  await page.locator("#notice").filter({ hasText: "a mistake in this version" }).waitFor();
  server.folder = first.folder;
  await comeBack(page);
  await sentence(page).getByRole("button", { name: "Load the new version" }).click();
  await solve(page);
  await page.context().close();
  assert.deepEqual(
    session.takeProblems().filter((problem) => !problem.includes("a mistake in this version")),
    [],
  );
});

test("another page at the same address ends the service worker", async () => {
  const page = await session.open("/", { reducedMotion: "reduce" });
  await kept(page);
  const context = page.context();
  await page.close();
  // As if the sources were served here, by `pathlight serve`: they have no service worker.
  const folder = await temporaryFolder();
  await cp(first.folder, folder, { recursive: true, filter: (path) => !path.endsWith("service-worker.js") });
  server.folder = folder;
  const stale = await session.openIn(context);
  await sentence(stale).waitFor();
  const loadedAgain = stale.waitForEvent("load");
  await sentence(stale).getByRole("button", { name: "Load the new version" }).click();
  await loadedAgain;
  await eventually(() => stale.evaluate(() => navigator.serviceWorker.controller), null);
  assert.deepEqual(await stale.evaluate(() => caches.keys()), []);
  await context.close();
  session.takeProblems();
});
