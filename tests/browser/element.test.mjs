// <pathlight-puzzle> in somebody's article.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { EASY, button, described, known, modelIsThere, scene, startPlayer } from "./player.mjs";

let session;
before(async () => (session = await startPlayer()));
after(() => session.stop());

/** Opens an article with these elements. */
async function openArticle(elements, options = {}) {
  const page = await session.open("", options);
  const body = `<!doctype html><html lang="en"><meta name="viewport" content="width=device-width">
    <script type="module" src="element.js"></script><p>Before</p>${elements}<p style="height: 200vh">After</p></html>`;
  await page.route(/article/, (route) => route.fulfill({ contentType: "text/html", body }));
  await page.goto(`${session.origin}/article`);
  await scene(page).first().waitFor();
  return page;
}

test("its attributes say what is shown, and follow the person", async () => {
  const page = await openArticle(`<pathlight-puzzle task="${EASY}" ball="128,120,9"></pathlight-puzzle>`);
  const element = page.locator("pathlight-puzzle");
  await described(page, /x 128, y 120, with radius 9/);
  await scene(page).focus();
  await page.keyboard.press("ArrowLeft");
  await described(page, /x 127/);
  assert.equal(await element.getAttribute("ball"), "127,120,9");
  await element.evaluate((one) => one.setAttribute("ball", "60,120,12"));
  await described(page, /x 60, y 120, with radius 12/);
  await element.evaluate((one) => one.setAttribute("task", "00007:008"));
  await described(page, /Click or tap the scene/);
  assert.equal(await element.getAttribute("ball"), null);
});

test("a puzzle that is changed is its attribute, until another is named", async () => {
  const page = await openArticle(`<pathlight-puzzle task="${EASY}" panel="make"></pathlight-puzzle>`);
  const element = page.locator("pathlight-puzzle");
  await button(page, "+ Bar").click();
  await page.locator("pathlight-puzzle[scene]:not([task])").waitFor();
  const changed = await element.getAttribute("scene");
  await element.evaluate((one, task) => one.setAttribute("task", task), EASY);
  await page.locator("pathlight-puzzle[task]:not([scene])").waitFor();
  await element.evaluate((one, scene) => one.setAttribute("scene", scene), changed);
  await page.locator("pathlight-puzzle[scene]:not([task])").waitFor();
});

test("attributes that name no puzzle are told so in their place, and can be corrected", async () => {
  const elements = ['task="00002:003"', `task="${EASY}"`, 'scene="x"', 'lang="de" task="00004:003"'];
  const page = await openArticle(elements.map((one) => `<pathlight-puzzle ${one}></pathlight-puzzle>`).join(""));
  const said = (place) =>
    page.waitForFunction(
      (place) => document.querySelectorAll("pathlight-puzzle")[place].shadowRoot?.textContent,
      place,
    );
  assert.match(await (await said(0)).jsonValue(), /^There is no puzzle 00002:003\./);
  assert.match(await (await said(2)).jsonValue(), /^This link’s puzzle cannot be opened/);
  assert.match(await (await said(3)).jsonValue(), /^Ein Rätsel 00004:003 gibt es nicht\./);
  assert.equal(session.problems.splice(0).length, 3, "the author finds them in the console, too");
  await page
    .locator("pathlight-puzzle")
    .first()
    .evaluate((one) => one.setAttribute("task", "00007:008"));
  await scene(page.locator("pathlight-puzzle").first()).waitFor();
});

test("the wheel scrolls the article until the scene has the focus", async () => {
  const page = await openArticle(`<pathlight-puzzle task="${EASY}" ball="128,120,9"></pathlight-puzzle>`);
  await scene(page).hover();
  await page.mouse.wheel(0, 120);
  await page.waitForFunction(() => scrollY > 0);
  await described(page, /radius 9/);
});

test("on a phone in landscape the whole scene is seen, and a swipe scrolls until it has been tapped", async () => {
  const page = await openArticle(`<pathlight-puzzle task="${EASY}"></pathlight-puzzle>`, {
    viewport: { width: 640, height: 360 },
    hasTouch: true,
  });
  const { height } = await scene(page).boundingBox();
  assert.ok(height < 360, `${height}`);
  const touchAction = () => scene(page).evaluate((canvas) => getComputedStyle(canvas).touchAction);
  assert.equal(await touchAction(), "pan-y");
  await scene(page).tap();
  await described(page, /Your ball is at/);
  assert.equal(await touchAction(), "none");
});

