// dist/ after one visit: everything works without a network, and the page works whatever goes wrong with the service
// worker.

import assert from "node:assert/strict";
import { after, before, beforeEach, test } from "node:test";
import { comeBack, eventually, imagine, kept, solve } from "./dist-page.mjs";
import { plainDist } from "./dist-versions.mjs";
import { start, startOn } from "./harness.mjs";
import { EASY, inMore, modelLoaded, openPanel, openPuzzle, pause, playModelTurn } from "./page-actions.mjs";
import { serveStatic } from "./static-server.mjs";

/** A name of this machine that browsers do not trust as they trust 127.0.0.1. */
const UNTRUSTED = "pathlight.test";

let server;
let session;
before(async () => {
  server = await serveStatic((await plainDist()).folder);
  session = await startOn(server, [`--host-resolver-rules=MAP ${UNTRUSTED} 127.0.0.1`]);
});
beforeEach(() => (server.isDown = false));
after(() => session.stop());

test("after one visit everything works without a network", async () => {
  const visit = await session.open("/", { reducedMotion: "reduce" });
  await kept(visit);
  const context = visit.context();
  await visit.close();
  await context.setOffline(true);
  await server.stop();

  const page = await session.openIn(context, `/#task=${EASY}`);
  await solve(page);
  await imagine(page);
  await openPanel(page, "compare");
  await playModelTurn(page);
  await page.locator("#proposals:visible").waitFor();
  await openPanel(page, "predict");
  for (const key of ["ArrowDown", "ArrowLeft", "ArrowDown"]) await page.locator("#scene").press(`Shift+${key}`);
  await page.locator("#predict-watch").click();
  await page.locator("#predict-cards canvas").first().waitFor();
  await openPanel(page, "map");
  await page.locator("#solve-map-search").click();
  await page.locator("#solve-map-words").filter({ hasText: "Every place tried" }).waitFor({ timeout: 120_000 });
  await page.locator("#tab-imagine").click();
  await inMore(page, () => page.locator("#model-select").selectOption("cross-0"));
  await modelLoaded(page, "cross-0");
  await page.locator("#home").click();
  await page.locator("#templates canvas.drawn").first().waitFor();
  await page.locator("[data-pick=learns] a").click();
  await page.locator("#learns-play").click();
  await page.locator("#learns-list li").first().waitFor({ state: "attached", timeout: 120_000 });

  await context.close();
  await server.start();
});

test("files are kept for later only once the page is there", async () => {
  const page = await session.open("");
  await page.addInitScript(() => {
    const { serviceWorker } = navigator;
    const register = serviceWorker.register.bind(serviceWorker);
    serviceWorker.register = (...options) => {
      document.documentElement.dataset.registered = document.querySelector("#templates a")
        ? "after the page"
        : "before the page";
      return register(...options);
    };
  });
  // On a slow connection, where the page comes late.
  await page.route("**/*.wasm", async (route) => {
    await new Promise((resume) => setTimeout(resume, 1000));
    await route.continue();
  });
  await page.goto(`${server.origin}/`);
  await kept(page);
  assert.equal(await page.locator("html").getAttribute("data-registered"), "after the page");
  await page.context().close();
});

test("an error of the server ends nothing", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  await kept(page);
  const since = server.answers.length;
  server.isDown = true;
  await comeBack(page);
  await eventually(
    async () =>
      server.answers
        .slice(since)
        .map(({ status }) => status)
        .slice(0, 2),
    [503, 503],
  );
  await pause(page);
  assert.equal(await page.locator("#update:visible").count(), 0);
  const context = page.context();
  await page.close();
  await context.setOffline(true);
  const next = await session.openIn(context, `/#task=${EASY}`);
  await solve(next);
  await imagine(next);
  await context.close();
  session.takeProblems();
});

for (const { what, script } of [
  {
    what: "has no service workers",
    script: () => Object.defineProperty(Navigator.prototype, "serviceWorker", { get: () => undefined }),
  },
  {
    what: "refuses them",
    script: () =>
      (navigator.serviceWorker.register = () => Promise.reject(new DOMException("denied", "SecurityError"))),
  },
]) {
  test(`a browser that ${what} shows the page as ever`, async () => {
    const page = await session.open("", { reducedMotion: "reduce" });
    await page.addInitScript(script);
    await page.goto(`${server.origin}/#task=${EASY}`);
    await solve(page);
    await imagine(page);
    await page.context().close();
  });
}

test("where storage is full the page is shown as ever", async () => {
  const page = await session.open("", { reducedMotion: "reduce" });
  const devtools = await page.context().newCDPSession(page);
  await devtools.send("Storage.overrideQuotaForOrigin", {
    origin: new URL(server.origin).origin,
    quotaSize: 1_000_000,
  });
  await page.goto(`${server.origin}/#task=${EASY}`);
  const ended = await page.evaluate(async () => {
    for (;;) {
      const registration = await navigator.serviceWorker.getRegistration();
      const installing = registration?.installing;
      if (installing)
        return new Promise((resolve) => installing.addEventListener("statechange", () => resolve(installing.state)));
      await new Promise((resume) => setTimeout(resume, 10));
    }
  });
  assert.equal(ended, "redundant");
  await solve(page);
  await imagine(page);
  await page.context().close();
});

test("by plain http from another machine the page is shown as ever", async () => {
  const page = await session.open("", { reducedMotion: "reduce" });
  await page.goto(`${server.origin.replace("127.0.0.1", UNTRUSTED)}/#task=${EASY}`);
  assert.equal(await page.evaluate(() => isSecureContext), false);
  await solve(page);
  await imagine(page);
  await page.context().close();
});

test("a browser can install the page", async () => {
  const page = await session.open("/");
  await kept(page);
  const devtools = await page.context().newCDPSession(page);
  const { errors, url } = await devtools.send("Page.getAppManifest");
  assert.deepEqual(errors, []);
  assert.equal(url, `${server.origin}/manifest.webmanifest`);
  const { installabilityErrors } = await devtools.send("Page.getInstallabilityErrors");
  assert.deepEqual(
    installabilityErrors.filter(({ errorId }) => errorId !== "in-incognito"),
    [],
  );
  await page.context().close();
});

test("the sources are shown without a service worker", async () => {
  const sources = await start({ sources: true });
  const page = await sources.open("/");
  await page.locator("#templates canvas.drawn").first().waitFor();
  assert.deepEqual(await page.evaluate(async () => (await navigator.serviceWorker.getRegistrations()).length), 0);
  assert.equal((await fetch(`${sources.origin}/service-worker.js`)).status, 404);
  await sources.stop();
});
