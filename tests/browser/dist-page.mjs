// What tests do on the page of dist/ beyond what they do on any page: wait until it is kept for offline, and update it.

import assert from "node:assert/strict";
import { known, says, type } from "./page-actions.mjs";

/** Waits until a version is kept for offline. */
export const kept = (page) => page.evaluate(async () => void (await navigator.serviceWorker.ready));
/** The folder of the version that the page is from. */
export const versionOf = (page) =>
  page
    .locator('script[src$="/main.js"]')
    .getAttribute("src")
    .then((src) => src.split("/")[0]);
/** Makes the page look for another version, as it does when it comes back into sight. */
export const comeBack = (page) => page.evaluate(() => void document.dispatchEvent(new Event("visibilitychange")));
export const sentence = (page) =>
  page
    .locator("#update:has(span:not([hidden])):visible")
    .filter({ hasText: "A new version of Pathlight is available." });
export const cachedVersions = (page) =>
  page.evaluate(async () => (await caches.keys()).map((name) => name.split("/").at(-2)));

export async function solve(page) {
  await page.locator("#tab-play").click();
  await type(page, (await known()).solving);
  await page.locator("#run").click();
  await says(page, /^Solved!/);
}

export async function imagine(page) {
  await page.locator("#tab-imagine").click();
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
}

/** Waits until something is as expected. */
export async function eventually(actual, expected) {
  const end = Date.now() + 90_000;
  for (;;) {
    const now = await actual();
    if (JSON.stringify(now) === JSON.stringify(expected)) return;
    assert.ok(Date.now() < end, `it stays ${JSON.stringify(now)}`);
    await new Promise((resume) => setTimeout(resume, 50));
  }
}
