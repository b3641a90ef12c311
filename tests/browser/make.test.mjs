// Making a puzzle: with the mouse, keys and numbers; what may not be played says why; keeping, files, links; the check.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { axeFindsNothing } from "./axe.mjs";
import {
  EASY,
  STILL,
  button,
  described,
  drop,
  known,
  modelIsThere,
  says,
  scene,
  spot,
  startPlayer,
} from "./player.mjs";
import { customScene } from "../../www/pkg/page/pathlight.js";

let session;
/** The green ball of the puzzle, and the other. */
let green, blue;
before(async () => {
  session = await startPlayer();
  await known();
  const { body1, body2, bodies } = customScene(EASY);
  [green, blue] = [bodies[body1], bodies[body2]];
});
after(() => session.stop());

/** Opens a puzzle to change it. */
async function openMake(link = `#task=${EASY}&panel=make`, options = {}) {
  const page = await session.open("", { ...STILL, ...options });
  await page.goto(`${session.origin}/${link}`);
  await button(page, "Play it").waitFor();
  return page;
}

async function hold(page, from, ...to) {
  await page.mouse.move(...(await spot(page, ...from)));
  await page.mouse.down();
  for (const point of to) await page.mouse.move(...(await spot(page, ...point)), { steps: 4 });
}

async function dragTo(page, from, ...to) {
  await hold(page, from, ...to);
  await page.mouse.up();
}

const addressHas = (page, pattern) => page.waitForURL((url) => pattern.test(url.hash));
const title = (page, name) => page.getByRole("heading", { name, exact: true }).waitFor();