test("several puzzles share one worker, which ends with the last; one that is moved keeps its ball", async () => {
  const puzzle = `<pathlight-puzzle task="${EASY}" ball="128,120,9"></pathlight-puzzle>`;
  const page = await openArticle(puzzle + puzzle);
  await page
    .getByText(/^Model A\./)
    .nth(1)
    .waitFor();
  assert.equal(page.workers().length, 1);
  await page.evaluate(() => document.body.append(document.getElementsByTagName("pathlight-puzzle")[0]));
  await described(page, /x 128, y 120, with radius 9/);
  const ended = page.workers()[0].waitForEvent("close");
  await page.evaluate(() => document.querySelectorAll("pathlight-puzzle").forEach((one) => one.remove()));
  await ended;
  await page.evaluate((html) => document.body.insertAdjacentHTML("afterbegin", html), puzzle);
  await button(page, "Drop it").waitFor();
});

test("it tells its page what the person does, and not what the page itself has asked for", async () => {
  const { missing } = await known();
  const page = await openArticle(`<pathlight-puzzle task="${EASY}" ball="${missing[0]}"></pathlight-puzzle>`);
  const heard = (type) => page.evaluate((type) => /** @type {any} */ (globalThis).heard[type], type);
  const until = (type, count) =>
    page.waitForFunction(
      ([type, count]) => /** @type {any} */ (globalThis).heard[type].length === count,
      [type, count],
    );
  await page.evaluate(() => {
    const heard = { attempt: [], statechange: [], modelchange: [] };
    Object.assign(globalThis, { heard });
    for (const type of Object.keys(heard))
      document.addEventListener(type, (event) => heard[type].push(/** @type {CustomEvent} */ (event).detail));
  });
  await modelIsThere(page);
  assert.deepEqual((await heard("modelchange")).at(-1), { name: "within-0", status: "ready" });
  // An attempt that is left before its end has ended too.
  await button(page, "Drop it").click();
  await button(page, "Pause").waitFor();
  assert.deepEqual(await heard("attempt"), []);
  await scene(page).focus();
  await page.keyboard.press("r");
  await until("attempt", 1);
  assert.deepEqual(await heard("attempt"), [{ task: EASY, number: 1, ball: missing[0], solved: false }]);
  assert.deepEqual(await heard("statechange"), []);
  await page.keyboard.press("ArrowUp");
  await until("statechange", 1);
  const [{ task, ball, layers }] = await heard("statechange");
  const [x, y, r] = missing[0];
  assert.deepEqual([task, ball, layers], [EASY, `${x},${y + 1},${r}`, null]);
  const element = page.locator("pathlight-puzzle");
  await element.evaluate((one) => Object.assign(one, { ball: "60,120,12" }));
  await described(page, /x 60, y 120, with radius 12/);
  await element.evaluate((one) => one.setAttribute("task", "00007:008"));
  await described(page, /Click or tap the scene/);
  await until("statechange", 1);
  await element.evaluate((one, ball) => Object.assign(one, { task: "00000:058", ball }), missing[1].join());
  await page.emulateMedia({ reducedMotion: "reduce" });
  await described(page, new RegExp(`x ${missing[1][0]}, y ${missing[1][1]}`));
  await button(page, "Drop it").click();
  await until("attempt", 2);
  assert.equal((await heard("attempt"))[1].number, 2);
  await until("statechange", 1);
});

test("with fill it is as high as its container, and its scene lies within", async () => {
  for (const width of [300, 1000]) {
    const page = await openArticle(
      `<div style="width: ${width}px; height: 420px"><pathlight-puzzle task="${EASY}" fill></pathlight-puzzle></div>`,
    );
    const box = await page.locator("pathlight-puzzle").boundingBox();
    const inside = await scene(page).boundingBox();
    assert.equal(box.height, 420);
    assert.ok(inside.height > 150 && inside.y + inside.height <= box.y + box.height, JSON.stringify({ box, inside }));
  }
});
