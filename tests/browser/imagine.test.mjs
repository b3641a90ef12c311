// Imagine, Predict and Data on the page of www, as a person uses them.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { axeFindsNothingInLightAndDark } from "./axe.mjs";
import {
  EASY,
  STILL,
  button,
  drop,
  known,
  modelIsThere,
  openPuzzle,
  place,
  says,
  scene,
  spot,
  startPlayer,
} from "./player.mjs";

let session;
let balls;
before(async () => {
  session = await startPlayer();
  balls = await known();
});
after(() => session.stop());

const tab = (page, name) => page.getByRole("tab", { name }).click();
const maps = (page) => page.getByRole("group", { name: "Maps over the scene" }).getByRole("button");
const pixels = (page) =>
  scene(page).evaluate((canvas) => {
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    return data.reduce((sum, value, index) => (sum * 31 + value * (index + 1)) % 1000003, 7);
  });

/** Does the scene look otherwise, once something has been done? */
async function changes(page, act) {
  const before = await pixels(page);
  await act();
  for (let tries = 0; tries < 100; tries++) if ((await pixels(page)) !== before) return;
  assert.fail("the scene looks as before");
}

test("the walkthrough leads from what happens alone to what really happens, and says how far off the model was", async () => {
  const page = await openPuzzle(session, `#task=${EASY}&panel=imagine`, STILL);
  await maps(page).first().waitFor();
  await changes(page, () => button(page, /^Step 1: If you do nothing/).click());
  assert.equal(await maps(page).first().getAttribute("aria-pressed"), "true");
  await says(page, /^If you do nothing\. Where green goes by itself/);
  await button(page, "Next step").click();
  await says(page, /^What green must do/);
  await button(page, /^Step 5: Forty futures/).click();
  await says(page, /It considered \d+ balls/);
  await changes(page, () => button(page, /^Step 6/).click());
  await says(page, /^It gave its ball .*%, and it (works|does not work)\. The path it imagined for green was .+ off/);
  await page.waitForURL(/step=run/);
  await button(page, "Your turn").click();
  await page.getByRole("button", { name: "All", exact: true, pressed: true }).waitFor();
});

test("a key that opens another panel does not lose the focus with the panel", async () => {
  const page = await openPuzzle(session, `#task=${EASY}&panel=imagine`);
  await button(page, "All").focus();
  await page.keyboard.press("5");
  await page.getByRole("tab", { name: "Data", selected: true }).and(page.locator(":focus")).waitFor();
});

test("the walkthrough plays by itself", async () => {
  const page = await openPuzzle(session, `#task=${EASY}&panel=imagine`, STILL);
  await maps(page).first().waitFor();
  await button(page, "Play the steps").click();
  await says(page, /^What green must do/);
  await button(page, "Stop").click();
  await button(page, "Play the steps").waitFor();
});

test("any number of maps lies over the scene, also after the page is loaded again; each is described", async () => {
  const page = await openPuzzle(session, `#task=${EASY}&panel=imagine`);
  await maps(page).first().waitFor();
  for (let index = 0; index < 5; index++) await changes(page, () => maps(page).nth(index).click());
  assert.match(
    await maps(page).first().getAttribute("aria-label"),
    /\(base path\): from x \d+, y \d+ to x \d+, y \d+$/,
  );
  await page.waitForURL(/layers=base,target,action,placement,success/);
  await page.reload();
  await maps(page).first().waitFor();
  for (const map of await maps(page).all()) assert.equal(await map.getAttribute("aria-pressed"), "true");
});

test("a prediction is drawn from green on, and measured against the model's, without a ball and with one", async () => {
  const page = await openPuzzle(session, `#task=${EASY}&panel=imagine`, STILL);
  await maps(page).first().waitFor();
  await tab(page, "Predict");
  assert.equal(await button(page, "Let it run").getAttribute("aria-disabled"), "true");
  const [x, y] = (await scene(page).getAttribute("aria-label"))
    .match(/The green .*? at x (\d+), y (\d+)/)
    .slice(1)
    .map(Number);
  await page.mouse.move(...(await spot(page, x, y)));
  await page.mouse.down();
  await page.mouse.move(...(await spot(page, x, 20)), { steps: 8 });
  await page.mouse.up();
  await button(page, "Let it run").click();
  const alone = await says(page, /(closer|draw).*%/i);
  assert.match(alone, /the model|both/);
  await button(page, "Your turn").click();
  await page.mouse.click(...(await spot(page, balls.missing[0][0], balls.missing[0][1])));
  await button(page, "Let it run").click();
  assert.notEqual(await says(page, /(closer|draw).*%/i), alone);
  await tab(page, "Play");
  await page.getByRole("list", { name: "You against the model" }).getByRole("button").waitFor();
});

