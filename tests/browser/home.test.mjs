// The home page shows imagination at once: without a click, before any weights, a recorded scene moves; it can be
// paused, stands still under reduced motion, and its links lead where they say.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { SCENE_TASK } from "../../www/home/home-tasks.js";
import { axeFindsNothing } from "./axe.mjs";
import { painted, start } from "./harness.mjs";
import { says } from "./page-actions.mjs";

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

let session;
before(async () => (session = await start()));
after(() => session.stop());

/** The picture on the canvas of the moving scene. */
const picture = (page) => page.locator("#hero-canvas").evaluate((canvas) => canvas.toDataURL());

/** Waits until the scene is at a phase. */
const phase = (page, name) => page.locator(`#hero-scene[data-phase=${name}]`).waitFor();

/** Waits until the canvas shows another picture. */
async function moves(page) {
  const before = await picture(page);
  await page.waitForFunction(
    (before) => /** @type {HTMLCanvasElement} */ (document.querySelector("#hero-canvas")).toDataURL() !== before,
    before,
  );
}

test("without a click and without the wasm, futures fan out, one is picked, and it is told how good the guess was", async () => {
  const page = await session.open("");
  let open = () => {};
  const gate = new Promise((resolve) => (open = () => resolve(null)));
  await page.route("**/*.wasm", (route) => gate.then(() => route.continue()));
  const weights = [];
  page.on("request", (request) => /safetensors/.test(request.url()) && weights.push(request.url()));
  await page.goto(`${session.origin}/`);
  await phase(page, "imagine");
  await moves(page);
  assert.ok(await page.locator("#catalogue").isHidden(), "nothing else is there yet");
  // Waits, because a phase may end before it has been looked at; the story is told three times.
  const caption = (words) => page.locator("#hero-caption").filter({ hasText: words }).waitFor();
  await caption(/^It imagines 40 futures/);
  await caption(/picks one: \d+% sure/);
  await phase(page, "real");
  await moves(page);
  open();
  await page.locator("#templates canvas.drawn").first().waitFor();
  await caption(/^Its guess was off by (?:under )?\d+% of the width\.$/);
  await phase(page, "imagine");
  assert.deepEqual(weights, []);
});

test("it pauses and goes on", async () => {
  const page = await session.open("/");
  await moves(page);
  await page.locator("#hero-pause").click();
  const still = await picture(page);
  await painted(page);
  assert.equal(await picture(page), still);
  await page.locator("#hero-pause", { hasText: "Play" }).click();
  await moves(page);
});

test("under reduced motion the finished scene stands still, until it is played", async () => {
  const page = await session.open("/", { reducedMotion: "reduce" });
  await phase(page, "result");
  await page.locator("#templates canvas.drawn").first().waitFor();
  const still = await picture(page);
  await painted(page);
  assert.equal(await picture(page), still);
  await page.locator("#hero-pause", { hasText: "Play" }).click();
  await phase(page, "imagine");
});

test("a model in the address that is no model does no harm", async () => {
  const page = await session.open("/#model=constructor");
  await page.locator("#picks canvas.drawn").first().waitFor();
});

test("on a phone the scene comes first", async () => {
  const page = await session.open("/", PHONE);
  await phase(page, "imagine");
  const top = async (selector) => (await page.locator(selector).boundingBox()).y;
  assert.ok((await top("#hero-canvas")) < (await top("#gallery-title")));
  const play = await page.locator("#hero-play").boundingBox();
  assert.ok(play.y + play.height <= PHONE.viewport.height, "the button to play is in the first screen");
});

test("its links lead to the puzzle that is shown: to play it, and to drag it", async () => {
  const page = await session.open("/", { reducedMotion: "reduce" });
  await page.locator("#hero-play").click();
  await says(page, /place the red ball/);
  assert.match(page.url(), new RegExp(`#task=${SCENE_TASK}$`));
  await page.goBack();
  await page.locator("#hero-make").click();
  await page.locator("#make:visible").waitFor();
  assert.match(page.url(), new RegExp(`#task=${SCENE_TASK}&panel=make$`));
  await page.goBack();
  await page.locator("[data-pick=make] a").click();
  await page.locator("#make:visible").waitFor();
});

test("a kind imagines the path of its green object, under the pointer and with the focus", async () => {
  const page = await session.open("/");
  const card = page.locator("#templates a").nth(2);
  await card.locator(".imagined").waitFor({ state: "attached" });
  const opacity = () => card.locator(".imagined").evaluate((path) => getComputedStyle(path).opacity);
  assert.equal(await opacity(), "0");
  await card.hover();
  assert.equal(await opacity(), "0.8");
  await page.mouse.move(0, 0);
  assert.equal(await opacity(), "0");
  await page.locator("#templates a").nth(1).focus();
  await page.keyboard.press("Tab");
  assert.equal(await opacity(), "0.8");
});

test("a recording that does not come takes nothing else away", async () => {
  const page = await session.open("");
  await page.route("**/home.json", (route) => route.fulfill({ status: 503 }));
  await page.goto(`${session.origin}/`);
  await page.locator("#templates canvas.drawn").first().waitFor();
  await page.locator("#hero-scene").waitFor({ state: "hidden" });
  await page.locator("#hero-play").click();
  await says(page, /place the red ball/);
  const problems = session.takeProblems();
  assert.ok(
    problems.every((problem) => /503/.test(problem)),
    problems.join(),
  );
});

test("a link that hides what is imagined shows no futures, and speaks of no AI", async () => {
  const page = await session.open("/#hide=imagine,compare");
  await page.locator("#templates canvas.drawn").first().waitFor();
  assert.ok(await page.locator("#hero-scene").isHidden());
  assert.equal(await page.locator("h1:visible").textContent(), "Pick a puzzle");
  assert.doesNotMatch(await page.locator("#hero").innerText(), /\bAI\b|imagine/);
  await page.locator("#templates a").first().hover();
  assert.ok(await page.locator(".imagined").first().isHidden());
});

for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
  for (const options of [{}, PHONE]) {
    test(`axe finds nothing, ${colorScheme}, ${options === PHONE ? "on a phone" : "on a desktop"}`, async () => {
      const page = await session.open("/", { colorScheme, ...options });
      await page.locator("#picks canvas.drawn").first().waitFor();
      await page.locator("#hero-scene.ready").waitFor();
      await axeFindsNothing(page, "home");
    });
  }
}

for (const { what, path, locale, seen } of [
  { what: "the home page", path: "/", locale: "en-US", seen: true },
  { what: "a link to a puzzle", path: "/#task=00000:000", locale: "en-US", seen: false },
  { what: "a browser of another language", path: "/", locale: "de-DE", seen: false },
])
  test(`before the modules are there, ${what} ${seen ? "shows its top" : "shows nothing of another page"}`, async () => {
    const page = await session.open("", { locale });
    let open = () => {};
    const gate = new Promise((resolve) => (open = () => resolve(null)));
    await page.route("**/page/main.js", (route) => gate.then(() => route.continue()));
    await page.goto(session.origin + path, { waitUntil: "commit" });
    // The style sheets are there.
    await page.waitForFunction(() => {
      const header = document.querySelector("header");
      return header && getComputedStyle(header).display === "flex";
    });
    assert.equal(await page.locator("#gallery-title").isVisible(), seen);
    open();
    await page
      .locator(path === "/" ? "#templates a" : "#scene")
      .first()
      .waitFor();
    assert.equal(await page.locator("#gallery-title").isVisible(), path === "/");
  });
