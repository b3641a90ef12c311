// From the grid to a solved puzzle and the model's turn without touching the mouse.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { ball, focused, known, openPuzzle, pause, says, type, waitForValue } from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

const focusedId = async (page) => (await focused(page)).getAttribute("id");

/** Presses Tab until the element of this id has the focus. */
async function tabTo(page, id) {
  for (let presses = 0; presses < 60; presses += 1) {
    if ((await focusedId(page)) === id) return;
    await page.keyboard.press("Tab");
  }
  assert.fail(`Tab does not reach ${id}`);
}

async function press(page, key, times) {
  for (let count = 0; count < times; count += 1) await page.keyboard.press(key);
}

/** Moves the ball from where it is by arrows, Shift and arrows, + and -. */
async function moveTo(page, [x, y, r]) {
  const [fromX, fromY, fromR] = await ball(page);
  for (const { by, less, more } of [
    { by: x - fromX, less: "ArrowLeft", more: "ArrowRight" },
    { by: y - fromY, less: "ArrowDown", more: "ArrowUp" },
  ]) {
    const key = by < 0 ? less : more;
    await press(page, `Shift+${key}`, Math.floor(Math.abs(by) / 10));
    await press(page, key, Math.abs(by) % 10);
  }
  await press(page, r < fromR ? "-" : "+", Math.abs(r - fromR));
}

test("a puzzle is opened, solved and compared by keys alone", async () => {
  const page = await session.open("/", { reducedMotion: "reduce" });
  await page.locator("#templates a").first().waitFor();
  const { solving } = await known();
  while (!(await page.evaluate(() => document.activeElement?.matches("#templates a"))))
    await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  await page.locator("#scene").waitFor();
  assert.equal(await focusedId(page), "scene", "the scene is ready for the arrows");

  await page.keyboard.press("ArrowUp");
  await moveTo(page, solving);
  assert.deepEqual(await ball(page), solving);
  await page.keyboard.press("Space");
  await says(page, /^Solved! Your attempt 1/);

  await page.locator("#race-it:enabled").waitFor();
  await tabTo(page, "race-it");
  await page.keyboard.press("Enter");
  await page.locator("#race-it").filter({ hasText: "Watch it again" }).waitFor({ timeout: 120_000 });
});

test("keys step, pause, reset, change the puzzle and the panel", async () => {
  const page = await openPuzzle(session);
  const { missing } = await known();
  const time = page.locator("#time");
  await page.locator("#scene").focus();
  await page.keyboard.press("ArrowLeft");
  await moveTo(page, missing);
  await page.keyboard.press(".");
  assert.equal(await time.inputValue(), "1");
  await press(page, ".", 3);
  await page.keyboard.press(",");
  assert.equal(await time.inputValue(), "3");
  await page.keyboard.press("Space");
  await waitForValue(page, "#time", (value) => Number(value) > 10);
  await page.keyboard.press("Space");
  const paused = await time.inputValue();
  await pause(page, 200);
  assert.equal(await time.inputValue(), paused);
  await page.keyboard.press("r");
  await says(page, /Ready/);

  const first = await page.locator("#task").inputValue();
  await page.keyboard.press("]");
  assert.notEqual(await page.locator("#task").inputValue(), first);
  await page.keyboard.press("[");
  assert.equal(await page.locator("#task").inputValue(), first);

  await page.keyboard.press("2");
  await page.locator("#imagine").waitFor();
  await tabTo(page, "tab-imagine");
  await page.keyboard.press("ArrowRight");
  assert.equal(await focusedId(page), "tab-make");
  await page.keyboard.press("?");
  await page.locator("#keys-dialog[open]").waitFor();
  await page.keyboard.press("Escape");
  await page.locator("#keys-dialog[open]").waitFor({ state: "detached" });
});

test("what has the focus can be seen", async () => {
  const page = await openPuzzle(session);
  for (const id of ["next", "run", "radius", "tab-play"]) {
    await tabTo(page, id);
    const outline = await page.locator(`#${id}`).evaluate((element) => getComputedStyle(element).outlineStyle);
    assert.equal(outline, "solid", id);
  }
});

