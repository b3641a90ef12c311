// The page of www as a newcomer meets it: home, sharing and lessons.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { axeFindsNothingInLightAndDark } from "./axe.mjs";
import {
  EASY,
  STILL,
  button,
  described,
  drop,
  known,
  modelIsThere,
  openPuzzle,
  place,
  says,
  spot,
  startPlayer,
} from "./player.mjs";

/** The puzzle in the picture, which has been recorded. */
const FIRST_TASK = JSON.parse(await readFile(new URL("../../assets/home.json", import.meta.url), "utf8")).scene.task;

let session;
before(async () => {
  session = await startPlayer();
});
after(() => session.stop());

const heading = (page, name) => page.getByRole("heading", { name });

/** @param {import("playwright-core").BrowserContextOptions} options */
async function openHome(options = STILL) {
  const page = await session.open("", options);
  await page.goto(`${session.origin}/`);
  await button(page, /Play against it|Spiel gegen sie/).waitFor();
  return page;
}

test("the picture shows what the model imagines; a tap in it, and one plays against it and can win at once", async () => {
  const page = await openHome({});
  await page.getByText("It imagines 40 futures").waitFor();
  await page.getByText("and picks one").waitFor();
  await page.getByText("its ball really drops").waitFor();
  await page.getByText("Your turn").waitFor();
  const { solving } = await known(FIRST_TASK);
  await page.mouse.click(...(await spot(page, solving[0], solving[1])));
  await page.getByRole("slider", { name: "Size" }).fill(String(solving[2]));
  await described(page, new RegExp(`x ${solving[0]}, y ${solving[1]}, with radius ${solving[2]}`));
  assert.equal(new URL(page.url()).hash, "");
  await modelIsThere(page);
  await page.getByRole("application").press("Enter");
  await page.getByRole("combobox", { name: "Speed" }).selectOption("4×");
  await says(page, /You beat the model with your first ball!/);
  await button(page, "Send it on").click();
  const dialog = page.getByRole("dialog", { name: "Share" });
  await dialog.getByText("I beat the model").waitFor();
  assert.match(await dialog.getByRole("textbox").inputValue(), new RegExp(`#task=${FIRST_TASK}&challenge=1$`));
  await dialog.getByRole("img").waitFor();
  await page.keyboard.press("Escape");
  await button(page, "Next puzzle").click();
  await page.waitForURL(/#task=/);
});

test("by keys: one button starts, and the focus is in the scene", async () => {
  const page = await openHome();
  await button(page, "Play against it").focus();
  await page.keyboard.press("Enter");
  await page.keyboard.press("ArrowRight");
  await described(page, /Your ball is at/);
  await button(page, "Drop it").waitFor();
});

test("where motion is unwelcome the end is shown at once; else the animation can be paused", async () => {
  const still = await openHome();
  await still.getByText("Your turn").waitFor();
  const moving = await openHome({});
  // No key changes what is behind the animation.
  await moving.keyboard.press("3");
  await moving.keyboard.press("Space");
  await button(moving, "Play the animation").waitFor();
  assert.equal(new URL(moving.url()).hash, "");
});

test("a kind opens the puzzle that it names, and says afterwards how far one has come", async () => {
  const page = await openHome();
  const tiles = page.locator("ul.kinds").getByRole("link");
  await tiles.nth(24).waitFor();
  assert.equal(await tiles.count(), 25);
  await page.getByRole("link", { name: /^Two Drops/ }).click();
  await heading(page, "Two Drops").waitFor();
  await page.waitForFunction(() => scrollY === 0);
  const task = /task=([\d:]+)/.exec(page.url())?.[1] ?? "";
  const { missing } = await known(task);
  await place(page, missing[0], task);
  await drop(page);
  await page.getByRole("link", { name: "Pathlight" }).click();
  await page.getByRole("link", { name: /^Two Drops.*Puzzle 1 of 20 · 1 missed/s }).waitFor();
  await page.getByText("So far you have tried 1 puzzle and solved 0, with 1 ball").waitFor();
});

test("a puzzle is opened by its number, the one of the day says so, and back leads home", async () => {
  const page = await openHome();
  await page.getByRole("textbox", { name: "Or by number" }).fill("7:8");
  await page.keyboard.press("Enter");
  await heading(page, "Funnel").waitFor();
  await page.goBack();
  await page.getByRole("link", { name: /Puzzle of the day/ }).click();
  await page.getByText("Puzzle of the day").waitFor();
});

test("progress is saved to a file, forgotten, and read again; a file of other things is named", async () => {
  const page = await openPuzzle(session, `#task=${EASY}`, STILL);
  const { missing } = await known();
  await place(page, missing[0]);
  await drop(page);
  await page.getByRole("link", { name: "Pathlight" }).click();
  await page.getByText("So far you have tried 1 puzzle").click();
  const [download] = await Promise.all([page.waitForEvent("download"), button(page, "Save to a file").click()]);
  const file = await download.path();
  await button(page, "Forget all attempts").click();
  await page.getByRole("dialog").getByRole("button", { name: "Forget all attempts" }).click();
  await page.getByText("Your progress").waitFor();
  const input = page.getByLabel("Open a file");
  const line = await readFile(file, "utf8");
  // With the mark that some systems put first, and a line that is not an attempt.
  const text = `\uFEFF${line}{}\n`;
  await input.setInputFiles({ name: "progress.jsonl", mimeType: "text/plain", buffer: Buffer.from(text) });
  await page
    .getByRole("alert")
    .getByText("1 attempt in the file, 1 of them new here. 1 line isn’t an attempt.")
    .waitFor();
  await page.getByText("So far you have tried 1 puzzle").waitFor();
  await input.setInputFiles({ name: "cat.png", mimeType: "image/png", buffer: Buffer.from([137, 80]) });
  await page.getByRole("alert").getByText("cat.png is not a file of attempts").waitFor();
});

test("a challenge shows nothing of the model until it is solved", async () => {
  const page = await openPuzzle(session, `#task=${EASY}&challenge=2`, STILL);
  await page.getByText("Somebody solved this with ball 2").first().waitFor();
  assert.equal(await page.getByRole("checkbox", { name: "The model’s guess" }).count(), 0);
  const { solving } = await known();
  await page.evaluate((hash) => (location.hash = hash), `#task=${EASY}&challenge=2&ball=${solving.join()}`);
  await drop(page);
  await says(page, /You win: they needed 2 balls/);
  const attempt = page.getByRole("list", { name: "You against the model" }).getByRole("button");
  assert.doesNotMatch((await attempt.getAttribute("aria-label")) ?? "", /Model/);
  await modelIsThere(page);
});

test("text and link are there without a picture, and it is said why there is none", async () => {
  const page = await session.open("", STILL);
  await page.addInitScript(() => (HTMLCanvasElement.prototype.toBlob = (answer) => answer(null)));
  await page.goto(`${session.origin}/#task=${EASY}`);
  await button(page, "Share").click();
  await page.getByText("This browser can’t make the picture").waitFor();
  const noisy = await session.open("", STILL);
  await noisy.addInitScript(() => {
    const { getImageData } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.getImageData = function (...place) {
      const image = getImageData.apply(this, place);
      image.data[0] ^= 1;
      return image;
    };
  });
  await noisy.goto(`${session.origin}/#task=${EASY}`);
  await button(noisy, "Share").click();
  await noisy.getByText("stripes instead of one").waitFor();
});

test("a lesson of two puzzles without the model leads from one to the other alone, and has a QR code", async () => {
  const page = await openPuzzle(session, `#task=${EASY}`, STILL);
  await button(page, "Menu").click();
  await button(page, "Link for a lesson").click();
  const dialog = page.getByRole("dialog", { name: "Link for a lesson" });
  // A click beside its fields, within it, closes nothing.
  await dialog.click({ position: { x: 5, y: 5 } });
  await dialog.getByRole("textbox", { name: "Puzzles" }).fill("7:8 nonsense");
  await dialog.getByRole("alert").getByText("nonsense: that isn’t a puzzle").waitFor();
  await dialog.getByRole("textbox", { name: "Puzzles" }).fill("7:8, 0:58");
  await dialog.getByRole("radio", { name: "Play only" }).check();
  await dialog.getByText("Customise").click();
  await dialog.getByRole("checkbox", { name: "The model", exact: true }).uncheck();
  await dialog.getByRole("img", { name: "QR code" }).waitFor();
  const link = await dialog.getByRole("textbox", { name: "The link" }).elementHandle();
  await page.waitForFunction((link) => link.value.includes("&lesson=00007:008,00000:058&hide=puzzles,model"), link);
  const address = await link.inputValue();
  const lesson = await session.openIn(page.context(), "");
  await lesson.goto(address);
  await heading(lesson, "Funnel").waitFor();
  assert.equal(await lesson.getByRole("checkbox").count(), 0);
  await button(lesson, "Next puzzle in the list").click();
  await heading(lesson, "Two Drops").waitFor();
  await lesson.getByRole("button", { name: "Next puzzle in the list", disabled: true }).waitFor();
  await button(lesson, "Previous puzzle").click();
  await heading(lesson, "Funnel").waitFor();
});

test("the presentation of what the model imagines leads through its steps", async () => {
  const page = await openPuzzle(session, `#task=${EASY}&panel=imagine&step=base&view=presentation`, STILL);
  await heading(page, "If you do nothing").waitFor();
  await button(page, "Next step").click();
  await heading(page, "What green must do").waitFor();
  // By keys and by a clicker, wherever the focus is but in a field.
  for (const [key, name] of [
    ["ArrowRight", "What red must do"],
    ["PageDown", "Where to start"],
    ["ArrowLeft", "What red must do"],
    ["PageUp", "What green must do"],
  ]) {
    await page.keyboard.press(key);
    await heading(page, name).waitFor();
  }
  await button(page, "Leave the presentation").click();
  await page.getByRole("tab", { name: "Imagine", selected: true }).waitFor();
});

test("the presentation shows scene and sentence, can be played, and is left by Escape", async () => {
  const page = await openPuzzle(session, `#task=${EASY}&view=presentation`, STILL);
  await page.getByText("Two balls fall side by side").waitFor();
  assert.equal(await page.getByRole("banner").count(), 0);
  const { missing } = await known();
  await page.mouse.click(...(await spot(page, missing[0][0] + 20, missing[0][1])));
  await described(page, /Your ball is at/);
  await page.keyboard.press("Escape");
  await heading(page, "Two Drops").waitFor();
});

test("home and dialogs have nothing that axe objects to, in light and dark", async () => {
  const page = await openHome();
  await page.getByText("Your turn").waitFor();
  await axeFindsNothingInLightAndDark(page, "home");
  for (const [item, sign] of [
    ["Link for a lesson", page.getByRole("img", { name: "QR code" })],
    ["About Pathlight", page.getByText("How to cite it")],
  ]) {
    await button(page, "Menu").click();
    await button(page, item).click();
    await sign.waitFor();
    await axeFindsNothingInLightAndDark(page, item);
    await page.keyboard.press("Escape");
  }
  await button(page, "Share").click();
  await page.getByRole("dialog").getByRole("img").waitFor();
  await axeFindsNothingInLightAndDark(page, "Share");
});
