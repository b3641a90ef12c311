// axe finds nothing serious or critical on any view, on a desktop and on a phone, light and dark.

import { after, before, test } from "node:test";
import { axeFindsNothingInLightAndDark } from "./axe.mjs";
import { start } from "./harness.mjs";
import { EASY, known, openPanel, openPuzzle, playModelTurn, says, type } from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

const SCREENS = {
  "a desktop": { viewport: { width: 1280, height: 800 } },
  "a phone": { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true },
};

for (const [screen, size] of Object.entries(SCREENS)) {
  test(`the grid, a bad link and all sheets on ${screen}`, async () => {
    const page = await session.open("/#task=00007:999", size);
    await page.locator("#templates a").first().waitFor();
    await page.evaluate(
      (task) =>
        localStorage.setItem("pathlight.progress", JSON.stringify({ tasks: { [task]: { attempts: 3, solved: 2 } } })),
      EASY,
    );
    await axeFindsNothingInLightAndDark(page, "bad link");
    await page.reload();
    await page.locator("#progress:visible").waitFor();
    await axeFindsNothingInLightAndDark(page, "grid");
    for (const sheet of ["keys-dialog", "about-dialog", "forget-dialog"]) {
      await page.locator(`#${sheet}`).evaluate((dialog) => dialog.showModal());
      await axeFindsNothingInLightAndDark(page, sheet);
      await page.keyboard.press("Escape");
    }
  });

  test(`placing, running, solved, missed and overlaid on ${screen}`, async () => {
    const page = await openPuzzle(session, size);
    const { solving, missing, invalid } = await known();
    await axeFindsNothingInLightAndDark(page, "placing");
    await type(page, missing);
    await page.locator("#forecast-on").check();
    await page.locator("#forecast-words").filter({ hasText: "model’s guess:" }).waitFor();
    await page.locator("#forecast-how summary").click();
    await axeFindsNothingInLightAndDark(page, "what would this ball do?");
    await page.locator("#speed").selectOption("0.25");
    await page.locator("#run").click();
    await says(page, /is running/);
    await axeFindsNothingInLightAndDark(page, "running");
    await page.locator("#reset").click();
    await page.emulateMedia({ reducedMotion: "reduce" });
    for (const { one, words } of [
      { one: missing, words: /^Not solved/ },
      { one: solving, words: /^Solved/ },
      { one: invalid, words: /does not count/ },
    ]) {
      await type(page, one);
      await page.locator("#run").click();
      await says(page, words);
      await axeFindsNothingInLightAndDark(page, String(words));
    }
    await page.locator("#play-attempts [data-act=overlay]").first().click();
    await says(page, /\(dashed\)/);
    await axeFindsNothingInLightAndDark(page, "overlaid");
  });

  test(`imagine and compare on ${screen}`, async () => {
    const page = await openPuzzle(session, {
      ...size,
      fragment: "&panel=imagine&layers=base,placement",
      reducedMotion: true,
    });
    await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
    await axeFindsNothingInLightAndDark(page, "imagine");
    await openPanel(page, "compare");
    await axeFindsNothingInLightAndDark(page, "compare, before");
    await playModelTurn(page);
    await axeFindsNothingInLightAndDark(page, "compare, after");
  });

  test(`how the model thinks on ${screen}`, async () => {
    const page = await openPuzzle(session, { ...size, fragment: "&panel=imagine", reducedMotion: true });
    await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
    await page.locator("#walkthrough-next").click();
    for (const sum of await page.locator("#imagine summary:visible").all()) await sum.click();
    await axeFindsNothingInLightAndDark(page, "a step of the story, read");
    await page.locator("#walkthrough-dots button:visible").last().click();
    await axeFindsNothingInLightAndDark(page, "the last step of the story");
    await openPanel(page, "predict");
    await axeFindsNothingInLightAndDark(page, "predict");
    await page.locator("#scene").press("Shift+ArrowDown");
    await page.locator("#predict-watch").click();
    await page.locator("#predict-result:visible").waitFor();
    await axeFindsNothingInLightAndDark(page, "predict, measured");
    await openPanel(page, "imagine");
    await page.locator("#walkthrough-all").click();
    await page.locator("#runs li").first().waitFor();
    await axeFindsNothingInLightAndDark(page, "imagined and real");
    await openPanel(page, "compare");
    await page.waitForFunction(() => /panel=compare/.test(location.hash));
    await page.evaluate(
      (task) =>
        localStorage.setItem("pathlight.progress", JSON.stringify({ tasks: { [task]: { attempts: 3, solved: 2 } } })),
      EASY,
    );
    await page.reload();
    await page.locator("#model-turn:enabled").click();
    await page.locator("#score:visible").waitFor({ timeout: 120_000 });
    await page.locator("#proposal-next").click();
    await page.locator("#proposal-facts:visible").waitFor();
    for (const sum of await page.locator("#tabpanel-play summary:visible").all()) await sum.click();
    await axeFindsNothingInLightAndDark(page, "a ball of the model’s, and the score");
    await page.locator("#more-button").click();
    await axeFindsNothingInLightAndDark(page, "the menu");
    await page.keyboard.press("Escape");
    await openPanel(page, "map");
    await page.locator("#solve-map-search").click();
    await page.locator("#solve-map-words").filter({ hasText: /tried/ }).waitFor();
    await page.locator("#solve-map-placement").check();
    await axeFindsNothingInLightAndDark(page, "map");
  });
}
