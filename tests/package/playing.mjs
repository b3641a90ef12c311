// Plays the puzzles of a page with a browser, for the tests of the installed package.

import assert from "node:assert/strict";

/**
 * Opens an address in a new page. Browsers ask for an icon that is not there.
 * @param {Awaited<ReturnType<typeof import("../browser/harness.mjs").startOn>>} session
 * @param {string} address
 */
export async function open(session, address) {
  const page = await session.open("", { reducedMotion: "reduce" });
  await page.route("**/favicon.ico", (route) => route.fulfill({ status: 204 }));
  await page.goto(address);
  return page;
}

/**
 * Waits until a path lies over the scene of the example's picture: more green than the object has, and from the object
 * down, as it falls to its goal.
 */
export const drawn = (page) =>
  page.waitForFunction(() => {
    const canvas = /** @type {any} */ (document.getElementById("picture"));
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    let green = 0;
    let below = 0;
    for (let at = 0; at < data.length; at += 4) {
      if (!(data[at + 1] > data[at] + 20 && data[at + 1] > data[at + 2])) continue;
      green++;
      if (at > data.length / 2) below++;
    }
    return green > (canvas.width * canvas.height) / 50 && below > green / 3;
  });

/** Solves a puzzle as the model does it; `pathlight` has loaded its own. */
export async function solve(puzzle, pathlight) {
  const task = await puzzle.getAttribute("task");
  assert.ok(task);
  const { ball, ending } = [...pathlight.turn(task)].at(-1) ?? {};
  assert.ok(ball && ending?.solved, "the model solves it");
  const drop = puzzle.getByRole("button", { name: "Drop it" });
  await drop.waitFor();
  const played = puzzle.evaluate(
    (element) =>
      new Promise((resolve) =>
        element.addEventListener("attempt", (event) => resolve(/** @type {CustomEvent} */ (event).detail)),
      ),
  );
  await puzzle.evaluate((element, ball) => element.setAttribute("ball", ball), ball.join());
  await drop.click();
  const { solved, task: about, ball: placed } = await played;
  assert.deepEqual({ solved, task: about, placed }, { solved: true, task, placed: ball });
}

/** Solves the first puzzle of the example's page while the second shows what the nets imagine. */
export async function playBoth(page, pathlight) {
  await solve(page.locator("pathlight-puzzle").nth(0), pathlight);
  const second = page.locator("pathlight-puzzle").nth(1);
  await second.getByText("If you do nothing").filter({ visible: true }).first().waitFor({ timeout: 60_000 });
}
