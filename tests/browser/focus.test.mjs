// The focus is never lost: what takes it when what has it goes.

import { after, before, test } from "node:test";
import { EASY, STILL, button, drop, known, openPuzzle, place, scene, startPlayer } from "./player.mjs";

let session;
before(async () => (session = await startPlayer()));
after(() => session.stop());

const hasFocus = (locator) => locator.and(locator.page().locator(":focus")).waitFor();

test("a dialog gives it back to what opened it, or to the menu", async () => {
  const page = await openPuzzle(session, `#task=${EASY}`, STILL);
  for (const leave of [() => button(page, "Close").press("Enter"), () => page.keyboard.press("Escape")]) {
    await button(page, "Share").press("Enter");
    await page.getByRole("dialog").waitFor();
    await leave();
    await hasFocus(button(page, "Share"));
    const menu = button(page, "Menu");
    await menu.press("Enter");
    await button(page, "About Pathlight").press("Enter");
    await page.getByRole("dialog").waitFor();
    await leave();
    await hasFocus(menu);
  }
});

test("a notice that is closed, and a button that goes with what it did, leave it to the scene", async () => {
  const page = await session.open("", STILL);
  await page.goto(`${session.origin}/#task=00099:000`);
  await button(page, "Close").press("Enter");
  await hasFocus(scene(page));
  await page.goto(`${session.origin}/#task=${EASY}&view=presentation`);
  await button(page, "Leave the presentation").press("Enter");
  await hasFocus(scene(page));
  await page.getByRole("tab", { name: "Predict" }).click();
  await scene(page).press("Shift+ArrowDown");
  await button(page, "Wipe the line").press("Enter");
  await hasFocus(scene(page));
  await page.getByRole("tab", { name: "Play" }).click();
  const { missing } = await known();
  await place(page, missing[0]);
  await drop(page);
  await button(page, "Play it again").press("Enter");
  await button(page, "Play it again").waitFor({ state: "detached" });
  await hasFocus(scene(page));
});

test("the large button keeps it, whatever it does", async () => {
  const page = await openPuzzle(session, `#task=${EASY}`, STILL);
  const { solving } = await known();
  await place(page, solving);
  await button(page, "Drop it").press("Enter");
  await hasFocus(button(page, "Next puzzle"));
  await page.keyboard.press("Enter");
  await hasFocus(button(page, "Drop it"));
});