test("a body that is dragged stays where it is dropped; the puzzle is played, and its link opens it again", async () => {
  const page = await openMake();
  // The loupe is for a finger.
  await page.locator("canvas").nth(1).waitFor({ state: "hidden" });
  await dragTo(page, [green.x, green.y], [200, 100]);
  await says(page, /Selected: the green ball at x 200, y 100/);
  await title(page, "Two Drops, changed");
  await addressHas(page, /^#scene=[\w-]+&panel=make$/);
  // Once everything is undone it is the task again.
  await page.keyboard.press("Control+z");
  await addressHas(page, /^#task=00000:058&panel=make$/);
  await page.keyboard.press("Control+y");
  await addressHas(page, /^#scene=[\w-]+&panel=make$/);
  await button(page, "Play it").click();
  await page.mouse.click(...(await spot(page, 128, 40)));
  await drop(page);
  await page.getByRole("list", { name: "You against the model" }).getByRole("button").waitFor();
  await addressHas(page, /&ball=/);
  const other = await openMake(new URL(page.url()).hash.replace(/&ball=[^&]*/, "&panel=make"));
  await title(other, "Two Drops, changed");
  await described(other, /green ball at x 200, y 100/);
  await page.goBack();
  await page.goBack();
  await title(page, "Two Drops");
});

test("what the model expects follows while a body is dragged", async () => {
  const page = await openMake();
  await page.getByRole("tab", { name: "Play" }).click();
  await modelIsThere(page);
  await page.getByRole("tab", { name: "Make" }).click();
  await hold(page, [green.x, green.y], [220, 220]);
  // Below the ball, where it will fall, is no longer what is at the edge.
  await page.waitForFunction(() => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector("canvas"));
    const colour = (x, y) =>
      canvas
        .getContext("2d")
        ?.getImageData((x / 256) * canvas.width, canvas.height - (y / 256) * canvas.height, 1, 1)
        .data.join();
    return colour(220, 150) !== colour(2, 150);
  });
  await page.mouse.up();
});

test("what may not be played says why beside the body, is not played, and is undone by keys", async () => {
  const page = await openMake();
  await dragTo(page, [green.x, green.y], [blue.x - 10, blue.y]);
  await page.getByText(/^Overlaps the blue ball by .+ px: move them apart\.$/).waitFor();
  await says(page, /Selected: the green ball.+ Overlaps the blue ball/);
  await button(page, "Play it").click({ force: true });
  await scene(page).press("Enter");
  assert.equal(await page.getByRole("tab", { name: "Make", selected: true }).count(), 1);
  await page.keyboard.press("Control+z");
  await page.locator(".problem").waitFor({ state: "detached" });
  await page.keyboard.press("Control+y");
  await page.getByText(/Not playable yet/).waitFor();
});

test("all by keys and fields: add, select, turn, numbers, role, copy, delete", async () => {
  const page = await openMake();
  await button(page, "+ Bar").click();
  await says(page, /Selected: the black bar at x 128, y 180, turned by 0 degrees, length 64, thickness 6/);
  await scene(page).focus();
  for (const key of ["ArrowRight", "Shift+ArrowDown", ",", "+"]) await page.keyboard.press(key);
  await says(page, /black bar at x 129, y 170, turned by 1 degrees, length 65/);
  await page.getByRole("combobox", { name: "It is" }).selectOption("gray: moves");
  await page.getByText("Details").click();
  await page.getByRole("spinbutton", { name: "angle" }).fill("90.5");
  await page.getByRole("spinbutton", { name: "angle" }).press("Enter");
  await says(page, /gray bar at x 129, y 170, turned by 90\.5 degrees/);
  await page.getByRole("spinbutton", { name: "length" }).fill("");
  await page.getByRole("spinbutton", { name: "length" }).press("Enter");
  assert.equal(await page.getByRole("spinbutton", { name: "length" }).inputValue(), "65");
  await scene(page).focus();
  await page.keyboard.press("d");
  await page.getByRole("combobox", { name: "Body" }).getByRole("option").nth(4).waitFor({ state: "attached" });
  // The button goes with the body, and the focus to the scene.
  await button(page, "Delete").click();
  assert.ok(await scene(page).evaluate((canvas) => canvas.matches(":focus")));
  await page.keyboard.press("n");
  await says(page, /Selected: the green ball/);
  assert.ok(await button(page, "Delete").isDisabled());
  await axeFindsNothing(page);
});

test("from an empty scene: a search finds a ball, which lies in the scene and solves it", async () => {
  const page = await openMake();
  await button(page, "Start empty").click();
  await title(page, "Custom puzzle");
  await page.getByRole("checkbox", { name: "Show every place that works" }).check();
  await button(page, "Show a solution").click();
  await says(page, /An easy one lies in the scene now\. .+ are harder\./);
  await page.getByText(/A ball of this size works at .+ of all places/).waitFor();
  await button(page, "Play it").click();
  await button(page, "Drop it").click();
  await says(page, /That was the solution: it does not count/);
  await button(page, "Your turn").waitFor();
});

test("the scene is watched without a ball, and one comes back to making", async () => {
  const page = await openMake();
  await button(page, "Watch without a ball").click();
  await button(page, "Back to making").click();
  await button(page, "Play it").waitFor();
});

test("puzzles are kept, opened, and deleted; saved as a file, and opened from it", async () => {
  const page = await openMake();
  assert.ok(await button(page, "Keep in this browser").isDisabled());
  await page.getByRole("textbox", { name: "Name" }).fill("Mine");
  // What else changes meanwhile leaves what is being typed.
  await page.emulateMedia({ colorScheme: "dark" });
  await page.locator("html[data-theme=dark]").waitFor();
  await page.getByRole("textbox", { name: "Name" }).press("Enter");
  await title(page, "Mine");
  await button(page, "Keep in this browser").click();
  const [download] = await Promise.all([page.waitForEvent("download"), button(page, "Save as a file").click()]);
  assert.equal(download.suggestedFilename(), "pathlight-mine.json");
  const file = await readFile(await download.path());
  await page.goto(`${session.origin}/#task=${EASY}&panel=make`);
  await page.reload();
  await page.getByText("Your puzzles (1)").click();
  await button(page, "Mine").click();
  await title(page, "Mine");
  await button(page, "Delete “Mine”").click();
  await page.getByText(/Your puzzles/).waitFor({ state: "detached" });
  await page.reload();
  await title(page, "Mine");
  assert.equal(await page.getByText(/Your puzzles/).count(), 0);
  const open = (name, content) =>
    page.getByLabel("Open a file").setInputFiles({ name, mimeType: "application/json", buffer: Buffer.from(content) });
  const bad = { ...JSON.parse(String(file)), body2: 0 };
  await open("bad.json", JSON.stringify(bad));
  await page.getByRole("alert").getByText("This file was not opened: Green cannot be its own goal").waitFor();
  await open("none.json", "[1");
  await page.getByRole("alert").getByText("it holds no puzzles of Pathlight").waitFor();
  await open("two.json", JSON.stringify([JSON.parse(String(file)), customScene("00007:008")]));
  await page.getByText("Your puzzles (2)").waitFor();
  await page.goto(`${session.origin}/#task=${EASY}&panel=make`);
  await title(page, "Two Drops");
  await open("mine.json", file);
  await title(page, "Mine");
});

test("a damaged link says so, and something else can be played", async () => {
  const page = await session.open("", STILL);
  await page.goto(`${session.origin}/#scene=abc`);
  await page
    .getByRole("alert")
    .getByText("This link’s puzzle cannot be opened: a part of the link is missing")
    .waitFor();
  await button(page, "Play against it").waitFor();
});
