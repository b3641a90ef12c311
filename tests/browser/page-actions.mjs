// What tests do on the page as a person would: open a puzzle, point at px of the scene, read the status line.
// It also finds a solving ball by simulation, with the page's own wasm, so that no test holds a solution.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { Game, initSync } from "../../www/pkg/pathlight.js";
import { painted } from "./harness.mjs";

const ROOT = join(dirname(fileURLToPath(import.meta.url)), "..", "..");
const RESULTS = join(ROOT, "results");
const WASM = join(ROOT, "www", "pkg", "pathlight_bg.wasm");

/** A puzzle that many balls solve. */
export const EASY = "00000:000";

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {[x: number, y: number, r: number]} Ball */

/**
 * Opens a puzzle by its link, whose fragment goes on with `fragment` ("&panel=…"). With `reducedMotion` a run shows its
 * end immediately. A `newcomer` sees the model's guess, and the story the first time; others are past that.
 * @param {Awaited<ReturnType<typeof import('./harness.mjs').start>>} session
 * @param {{ task?: string, fragment?: string, reducedMotion?: boolean, newcomer?: boolean } &
 *   Omit<import('playwright-core').BrowserContextOptions, 'reducedMotion'>} [options]
 */
export async function openPuzzle(session, options = {}) {
  const { task = EASY, fragment = "", reducedMotion = false, newcomer = false, ...context } = options;
  const page = await session.open("", { reducedMotion: reducedMotion ? "reduce" : "no-preference", ...context });
  if (!newcomer) await page.addInitScript(becomeRegular);
  await page.goto(`${session.origin}/#task=${task}${fragment}`);
  await page.locator("#scene").waitFor();
  // Its panels come after its first picture.
  await page.locator("#puzzle [inert]").first().waitFor({ state: "detached" });
  return page;
}

/** In a page: its person has seen the story, and prefers to guess alone. */
export function becomeRegular() {
  try {
    localStorage.setItem("pathlight.story", "told");
    localStorage.setItem("pathlight.guess", "off");
  } catch {
    // Nothing is kept in this browser.
  }
}

/** Opens a puzzle on the panel Imagine, and waits until its maps are imagined. */
export async function openImagined(session, options) {
  const page = await openPuzzle(session, { fragment: "&panel=imagine", ...options });
  await page
    .locator("#imagined-in")
    .filter({ hasText: /Imagined in [\d,]+ ms/ })
    .waitFor();
  return page;
}

/**
 * Waits until the maps are imagined, whatever panel is shown. Touches should come later: a page that is busy with the
 * model may not answer one in time, and then the browser scrolls with it.
 * @param {Page} page
 */
export async function mapsImagined(page) {
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor({ state: "attached" });
}

/**
 * Waits until the value of a field passes a test.
 * @param {Page} page
 * @param {string} selector
 * @param {(value: string) => boolean} passes
 */
export async function waitForValue(page, selector, passes) {
  const end = Date.now() + 90_000;
  for (;;) {
    const value = await page.locator(selector).inputValue();
    if (passes(value)) return;
    assert.ok(Date.now() < end, `${selector} stays ${value}`);
    await page.waitForTimeout(10);
  }
}

/**
 * Leaves the page the time in which something would happen that must not. On a slow machine a wrong page may pass; a
 * right one never fails.
 * @param {Page} page
 * @param {number} [time] ms
 */
export async function pause(page, time = 500) {
  await page.waitForTimeout(time);
}

/**
 * Presses and moves the mouse over points of the scene, and leaves its button down.
 * @param {Page} page
 * @param {[number, number][]} points
 */
export async function dragTo(page, points) {
  await page.mouse.move(...(await spot(page, ...points[0])));
  await page.mouse.down();
  for (const point of points) await page.mouse.move(...(await spot(page, ...point)), { steps: 5 });
}

/**
 * The place on the screen of a point of the scene, px.
 * @param {Page} page
 * @param {number} x
 * @param {number} y
 * @returns {Promise<[number, number]>}
 */
