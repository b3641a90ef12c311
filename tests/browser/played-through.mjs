// What a person does first, in any browser: opens a puzzle, places a ball, solves it, lets the model imagine and play,
// and comes back. A page is Puppeteer's, or has as much of its interface.

import assert from "node:assert/strict";
import { EASY, known } from "./page-actions.mjs";

/** For what takes longer than a moment, ms. */
const TIMEOUT = 600_000;

/** @param {string} origin of the page */
export async function playThrough(page, origin) {
  /** Waits for an element whose text passes. */
  const says = (id, pattern) => page.waitForFunction(saysInPage, { timeout: TIMEOUT }, id, pattern.source);
  /**
   * Clicks at a part of an element, 0..1, y down, as soon as it can be used; again if the element moved away before
   * the click arrived.
   */
  const click = async (id, across = 0.5, down = 0.5) => {
    await page.waitForFunction(isUsableInPage, { timeout: TIMEOUT }, id);
    for (let clicks = 0; clicks < 10; clicks++) {
      const { x, y, width, height } = await restingBox(page, id);
      await page.evaluate(awaitClickInPage);
      await page.mouse.click(x + across * width, y + down * height);
      await page.waitForFunction(wasClickedInPage, { timeout: TIMEOUT });
      if (await page.evaluate(wasClickedAtInPage, id)) return;
    }
    throw new Error(`no click arrives at ${id}`);
  };

  await page.goto(`${origin}/#task=${EASY}`);
  await says("status", /place the red ball/);
  const {
    solving: [x, y, r],
  } = await known();
  await click("scene", x / 256, 1 - y / 256);
  await page.waitForFunction(() => document.getElementById("puzzle")?.hasAttribute("ball"), { timeout: TIMEOUT });
  await click("more-button");
  await click("ball-r");
  await page.evaluate(() =>
    /** @type {any} */ (document.getElementById("puzzle")).shadowRoot.getElementById("ball-r").select(),
  );
  await page.keyboard.type(String(r));
  await page.keyboard.press("Tab");
  await page.waitForFunction(
    (end) => document.getElementById("puzzle")?.getAttribute("ball")?.endsWith(end),
    { timeout: TIMEOUT },
    `,${r}`,
  );
  await click("more-button");
  // Whatever the pixels of the window allow, the ball is now that which solves.
  const ball = await page.evaluate(() => document.getElementById("puzzle")?.getAttribute("ball"));
  assert.match(ball ?? "", new RegExp(`^\\d+,\\d+,${r}$`));
  await page.evaluate((ball) => void document.getElementById("puzzle")?.setAttribute("ball", ball), `${x},${y},${r}`);
  await click("run");
  await says("status", /^Solved!/);
  await click("tab-imagine");
  await says("imagined-in", /Imagined in [\d,]+ ms/);
  await click("tab-play");
  await click("open-compare");
  await click("model-turn");
  await says("model-turn", /The model has played/);
  await says("race-verdict", /solved it on attempt/);
  await page.reload();
  await says("race-verdict", /solved it on attempt/);
}

/** Returns the box of an element once it no longer moves: a click at where it was would miss it. */
async function restingBox(page, id) {
  let before = await page.evaluate(boxInPage, id);
  for (let look = 0; look < 100; look++) {
    const box = await page.evaluate(boxInPage, id);
    if (box.x === before.x && box.y === before.y) return box;
    before = box;
  }
  throw new Error(`${id} does not come to rest`);
}

function saysInPage(id, source) {
  const element = /** @type {any} */ (document.getElementById("puzzle"))?.shadowRoot?.getElementById(id);
  return Boolean(element?.checkVisibility() && new RegExp(source).test(element.textContent));
}

function isUsableInPage(id) {
  const element = /** @type {any} */ (document.getElementById("puzzle"))?.shadowRoot?.getElementById(id);
  return Boolean(element?.checkVisibility() && !element.disabled);
}

function awaitClickInPage() {
  const page = /** @type {any} */ (window);
  page.clicked = null;
  window.addEventListener("click", (event) => (page.clicked = event.composedPath()), { capture: true, once: true });
}

function wasClickedInPage() {
  return Boolean(/** @type {any} */ (window).clicked);
}

function wasClickedAtInPage(id) {
  const element = /** @type {any} */ (document.getElementById("puzzle")).shadowRoot.getElementById(id);
  return /** @type {any} */ (window).clicked.includes(element);
}

function boxInPage(id) {
  const element = /** @type {any} */ (document.getElementById("puzzle")).shadowRoot.getElementById(id);
  element.scrollIntoView({ block: "center" });
  return element.getBoundingClientRect().toJSON();
}