test("where nothing has the focus, the arrows move the ball", async () => {
  const page = await openPuzzle(session);
  await blur(page);
  await page.keyboard.press("Shift+ArrowUp");
  const [x, y, r] = await ball(page);
  await page.keyboard.press("Shift+ArrowLeft");
  await page.keyboard.press("+");
  assert.deepEqual(await ball(page), [x - 10, y, r + 1]);
});

test("where the ball comes to rest is announced", async () => {
  const page = await openPuzzle(session, { fragment: "&forecast=off" });
  await page.keyboard.press("ArrowRight");
  const [x, y, r] = await ball(page);
  await page
    .locator("#announcement")
    .filter({ hasText: `x ${x}, y ${y}, radius ${r}` })
    .waitFor({ state: "attached" });
});

/** Takes the focus from everything, as when a button is disabled, or in some browsers by a click on mere words. */
async function blur(page) {
  await (await focused(page)).evaluate((element) => element.blur());
}

test("no key acts on what lies behind a dialog, not even if nothing in it has the focus", async () => {
  const page = await openPuzzle(session);
  await type(page, (await known()).missing);
  await page.waitForFunction(() => /ball=/.test(location.hash));
  const before = { url: page.url(), ball: await ball(page) };
  for (const [opener, dialog] of [
    ["#share-button", "#share-dialog[open]"],
    ["#keys-button", "#keys-dialog[open]"],
  ]) {
    await page.locator(opener).click();
    await page.locator(dialog).waitFor();
    await blur(page);
    for (const key of ["]", "2", "v", "ArrowLeft", "Control+z", "Space"]) await page.keyboard.press(key);
    assert.ok(await page.locator(dialog).isVisible());
    assert.deepEqual({ url: page.url(), ball: await ball(page) }, before);
    assert.match(await page.locator("#run").innerText(), /Drop it/);
    await page.keyboard.press("Escape");
    await page.locator(dialog).waitFor({ state: "detached" });
  }
  await page.keyboard.press("2");
  await page.locator("#imagine").waitFor();
});

test("a dialog over the presentation is closed alone", async () => {
  const page = await openPuzzle(session, { fragment: "&view=presentation" });
  await page.keyboard.press("?");
  await page.locator("#keys-dialog[open]").waitFor();
  await blur(page);
  await page.keyboard.press("Escape");
  await page.locator("#keys-dialog[open]").waitFor({ state: "detached" });
  assert.ok(await page.locator("#presentation").isVisible());
});

test("a key that is held down runs once", async () => {
  const page = await openPuzzle(session);
  await type(page, (await known()).missing);
  for (const key of ["Space", "Enter"]) {
    await page.locator("#scene").focus();
    for (let repeat = 0; repeat < 4; repeat += 1) await page.keyboard.down(key);
    await page.locator("#run", { hasText: "Pause" }).waitFor();
    await page.keyboard.up(key);
    await page.locator("#reset").click();
  }
});

test("letters and digits that are typed into a name are no shortcuts", async () => {
  const page = await openPuzzle(session, { fragment: "&panel=make" });
  const name = page.locator("#make-name");
  await name.fill("");
  await name.pressSequentially("Ramp 2 [over] no. 1, v?");
  assert.equal(await name.inputValue(), "Ramp 2 [over] no. 1, v?");
  assert.match(page.url(), /panel=make/);
  assert.equal(await page.locator("#keys-dialog[open]").count(), 0);
});

test("the ring of the focus lies inside the scene, where nothing cuts it off", async () => {
  const page = await openPuzzle(session);
  await page.locator("#scene").focus();
  await page.keyboard.press("ArrowUp");
  const outline = await page.locator(".scene").evaluate((scene) => {
    const { outlineStyle, outlineWidth, outlineOffset } = getComputedStyle(scene);
    return { outlineStyle, beyond: parseFloat(outlineWidth) + parseFloat(outlineOffset) };
  });
  assert.deepEqual(outline, { outlineStyle: "solid", beyond: 0 });
});
