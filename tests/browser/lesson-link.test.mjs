// The dialog that makes a link for a lesson: what it leaves out is nowhere told, the preview shows it, and the QR code
// says the link.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { axeFindsNothing } from "./axe.mjs";
import jsQR from "jsqr";
import { start } from "./harness.mjs";
import { EASY, openLesson, openPuzzle, says, type } from "./page-actions.mjs";

let session;
before(async () => (session = await start({ sources: true })));
after(() => session.stop());

async function openDialog(options = {}) {
  const page = await openPuzzle(session, options);
  await openLesson(page);
  await page.locator("#lesson-dialog[open]").waitFor();
  return page;
}

const address = (page) => page.locator("#lesson-address").inputValue();

/** What the QR code says. */
async function coded(page) {
  await page.locator("#lesson-code:visible").waitFor();
  const { data, width, height } = await page.locator("#lesson-code").evaluate((canvas) => {
    // As a phone sees it: some pixels for each module.
    const large = document.createElement("canvas");
    large.width = large.height = 6 * canvas.width;
    const context = large.getContext("2d");
    if (!context) throw new Error("no 2D canvas");
    context.imageSmoothingEnabled = false;
    context.drawImage(canvas, 0, 0, large.width, large.height);
    const image = context.getImageData(0, 0, large.width, large.height);
    return { data: Array.from(image.data), width: image.width, height: image.height };
  });
  return jsQR(Uint8ClampedArray.from(data), width, height)?.data;
}

test("a code that could not be drawn once comes with the next link", async () => {
  const page = await openPuzzle(session);
  await page.locator("#lesson-code").evaluate((canvas) => {
    const { getContext } = canvas;
    canvas.getContext = () => {
      canvas.getContext = getContext;
      throw new Error("no canvas");
    };
  });
  await openLesson(page);
  await page.locator("#lesson-code-failure").filter({ hasText: "There is no QR code: no canvas." }).waitFor();
  await page.locator("#lesson-dialog [name=map]").uncheck();
  assert.equal(await coded(page), await address(page));
  assert.ok(await page.locator("#lesson-code-failure").isHidden());
});

test("boxes by keys make the link, the preview and the code; the link opens just that", async () => {
  const page = await openDialog({ fragment: "&panel=imagine" });
  assert.equal(await address(page), page.url(), "at first it is the link to what is shown");
  for (const name of ["imagine", "compare", "map", "make", "play", "puzzles", "tools", "hint", "speed"]) {
    await page.locator(`#lesson-dialog [name=${name}]`).focus();
    await page.keyboard.press("Space");
  }
  const link = await address(page);
  assert.equal(
    link,
    `${session.origin}/#task=${EASY}&panel=predict&hide=puzzles,tools,hint,speed,play,imagine,compare,map,make`,
  );
  assert.ok(await page.locator("[name=predict]").isDisabled(), "one panel stays");
  await page.waitForFunction(
    () => document.querySelector("#lesson-preview pathlight-puzzle")?.getAttribute("panel") === "predict",
  );
  await page.locator("#lesson-preview #predict:visible").waitFor();
  const until = Date.now() + 90_000;
  while ((await coded(page)) !== link) assert.ok(Date.now() < until, "the code says the link");
  await page.locator("#lesson-own-machine:visible").waitFor();
  await page.keyboard.press("Escape");
  await page.locator("#lesson-preview pathlight-puzzle").waitFor({ state: "detached" });

  const pupil = await session.open(link.slice(session.origin.length));
  await pupil.locator("#predict:visible").waitFor();
  for (const hidden of [
    "#tabs",
    "#share-button",
    "#presentation-button",
    "#about-button",
    "#keys-button",
    "#next",
    "#speed",
    "#play",
  ]) {
    assert.ok(await pupil.locator(hidden).isHidden(), hidden);
  }
  assert.ok(await pupil.locator("#time").isVisible());
  await pupil.locator("#scene").focus();
  for (const key of ["?", "v", "2", "]"]) await pupil.keyboard.press(key);
  assert.ok(await pupil.locator("#keys-dialog").isHidden());
  assert.ok(await pupil.locator("#predict").isVisible());
  assert.equal(pupil.url(), link);
});