test("a prediction is drawn by keys, too", async () => {
  const page = await openPuzzle(session, `#task=${EASY}&panel=predict`, STILL);
  await scene(page).focus();
  await page.keyboard.press("Shift+ArrowDown");
  await page.keyboard.press("Enter");
  await says(page, /You were \d+% right|(closer|draw).*%/i);
});

test("numbers place the ball, tell how imagined and real paths agree, and another model plays on", async () => {
  const page = await openPuzzle(session, `#task=${EASY}&ball=${balls.missing[0].join()}`, STILL);
  await modelIsThere(page);
  await tab(page, "Data");
  await page.getByRole("spinbutton", { name: "x" }).fill(String(balls.missing[1][0]));
  await page.getByRole("spinbutton", { name: "y" }).fill(String(balls.missing[1][1]));
  await page.getByRole("spinbutton", { name: "radius" }).fill(String(balls.missing[1][2]));
  await page.keyboard.press("Tab");
  await drop(page);
  await page.getByRole("row", { name: /Your ball \d+% \d+% [\d.]+\spx/ }).waitFor();
  await page.getByRole("row", { name: /The model’s ball \d+% \d+%/ }).waitFor();
  const [csv] = await Promise.all([page.waitForEvent("download"), button(page, "This puzzle as CSV").click()]);
  assert.match(await readFile(await csv.path(), "utf8"), /player,1,.*\r\n.*within-0,1,/);
  const [png] = await Promise.all([page.waitForEvent("download"), button(page, "Save the maps as a picture").click()]);
  assert.equal((await readFile(await png.path())).subarray(1, 4).toString(), "PNG");
  await page.getByRole("combobox", { name: "Model" }).selectOption({ label: "Model B: trained on random scenes" });
  await tab(page, "Play");
  await page.getByText(/^Model B\./).waitFor();
  await button(page, "Try again").click();
  await place(page, balls.missing[2]);
  await drop(page);
  await says(page, /model/);
});

test("a finger that drags has a loupe beside it", async () => {
  const page = await openPuzzle(session, `#task=${EASY}&ball=128,120,12`, { hasTouch: true });
  const loupe = page.locator("canvas").nth(1);
  await scene(page).evaluate((canvas) => (canvas.setPointerCapture = () => {}));
  const pointer = async (type, x, y, pointerType) => {
    const [clientX, clientY] = await spot(page, x, y);
    await scene(page).dispatchEvent(type, {
      pointerId: 1,
      clientX,
      clientY,
      bubbles: true,
      isPrimary: true,
      pointerType,
    });
  };
  await pointer("pointerdown", 128, 120, "touch");
  await pointer("pointermove", 140, 120, "touch");
  await loupe.waitFor();
  const [small, large] = [await loupe.boundingBox(), await scene(page).boundingBox()];
  assert.ok(small.width < large.width / 3 && small.y >= large.y && small.x >= large.x, "it lies within the scene");
  await pointer("pointerup", 140, 120, "touch");
  await loupe.waitFor({ state: "hidden" });
  await pointer("pointerdown", 140, 120, "mouse");
  await pointer("pointermove", 128, 120, "mouse");
  assert.equal(await loupe.isVisible(), false);
});

test("axe finds nothing in these panels, nor on a phone", async () => {
  for (const viewport of [
    { width: 1280, height: 800 },
    { width: 390, height: 664 },
  ]) {
    const page = await openPuzzle(session, `#task=${EASY}&panel=imagine&step=base`, { ...STILL, viewport });
    await maps(page).first().waitFor();
    await axeFindsNothingInLightAndDark(page, "Imagine");
    for (const name of ["Predict", "Data"]) {
      await tab(page, name);
      await axeFindsNothingInLightAndDark(page, name);
    }
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(wide <= 0, "nothing sticks out");
  }
});
