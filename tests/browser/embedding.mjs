// What tests of <pathlight-puzzle> share: pages of another site that embed it, served beside its modules.

import assert from "node:assert/strict";

/** The whole page of a lesson. */
export const LESSON = `<!doctype html>
<html lang="en">
<title>A lesson</title>
<script type="module" src="/element/pathlight-puzzle.js"></script>
<main>
  <h1>A lesson</h1>
  <pathlight-puzzle id="one" task="00000:000"></pathlight-puzzle>
  <pathlight-puzzle id="two" task="00007:008" panel="imagine" theme="dark"></pathlight-puzzle>
</main>
</html>`;

/** Returns a page with one element. */
export const single = (attributes, style = "") =>
  `<!doctype html><html lang="en"><title>One</title><script type="module" src="/element/pathlight-puzzle.js"></script>
  <main><h1>One</h1><div style="${style}"><pathlight-puzzle ${attributes}></pathlight-puzzle></div></main></html>`;

/**
 * Opens a page with this markup.
 * @param {Awaited<ReturnType<typeof import('./harness.mjs').start>>} session
 * @param {string} [markup]
 * @param {import('playwright-core').BrowserContextOptions & { headers?: Record<string, string> }} [options] `headers`
 *   are those of the page
 */
export async function embed(session, markup = LESSON, { headers = {}, ...options } = {}) {
  const page = await session.open("", { viewport: { width: 1280, height: 800 }, reducedMotion: "reduce", ...options });
  await page.route("**/lesson.html", (route) => route.fulfill({ body: markup, contentType: "text/html", headers }));
  await page.goto(`${session.origin}/lesson.html`);
  return page;
}

/** Waits until a puzzle has imagined its maps. */
export const imagined = (puzzle) =>
  puzzle
    .locator("#imagined-in")
    .filter({ hasText: /Imagined in [\d,]+ ms/ })
    .waitFor();

export const workers = (page, count) => assert.equal(page.workers().length, count, "workers");

export async function wait(passes, what) {
  for (const end = Date.now() + 90_000; !(await passes());) {
    assert.ok(Date.now() < end, what);
    await new Promise((resume) => setTimeout(resume, 20));
  }
}