export async function spot(page, x, y) {
  const box = await page.locator("#scene").boundingBox();
  assert.ok(box, "the scene is visible");
  return [box.x + (x / 256) * box.width, box.y + box.height - (y / 256) * box.height];
}

export async function click(page, x, y) {
  await page.mouse.click(...(await spot(page, x, y)));
}

/**
 * What the status line says of any attempt of the model but its first. Each is shown for half a second, so a slow
 * machine may miss one.
 */
export const MODEL_TRIES_AGAIN = /The model tries: attempt ([2-9]|\d\d)/;

/** Waits until the status line says so, and returns it. */
export async function says(page, pattern, timeout = 90_000) {
  const status = page.locator("#status");
  await status
    .filter({ hasText: pattern })
    .waitFor({ timeout })
    .catch(async () => {
      assert.match(await status.textContent(), pattern);
    });
  return status.textContent();
}

/**
 * The ball in the fields; zeros if there is none.
 * @param {Page} page
 * @returns {Promise<Ball>}
 */
export async function ball(page) {
  const value = async (name) => Number(await page.locator(`#ball-${name}`).inputValue());
  return [await value("x"), await value("y"), await value("r")];
}

/** Waits until the model of the page is loaded, whatever panel is shown. */
export async function modelLoaded(page, name = "") {
  await page
    .locator("#card")
    .filter({ hasText: `model “${name}` })
    .waitFor({ state: "attached" });
}

/** In whose tab the panels are that have none of their own. */
const TAB_OF = { compare: "play", predict: "imagine", map: "imagine" };

/**
 * Opens a panel as a person does: its tab, and there its part.
 * @param {Page} page
 * @param {string} panel
 */
export async function openPanel(page, panel) {
  await page.locator(`#tab-${TAB_OF[panel] ?? panel}`).click();
  if (panel in TAB_OF) await page.locator(`#open-${panel}`).click();
}

/** Opens the menu “…”, and closes it after an action there. */
export async function inMore(page, act) {
  const menu = page.locator("#more");
  if (!(await menu.isVisible())) await page.locator("#more-button").click();
  await act();
  if (await menu.isVisible()) await page.keyboard.press("Escape");
}

/** Opens the sheet on which a puzzle is shared. */
export async function openShare(page) {
  await page.locator("#share-button").click();
  await page.locator("#share-dialog[open]").waitFor();
}

/** Opens the dialog that makes a link for a lesson. */
export async function openLesson(page) {
  await openShare(page);
  await page.locator("#lesson-button").click();
}

/** Lets the model play its turn to its end, among the model's balls. */
export async function playModelTurn(page) {
  await page.locator("#model-turn:enabled").click();
  await page.locator("#model-turn").filter({ hasText: "The model has played" }).waitFor({ timeout: 120_000 });
}

/**
 * The element that has the focus, also inside a puzzle.
 * @param {Page} page
 */
export async function focused(page) {
  const handle = await page.evaluateHandle(() => {
    let active = document.activeElement;
    while (active?.shadowRoot?.activeElement) active = active.shadowRoot.activeElement;
    return /** @type {HTMLElement} */ (active);
  });
  return handle.asElement();
}

/** How many attempts the player has made. */
export function attempts(page) {
  return page.locator("#play-attempts li").count();
}

/**
 * Presses a button of the puzzle as soon as a search has said enough: it may be over when a click from outside arrives.
 * Resolves to all that it has said.
 * @param {Page} page
 * @param {string} button
 * @param {string} words
 * @param {{ after: number, times?: number }} options `after` how many sentences, `times` how often it is pressed
 * @returns {Promise<string[]>}
 */
