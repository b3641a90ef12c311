// Links open what they name; a link that cannot be followed is a sentence on the page, with a link that can.

import assert from "node:assert/strict";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { EASY, attempts, ball, click, known, openPanel, openPuzzle, pause, says, type } from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

const notice = (page) => page.locator("#notice:visible #notice-text");

test("a link opens the same puzzle, panel, layers and ball", async () => {
  const page = await openPuzzle(session, {
    fragment: "&panel=imagine&layers=target,placement&opacity=0.5&ball=100,200,10",
  });
  assert.equal(await page.locator("#task").inputValue(), EASY);
  assert.equal(await page.locator("#tab-imagine").getAttribute("aria-selected"), "true");
  for (const [map, on] of Object.entries({ base: false, target: true, action: false, placement: true })) {
    assert.equal(await page.locator(`[data-map=${map}] input`).isChecked(), on, map);
  }
  assert.equal(await page.locator("#opacity").inputValue(), "0.5");
  assert.deepEqual(await ball(page), [100, 200, 10]);
});

test("what the page shows is in its address, and opens again from there", async () => {
  const page = await openPuzzle(session);
  await type(page, [90, 190, 7]);
  await openPanel(page, "compare");
  await page.waitForFunction(() => /ball=90,190,7/.test(location.hash) && /panel=compare/.test(location.hash));
  await page.reload();
  await page.locator("#scene").waitFor();
  assert.deepEqual(await ball(page), [90, 190, 7]);
  assert.equal(await page.locator("#tab-play").getAttribute("aria-selected"), "true");
  assert.equal(await page.locator("#open-compare").getAttribute("aria-expanded"), "true");
});

test("a link to the same puzzle without a ball leaves it, and back moves none; the address follows", async () => {
  const page = await openPuzzle(session);
  await type(page, [90, 190, 7]);
  await page.evaluate((task) => void (location.hash = `#task=${task}&panel=imagine`), EASY);
  await page.waitForFunction(() => /ball=90,190,7/.test(location.hash) && /panel=imagine/.test(location.hash));
  await page.locator("#tab-play").click();
  await page.waitForFunction(() => !/panel/.test(location.hash));
  await type(page, [91, 190, 7]);
  await page.goBack();
  await page.waitForFunction(() => /ball=91,190,7/.test(location.hash) && /panel=imagine/.test(location.hash));
  assert.deepEqual(await ball(page), [91, 190, 7]);
});

test("what is changed just before the page is loaded again is in its address", async () => {
  const page = await openPuzzle(session, { fragment: "&ball=90,190,7" });
  await page.clock.install();
  await page.locator("#scene").focus();
  await page.clock.runFor(1000);
  await page.keyboard.press("ArrowRight");
  await page.reload();
  await page.waitForFunction(() => /ball=91,190,7/.test(location.hash));
});

test("of a custom puzzle that cannot be read nothing is shown but why", async () => {
  const page = await openPuzzle(session);
  await page.evaluate(() => void (location.hash = "#scene=soup"));
  await page.locator("#problem").filter({ hasText: "damaged" }).waitFor();
  await page.evaluate(() => void (location.hash = "#scene=soup&view=presentation"));
  await page.locator("#puzzle[view=presentation]").waitFor();
  assert.ok(await page.locator("#problem").filter({ hasText: "damaged" }).isVisible());
  assert.ok(await page.locator("#scene").isHidden());
  assert.ok(await page.locator("#home").isVisible(), "the header leads away");
  await page.goBack();
  await page.goBack();
  await page.locator("#scene").waitFor();
});

test("a link hides what a lesson leaves out, and goes on hiding it", async () => {
  const page = await openPuzzle(session, {
    fragment: "&panel=imagine&hide=story,imagine,predict,map,compare,watch,attempts,fields",
  });
  for (const hidden of [
    "#story",
    "#tab-imagine",
    "#race",
    "#open-compare",
    "#imagine",
    "#more-button",
    "#watch",
    "#play-attempts",
    "#ball-x",
  ]) {
    assert.ok(await page.locator(hidden).isHidden(), hidden);
  }
  assert.ok(await page.locator("#play").isVisible(), "instead of the panel that is hidden");
  await page.locator("#scene").focus();
  await page.keyboard.press("ArrowUp");
  await says(page, /Ready|Not here/);
  await page.keyboard.press("Control+z");
  await says(page, /place the red ball/);
  await page.keyboard.press("2");
  assert.ok(await page.locator("#imagine").isHidden(), "nor by its key");
  await page.locator("#next").click();
  assert.ok(await page.locator("#tab-imagine").isHidden(), "on the next puzzle too");
  await page.locator("#home").click();
  await page.locator("#templates a").nth(2).click();
  assert.ok(await page.locator("#tab-imagine").isHidden(), "and on one from the grid");
  assert.match(page.url(), /hide=story,fields,watch,attempts,imagine,compare,predict,map/);
});

