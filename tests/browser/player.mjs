// What the tests of the page in www share: a server of target/page, and what a person does in a puzzle.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { startOn } from "./harness.mjs";
import { serveStatic } from "./static-server.mjs";
import { OpenPuzzle, initSync } from "../../www/pkg/page/pathlight.js";

const ROOT = join(dirname(fileURLToPath(import.meta.url)), "../..");
export const EASY = "00000:058";
/** @type {import("playwright-core").BrowserContextOptions} */
export const STILL = { reducedMotion: "reduce" };

/** Starts a browser and a server of the built page; `server` is that of static-server.mjs. */
export async function startPlayer() {
  const server = await serveStatic(join(ROOT, "target/page"), "/a/");
  return Object.assign(await startOn(server), { server });
}

/** Opens a puzzle, and waits until its scene can be played. */
export async function openPuzzle(session, link = `#task=${EASY}`, options = {}) {
  const page = await session.open("", options);
  await page.goto(`${session.origin}/${link}`);
  await button(page, /Drop it|Fallen lassen|Let it run/).waitFor();
  return page;
}

/** Loads the page's wasm, whose functions can be called then. */
export async function loadSimulator() {
  initSync({ module: await readFile(join(ROOT, "www/pkg/page/pathlight_bg.wasm")) });
}

/** @typedef {import("../../www/pkg/page/pathlight.js").Ball} Ball */

/**
 * Balls of a task by what becomes of them.
 * @returns {Promise<{ solving: Ball, missing: Ball[], invalid: Ball }>}
 */
export async function known(task = EASY) {
  await loadSimulator();
  const puzzle = new OpenPuzzle(task);
  /** @type {{ solving?: Ball, missing: Ball[], invalid?: Ball }} */
  const found = { missing: [] };
  for (let r = 8; r <= 24; r += 8)
    for (let y = 250; y > 0; y -= 12)
      for (let x = 4; x < 256; x += 8) {
        if (puzzle.whyInvalid(x, y, r)) found.invalid ??= [x, y, r];
        else if (puzzle.rollout([x, y, r]).ending.solved) found.solving ??= [x, y, r];
        else if (found.missing.length < 4) found.missing.push([x, y, r]);
        const { solving, missing, invalid } = found;
        if (solving && invalid && missing.length === 4) return { solving, missing, invalid };
      }
  throw new Error(`the grid has not all kinds of balls in ${task}`);
}

export const scene = (page) => page.getByRole("application");
export const button = (page, name) => page.getByRole("button", { name, exact: typeof name === "string" });

/** The place on the screen of a point of the scene, px. */
export async function spot(page, x, y) {
  const box = await scene(page).boundingBox();
  assert.ok(box, "the scene is visible");
  return [box.x + (x / 256) * box.width, box.y + box.height - (y / 256) * box.height];
}

/** Follows a link to the same puzzle with a ball. */
export async function place(page, ball, task = EASY) {
  await page.evaluate((hash) => (location.hash = hash), `#task=${task}&ball=${ball.join()}`);
  await described(page, new RegExp(`x ${ball[0]}, y ${ball[1]}, with radius ${ball[2]}`));
}

/** Waits until the (first) scene is described so, as a screen reader says it. */
export async function described(page, pattern) {
  await page.getByRole("application", { name: pattern }).first().waitFor();
}

/** Waits until the live region says so. */
export async function says(page, pattern) {
  const region = page.getByRole("status").filter({ hasText: pattern });
  await region.waitFor({ state: "attached" });
  return region.textContent();
}

/** Waits for the model. */
export async function modelIsThere(page) {
  await page.getByText(/^Modell? [AB]\./).waitFor();
}

/** Drops the ball where it is, and waits for the verdict. */
export async function drop(page, name = "Drop it") {
  await button(page, name).click();
  await button(page, /^(Try again|Next puzzle)$/).waitFor();
}