export function pressDuring(page, button, words, { after, times = 1 }) {
  return page.evaluate(
    ([button, words, after, times]) =>
      new Promise((resolve) => {
        const root = /** @type {ShadowRoot} */ (document.querySelector("#puzzle")?.shadowRoot);
        const said = /** @type {string[]} */ ([]);
        const observer = new MutationObserver(() => {
          const text = root.querySelector(words)?.textContent ?? "";
          if (text === "" || said.includes(text)) return;
          if (said.push(text) < after) return;
          observer.disconnect();
          for (let time = 0; time < times; time += 1)
            /** @type {HTMLElement} */ (root.querySelector(button)).click();
          resolve(said);
        });
        observer.observe(/** @type {Element} */ (root.querySelector(words)), {
          childList: true,
          characterData: true,
          subtree: true,
        });
      }),
    /** @type {const} */ ([button, words, after, times]),
  );
}

/**
 * Balls of a puzzle, found by simulation: one that solves it, one that does not, one that may not be placed.
 * @param {string} [task]
 * @returns {Promise<{ solving: Ball, missing: Ball, invalid: Ball }>}
 */
export async function known(task = EASY) {
  initSync({ module: await readFile(WASM) });
  const game = new Game(task);
  /** @type {{ solving?: Ball, missing?: Ball, invalid?: Ball }} */
  const found = {};
  for (let r = 8; r <= 24; r += 8) {
    for (let y = 250; y > 0; y -= 12) {
      for (let x = 4; x < 256; x += 8) {
        if (game.whyInvalid(x, y, r)) {
          found.invalid ??= [x, y, r];
          continue;
        }
        const { number, ending } = game.attempt(x, y, r);
        found[ending.solved ? "solving" : "missing"] ??= [x, y, r];
        if (number === 100) game.clear("player");
        const { solving, missing, invalid } = found;
        if (solving && missing && invalid) return { solving, missing, invalid };
      }
    }
  }
  throw new Error(`no ball of the grid solves ${task}`);
}

/** Types a ball into the fields. */
export async function type(page, [x, y, r]) {
  await inMore(page, async () => {
    for (const [name, value] of Object.entries({ x, y, r })) {
      await page.locator(`#ball-${name}`).fill(String(value));
      await page.locator(`#ball-${name}`).press("Tab");
    }
  });
  // The page takes the ball once all three numbers are there.
  assert.deepEqual(await ball(page), [x, y, r]);
}

/** How many pixels of the scene are nearly of this colour, "#rrggbb". */
export async function pixels(page, colour, selector = "#scene") {
  await painted(page);
  return page.locator(selector).evaluate((canvas, colour) => {
    const expected = [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let at = 0; at < data.length; at += 4) {
      if (data[at + 3] > 200 && expected.every((value, channel) => Math.abs(data[at + channel] - value) < 12))
        count += 1;
    }
    return count;
  }, colour);
}

/** The colours of the roles, as the wasm draws them on light paper. */
export { LIGHT_PALETTE as palette } from "../../www/pkg/constants.js";

/** A picture of the scene, to see whether it has changed. */
export async function picture(page, selector = "#scene") {
  await painted(page);
  return page.locator(selector).evaluate((canvas) => canvas.toDataURL());
}

/** The tasks that the first model was measured on, each with the attempt at which it solved it, or null. */
async function measured() {
  const { agents } = JSON.parse(await readFile(join(RESULTS, "shipped/within-0.json"), "utf8"));
  return agents.find(({ agent }) => agent === "online").first_solved;
}

/** A puzzle that the first model does not solve within its hundred attempts, as the results of its evaluation say. */
export async function unsolvedTask() {
  return (await measured()).find(([, attempt]) => attempt === null)[0];
}

/** A task that the first model solves at the first attempt that passes a test, and that attempt. */
export async function solvedTask(passes) {
  return (await measured()).find(([, attempt]) => attempt !== null && passes(attempt));
}

/** Fails if the page runs a script that is not its own, or refuses it for another reason than its policy. */
export async function assertPolicyHolds(session, page) {
  const ran = await page.evaluate(() => {
    const script = document.createElement("script");
    script.textContent = 'document.title = "intruder"';
    document.head.append(script);
    return document.title === "intruder";
  });
  assert.equal(ran, false);
  const problems = session.takeProblems();
  assert.ok(
    problems.length > 0 && problems.every((problem) => /Content Security Policy/.test(problem)),
    problems.join(),
  );
}