test("hide=puzzles: no button and no key leads to another puzzle", async () => {
  const page = await openPuzzle(session, { fragment: "&hide=puzzles" });
  assert.ok(await page.locator("#next").isHidden());
  await page.locator("#home").click({ force: true });
  await page.locator("#scene").focus();
  await page.keyboard.press("]");
  assert.match(page.url(), new RegExp(`task=${EASY}`));
  assert.ok(await page.locator("#scene").isVisible());
  await page.goto(`${session.origin}/#task=${EASY}`);
  await page.locator("#next").waitFor();
});

test("hide=puzzles: neither notices nor grid lead to another puzzle", async () => {
  const page = await openPuzzle(session, { fragment: "&hide=puzzles" });
  for (const link of ["task=00007:999&hide=puzzles", "layers=soup&hide=puzzles", "hide=puzzles"]) {
    await page.goto(`${session.origin}/#${link}`);
    await notice(page).waitFor();
    assert.equal(
      await page
        .locator("a:visible")
        .filter({ hasNotText: /Pathlight|Skip/ })
        .count(),
      0,
      link,
    );
    assert.ok(await page.locator("#gallery").isHidden(), link);
  }
});

for (const [panel, tab, label] of [
  ["compare", "play", "The model’s balls, one by one"],
  ["predict", "imagine", "Predict"],
  ["map", "imagine", "Check the answer"],
]) {
  test(`panel=${panel} opens its part of the tab ${tab}`, async () => {
    const page = await openPuzzle(session, { fragment: `&panel=${panel}` });
    await page.locator(`#${panel}`).waitFor();
    assert.equal(await page.locator(`#tab-${tab}`).getAttribute("aria-selected"), "true");
    assert.equal(await page.locator(`#open-${panel}`).textContent(), label);
    await page.locator(`#tab-${tab}`).click();
    await page.locator(`#${panel}`).waitFor({ state: "hidden" });
    assert.ok(await page.locator(`#${tab}`).isVisible());
    await page.goBack();
    await page.locator(`#${panel}`).waitFor();
  });
}

test("a tab that has lost its own panel is named after what is left", async () => {
  const page = await openPuzzle(session, { fragment: "&hide=imagine,map" });
  await page.locator("#tab-imagine", { hasText: "Predict" }).click();
  await page.locator("#predict").waitFor();
  assert.ok(await page.locator("#parts-imagine").isHidden(), "there is nothing to switch");
});

test("a panel that the link hides does nothing, although the link names it", async () => {
  const page = await openPuzzle(session, { fragment: "&panel=predict&hide=predict" });
  assert.ok(await page.locator("#play").isVisible());
  await says(page, /place the red ball/);
  await click(page, 100, 240);
  assert.deepEqual((await ball(page)).slice(0, 2), [100, 240], "the scene takes no pen");

  await page.goto(`${session.origin}/#task=00007:008&panel=compare&proposal=1&hide=compare`);
  await page.locator('#task option:checked[value="00007:008"]').waitFor({ state: "attached" });
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor({ state: "attached" });
  // Longer than the model takes to propose, if it is asked.
  await pause(page, 1500);
  await says(page, /place the red ball/);
});

test("a link that hides what the model does hides the sheet about it too", async () => {
  const page = await openPuzzle(session, { fragment: "&hide=imagine,compare" });
  assert.ok(await page.locator("#about-button").isHidden());
  await page.goto(`${session.origin}/#task=${EASY}&hide=compare`);
  await page.locator("#about-button").waitFor();
});

test("a model that is named in the link is the one that imagines", async () => {
  const page = await openPuzzle(session, { fragment: "&panel=imagine&model=nobody" });
  await page
    .locator("#imagine-trouble:visible")
    .filter({ hasText: "There is no model “nobody” here. There is: " })
    .waitFor();
  const name = (await page.locator("#imagine-trouble p").textContent()).match(/There is: ([\w-]+)/)[1];
  await page.locator("#imagine-trouble button").click();
  await page
    .locator("#card")
    .filter({ hasText: `model “${name}”` })
    .waitFor({ state: "attached" });
  await page.waitForFunction(() => !/model=/.test(location.hash));
  await page.goto(`${session.origin}/#task=${EASY}&panel=imagine&model=${name}`);
  await page
    .locator("#card")
    .filter({ hasText: `model “${name}”` })
    .waitFor({ state: "attached" });
});

