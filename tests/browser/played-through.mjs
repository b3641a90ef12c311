// What a person does first, in any browser: plays a puzzle against the model, looks at what it imagines, and comes
// back. A page is Puppeteer's, or has as much of its interface.

import assert from "node:assert/strict";
import { EASY, known } from "./player.mjs";

/** For what takes longer than a moment, ms. */
const TIMEOUT = 120_000;

/** @param {string} origin of the page */
export async function playThrough(page, origin) {
  const until = (inPage, ...args) => page.waitForFunction(inPage, { timeout: TIMEOUT }, ...args);
  const says = (pattern) => until(saysInPage, pattern.source);
  /** Clicks a button as soon as it stands still. */
  const click = async (name) => {
    await until(centreInPage, name);
    for (let before = ""; ;) {
      const [x, y] = await page.evaluate(centreInPage, name);
      if (before === `${x} ${y}`) return page.mouse.click(x, y);
      before = `${x} ${y}`;
    }
  };
  /** Opens a panel. Its tab may move while it is clicked, when more is said above it. */
  const openPanel = async (name) => {
    do await click(name);
    while (!(await page.evaluate(isOpenInPage, name)));
  };

  const {
    solving: [x, y, r],
  } = await known();
  await page.goto(`${origin}/#task=${EASY}`);
  await until(() => document.body.innerText.includes("Model A."));
  const { left, bottom, side } = await page.evaluate(sceneInPage);
  await page.mouse.click(left + (x / 256) * side, bottom - (y / 256) * side);
  await says(/^Ready\. Drop it!$/);
  // Whatever the pixels of the window allow, the ball is now that which solves.
  await page.evaluate((hash) => void (location.hash = hash), `#task=${EASY}&ball=${x},${y},${r}`);
  await until(
    (place) => document.querySelector("canvas")?.ariaLabel?.includes(place),
    `x ${x}, y ${y}, with radius ${r}`,
  );
  await click("Drop it");
  await says(/^(You beat the model|A draw)/);
  await openPanel("Imagine");
  await until(() => document.querySelector('[aria-label="Maps over the scene"] button'));
  await click("6");
  await says(/The path it imagined for green was/);
  await page.reload();
  await says(/The path it imagined for green was/);
  await openPanel("Play");
  await until(() => document.querySelector("ol button")?.ariaLabel?.includes("You: solved."));
  assert.match(await page.evaluate(() => document.title), /Two Drops/);
}

function saysInPage(source) {
  return [...document.querySelectorAll("[role=status]")].some((one) => new RegExp(source).test(one.textContent ?? ""));
}

function isOpenInPage(name) {
  const tabs = [...document.querySelectorAll("[role=tab]")];
  return tabs.some((tab) => tab.textContent?.trim() === name && tab.ariaSelected === "true");
}

/** The middle of the button with these words. */
function centreInPage(words) {
  const button = [...document.querySelectorAll("button")].find((one) => one.textContent?.trim() === words);
  if (!button?.checkVisibility()) return null;
  button.scrollIntoView({ block: "center" });
  const { x, y, width, height } = button.getBoundingClientRect();
  return [x + width / 2, y + height / 2];
}

function sceneInPage() {
  const { left, bottom, width } = /** @type {Element} */ (document.querySelector("canvas")).getBoundingClientRect();
  return { left, bottom, side: width };
}