test("what is hidden is nowhere told, in the sheets neither", async () => {
  const page = await openPuzzle(session, { fragment: "&hide=imagine,predict,map,transport,fields,hint" });
  await page.keyboard.press("?");
  const keys = await page.locator("#keys-dialog").innerText();
  assert.match(keys, /1 to 2\s+Play, Make/);
  assert.doesNotMatch(keys, /Imagine|Predict|Map|story|step|undo/i);
  await page.keyboard.press("Escape");
  await page.locator("#about-button").click();
  assert.doesNotMatch(await page.locator("#about-dialog").innerText(), /imagine|nets|trained/i);
  await page.keyboard.press("Escape");
  assert.doesNotMatch(await page.locator("#play").innerText(), /drag|knob/i);
  for (const hidden of ["#step", "#time", "#clock", "#speed"]) assert.ok(await page.locator(hidden).isHidden(), hidden);
  await type(await openPuzzle(session, { fragment: "&hide=transport" }), [90, 190, 7]);
  assert.ok(await page.locator("#run").isVisible(), "a ball can be run");
  await page.goto(`${session.origin}/#hide=imagine,compare`);
  await page.locator("#templates a").first().waitFor();
  assert.doesNotMatch(await page.locator("#hero").innerText(), /imagine|nets|AI\b/);
});

test("in the presentation, locked there, with the ball", async () => {
  const page = await openPuzzle(session);
  await type(page, [90, 190, 7]);
  await openLesson(page);
  await page.locator("#lesson-presentation").check();
  await page.locator("#lesson-ball").check();
  await page.locator("[name=tools]").uncheck();
  const link = await address(page);
  assert.equal(link, `${session.origin}/#task=${EASY}&view=presentation&ball=90,190,7&hide=tools`);
  const pupil = await session.open(link.slice(session.origin.length));
  await pupil.locator("#presentation:visible").waitFor();
  await says(pupil, /Ready|Not here/);
  assert.ok(await pupil.locator("#presentation-leave").isHidden());
  await pupil.keyboard.press("Escape");
  await pupil.locator("#scene").press("v");
  assert.ok(await pupil.locator("#presentation").isVisible());
});

test("it is copied, or selected where the browser does not let the page copy", async () => {
  const page = await openPuzzle(session, { permissions: ["clipboard-read", "clipboard-write"] });
  await openLesson(page);
  await page.locator("[name=map]").uncheck();
  await page.locator("#lesson-copy").click();
  await page.locator("#lesson-words", { hasText: "The link is copied." }).waitFor();
  assert.equal(await page.evaluate(() => navigator.clipboard.readText()), await address(page));
  await page.evaluate(() => Object.defineProperty(navigator, "clipboard", { value: undefined }));
  await page.locator("#lesson-copy").click();
  await page.locator("#lesson-words", { hasText: "the address is selected" }).waitFor();
});

test("without the library for QR codes it says so, and the link is there", async () => {
  const page = await openPuzzle(session);
  await page.route("**/lean-qr.js", (route) => route.fulfill({ status: 404 }));
  await openLesson(page);
  await page.locator("#lesson-code-failure").filter({ hasText: "There is no QR code" }).waitFor();
  assert.match(await address(page), /#task=/);
  assert.ok(session.takeProblems().every((problem) => /404|lean-qr/.test(problem)));
});

for (const [screen, options] of Object.entries({
  "a desktop, dark": { viewport: { width: 1280, height: 800 }, colorScheme: "dark" },
  "a small tablet": { viewport: { width: 480, height: 800 }, hasTouch: true, isMobile: true },
})) {
  test(`axe finds nothing on ${screen}, and nothing scrolls sideways`, async () => {
    const page = await openDialog(options);
    await page.locator("#lesson-code:visible").waitFor();
    await axeFindsNothing(page);
    assert.ok(await page.locator("#lesson-dialog").evaluate((dialog) => dialog.scrollWidth <= dialog.clientWidth));
  });
}