for (const [link, words] of [
  ["task=00007:999", /puzzle 00007:999, which does not exist/],
  ["task=00099:000", /puzzle 00099:000, which does not exist/],
  ["task=funnel", /“task=funnel”, which Pathlight does not understand/],
  ["layers=soup", /“layers=soup”/],
  ["hide=scene", /“hide=scene”/],
  ["constructor=1", /“constructor=1”/],
  ["%E0%A4%A", /does not understand/],
]) {
  test(`a bad link (${link}) is a sentence with a way on`, async () => {
    const page = await session.open(`/#${link}`);
    await notice(page).filter({ hasText: words }).waitFor();
    await page.locator("#notice-actions a", { hasText: "All puzzles" }).click();
    await page.locator("#gallery").waitFor();
    await page.locator("#notice").waitFor({ state: "hidden" });
  });
}

test("a number that a template does not have leads to its first puzzle", async () => {
  const page = await session.open("/#task=00007:999");
  await page.locator("#notice-actions a").first().click();
  await page.locator("#scene").waitFor();
  assert.match(await page.locator("#task").inputValue(), /^00007:/);
});

test("without WebAssembly the page says what it needs", async () => {
  const page = await session.open("/icon.svg");
  await page.addInitScript(() => Reflect.deleteProperty(globalThis, "WebAssembly"));
  await page.goto(session.origin);
  await notice(page).filter({ hasText: "no WebAssembly" }).waitFor();
});

test("without the wasm package the page says so", async () => {
  const page = await session.open("/icon.svg");
  await page.route("**/*.wasm", (route) => route.fulfill({ status: 404 }));
  await page.goto(`${session.origin}/#task=${EASY}&panel=map`);
  await notice(page).filter({ hasText: "the server answered 404" }).waitFor();
  await page.unroute("**/*.wasm");
  await page.locator("#notice-actions").getByText("Try again").click();
  await page.locator("#map").waitFor();
  assert.match(page.url(), new RegExp(`#task=${EASY}&panel=map$`), "trying again keeps the link");
  const problems = session.takeProblems();
  assert.ok(
    problems.every((problem) => /404|preload/.test(problem)),
    problems.join("\n"),
  );
});

test("a worker that dies is a sentence, and can be started again", async () => {
  const page = await openPuzzle(session, { fragment: "&panel=imagine" });
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
  await page.workers()[0].evaluate(
    () =>
      void setTimeout(() => {
        throw new Error("gone");
      }),
  );
  await page
    .locator("#imagine-trouble:visible")
    .filter({ hasText: /model has stopped.*gone/ })
    .waitFor();
  session.takeProblems();
  await page.locator("#imagine-trouble button").click();
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
});

test("damaged weights are refused in words", async () => {
  const page = await session.open("/icon.svg");
  await page
    .context()
    .route("**/assets/*.safetensors", (route) =>
      route.fulfill({ body: "soup", contentType: "application/octet-stream" }),
    );
  await page.goto(`${session.origin}/#task=${EASY}&panel=imagine`);
  await page.locator("#imagine-trouble:visible").filter({ hasText: "it is damaged or old" }).waitFor();
});

test("without weights a person can still play", async () => {
  const empty = await mkdtemp(join(tmpdir(), "pathlight-assets-"));
  const bare = await start({ serve: ["--assets", empty] });
  try {
    const page = await openPuzzle(bare, { fragment: "&panel=imagine", reducedMotion: true });
    await page
      .locator("#imagine-trouble:visible")
      .filter({ hasText: "The model’s weights are missing here" })
      .waitFor();
    await openPanel(page, "compare");
    await page.locator("#compare-trouble:visible").filter({ hasText: "weights are missing" }).waitFor();
    assert.ok(await page.locator("#model-turn").isDisabled());
    await page.locator("#tab-play").click();
    const { solving } = await known();
    await type(page, solving);
    await page.locator("#run").click();
    await says(page, /^Solved!/);
    assert.equal(await attempts(page), 1);
    const problems = bare.takeProblems();
    assert.ok(
      problems.every((problem) => /404/.test(problem)),
      problems.join(),
    );
  } finally {
    await bare.stop();
    await rm(empty, { recursive: true });
  }
});
