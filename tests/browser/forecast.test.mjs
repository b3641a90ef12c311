// The model's guess: the paths and the chance that it imagines for the ball that is being placed, by mouse, touch, keys
// and fields; beside the real paths after a run; and nowhere where it would reveal an answer.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import {
  EASY,
  ball,
  dragTo,
  known,
  modelLoaded,
  openPuzzle,
  pause,
  picture,
  says,
  spot,
  type,
} from "./page-actions.mjs";

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

let session;
before(async () => (session = await start({ sources: true })));
after(() => session.stop());

const words = (page) => page.locator("#forecast-words").textContent();

/** Waits until the forecast says so, and returns it. */
async function forecasts(page, pattern) {
  await page.locator("#forecast-words:visible").filter({ hasText: pattern }).waitFor();
  return words(page);
}

/** What the legend of the scene names. */
const legend = (page) => page.locator("#laid li:visible").allInnerTexts();
const GUESSED = ["Green’s path, a guess", "Red’s path, a guess"];

/** Opens a puzzle with the forecast on. */
const open = (fragment = "", options = {}) => openPuzzle(session, { fragment: `&forecast=on${fragment}`, ...options });

/** What the model imagines for a ball, through the page's own wasm. */
async function imagined(page, ball, task = EASY) {
  return page.evaluate(async ([ball, task]) => {
    const { Model } = await import("/pkg/pathlight.js");
    const { models } = await (await fetch("/assets/model.json")).json();
    const model = new Model(new Uint8Array(await (await fetch(`/assets/${models[0].file}`)).arrayBuffer()));
    const answer = model.imagineBall(task, ball);
    if (!answer) throw new Error("the weights have no dynamics net");
    return { probability: answer.probability, object: [...answer.object] };
  }, /** @type {const} */ ([ball, task]));
}

/** Waits until the forecast is that of the ball in the fields. */
async function followsTheBall(page) {
  const { probability } = await imagined(page, await ball(page));
  const percent = probability < 0.01 ? "under 1" : probability > 0.99 ? "over 99" : Math.round(100 * probability);
  await forecasts(page, new RegExp(`^The model’s guess: [a-z’ ]+ \\(chance ${percent}%\\)\\.$`));
}

test("newcomers see it, in plain words; the switch is by the run button, and is remembered", async () => {
  const page = await openPuzzle(session, { fragment: "&ball=128,230,8", newcomer: true });
  await followsTheBall(page);
  const withGuess = await picture(page);
  const [button, label] = [await page.locator("#run").boundingBox(), await page.locator("#forecast").boundingBox()];
  assert.ok(button && label && label.y - button.y - button.height < 60, "right below it");
  assert.ok(await page.getByRole("switch", { name: "The model’s guess" }).isChecked());
  assert.deepEqual(await legend(page), GUESSED);
  assert.ok(await page.locator("#laid-off").isHidden(), "they have a switch");
  await page.locator("#forecast-on").uncheck();
  await page.locator("#forecast-words").waitFor({ state: "hidden" });
  assert.notEqual(await picture(page), withGuess, "the paths lay over the scene");
  assert.deepEqual(await legend(page), []);
  await page.waitForFunction(() => /forecast=off/.test(location.hash));
  await page.goto(`${session.origin}/#task=00001:005&ball=128,230,8`);
  await page.reload();
  await modelLoaded(page);
  assert.ok(!(await page.locator("#forecast-on").isChecked()), "also on another day");
  await page.locator("#forecast-on").check();
  await page.waitForFunction(() => /forecast=on/.test(location.hash));
  await page.reload();
  await forecasts(page, /^The model’s guess: /);
});

test("whoever is challenged plays alone, until he asks", async () => {
  const page = await openPuzzle(session, { fragment: "&ball=128,230,8&challenge=3", newcomer: true });
  await modelLoaded(page);
  assert.ok(!(await page.locator("#forecast-on").isChecked()));
  await page.locator("#forecast-on").check();
  await followsTheBall(page);
});

test("a hopeless ball is told so in plain words", async () => {
  const page = await open("&ball=128,230,8");
  await followsTheBall(page);
  const { probability } = await imagined(page, [8, 248, 2]);
  assert.ok(probability < 0.05);
  await type(page, [8, 248, 2]);
  await forecasts(page, /^The model’s guess: almost surely won’t work \(chance (under 1|\d)%\)\.$/);
});

test("it follows the mouse", async () => {
  const page = await open();
  await modelLoaded(page);
  await dragTo(page, [
    [60, 240],
    [128, 236],
    [180, 230],
  ]);
  await followsTheBall(page);
  const first = await picture(page);
  await page.mouse.move(...(await spot(page, 90, 236)));
  await followsTheBall(page);
  assert.notEqual(await picture(page), first);
  await page.mouse.up();
});

test("the first guess moves nothing", async () => {
  const page = await open();
  const places = () => Promise.all(["#tabs", "#radius", "#watch"].map((part) => page.locator(part).boundingBox()));
  const before = await places();
  await page.mouse.click(...(await spot(page, 90, 236)));
  await followsTheBall(page);
  assert.deepEqual(await places(), before);
});

test("it follows a finger", async () => {
  const page = await open("", PHONE);
  await modelLoaded(page);
  await page.touchscreen.tap(...(await spot(page, 120, 236)));
  await followsTheBall(page);
  const line = await page.locator("#forecast-words").boundingBox();
  const legend = await page.locator("#laid").boundingBox();
  assert.ok(line && line.y + line.height <= 844, "the words are in sight without scrolling");
  assert.ok(legend && legend.y + legend.height <= 844 && legend.height < 30, "and the legend, in one row");
});

test("it follows keys and fields, and is announced once the ball rests", async () => {
  const page = await open("&ball=84,230,8");
  await followsTheBall(page);
  const first = await words(page);
  await page.locator("#announcement").filter({ hasText: first }).waitFor({ state: "attached" });
  await page.locator("#scene").focus();
  const heard = await page.evaluateHandle(() => {
    const region = document.querySelector("#puzzle")?.shadowRoot?.getElementById("announcement");
    /** @type {string[]} */
    const heard = [];
    new MutationObserver(() => heard.push(region?.textContent ?? "")).observe(/** @type {HTMLElement} */ (region), {
      childList: true,
      characterData: true,
      subtree: true,
    });
    return heard;
  });
  // At once: on a slow machine the ball would rest between two key presses.
  await page.locator("#scene").evaluate((scene) => {
    for (let time = 0; time < 8; time += 1) scene.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft" }));
  });
  await followsTheBall(page);
  const rested = await words(page);
  assert.notEqual(rested, first, "else it would have nothing to announce");
  await page.waitForFunction(([heard, rested]) => heard.includes(rested), /** @type {const} */ ([heard, rested]));
  const told = (await heard.jsonValue()).filter((sentence) => /The model’s guess: /.test(sentence));
  assert.ok(told.length <= 2, `not for each key: ${told}`);
  await type(page, [70, 240, 6]);
  await followsTheBall(page);
});

test("of many moves at once only the first and the last are asked for", async () => {
  const page = await open("&ball=128,230,8");
  await followsTheBall(page);
  const asked = await page.evaluate(async () => {
    const { postMessage } = Worker.prototype;
    /** @type {number[][]} */
    const asked = [];
    Worker.prototype.postMessage = function (message) {
      if (message.call === "imagineBall") asked.push(message.args[1]);
      return Reflect.apply(postMessage, this, [message]);
    };
    const scene = document.querySelector("#puzzle")?.shadowRoot?.getElementById("scene");
    for (let time = 0; time < 50; time += 1) scene?.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight" }));
    while (asked.length < 2) await new Promise((resolve) => setTimeout(resolve, 10));
    await new Promise((resolve) => setTimeout(resolve, 200));
    Worker.prototype.postMessage = postMessage;
    return asked;
  });
  assert.deepEqual(
    asked.map(([x]) => x),
    [129, 178],
  );
  await followsTheBall(page);
});

test("after a run it stays beside the real paths until the ball changes", async () => {
  const page = await open("", { reducedMotion: true });
  const { missing } = await known();
  await type(page, missing);
  await followsTheBall(page);
  await page.locator("#run").click();
  await says(page, /^Not solved/);
  const said = await forecasts(
    page,
    /^The model’s guess was: .+ \(.+%\)\. Its path for green was \d+ px off, on average\.$/,
  );
  const { object } = await imagined(page, missing);
  const real = await page.evaluate(async ([[x, y, r], task]) => {
    const { Game } = await import("/pkg/pathlight.js");
    const game = new Game(task);
    game.preview(x, y, r);
    return Array.from(game.sampledPaths()?.object ?? []);
  }, /** @type {const} */ ([missing, EASY]));
  const errors = Array.from({ length: 16 }, (_, index) =>
    Math.hypot(object[2 * index] - real[2 * index], object[2 * index + 1] - real[2 * index + 1]),
  );
  const mean = errors.reduce((sum, error) => sum + error, 0) / 16;
  assert.equal(Number(said.match(/(\d+) px/)?.[1]), Math.max(1, Math.round(mean)));
  const both = await picture(page);
  await page.locator("#forecast-on").uncheck();
  assert.notEqual(await picture(page), both, "it lay over the run");
  await page.locator("#forecast-on").check();
  await page.locator("#watch").click();
  await page.locator("#forecast-words").waitFor({ state: "hidden" });
  await page.locator("#play-attempts [data-act=replay]").first().click();
  await forecasts(page, /^The model’s guess was/);
  await page.locator("#scene").press("ArrowUp");
  await forecasts(page, /^The model’s guess:/);
});

test("a ball that may not be placed is not imagined", async () => {
  const page = await open("&ball=128,230,8");
  await followsTheBall(page);
  const { invalid } = await known();
  await type(page, invalid);
  await page.locator("#forecast-words").waitFor({ state: "hidden" });
  assert.deepEqual(await legend(page), GUESSED, "the legend stays, so that nothing jumps while the ball is dragged");
  await page.locator("#watch").click();
  await page.locator("#laid li").first().waitFor({ state: "hidden" });
  assert.deepEqual(await legend(page), []);
});

test("it reveals nothing in Predict", async () => {
  const page = await open("&ball=128,230,8&panel=predict");
  await modelLoaded(page);
  await pause(page, 300);
  const there = await picture(page);
  await page.goto(`${session.origin}/#task=${EASY}&ball=128,230,8&panel=predict`);
  await page.waitForFunction(() => !/forecast/.test(location.hash));
  assert.equal(await picture(page), there);
});

for (const hide of ["forecast", "imagine", "puzzles,imagine,compare,predict,map"]) {
  test(`a link with hide=${hide} hides it, also if the link switches it on`, async () => {
    const page = await openPuzzle(session, { fragment: `&ball=128,230,8&hide=${hide}` });
    await pause(page);
    const bare = await picture(page);
    assert.ok(await page.locator("#forecast-on").isHidden());
    await page.goto(`${session.origin}/#task=${EASY}&ball=128,230,8&hide=${hide}&forecast=on`);
    await pause(page);
    assert.ok(await page.locator("#forecast-on").isHidden());
    assert.equal(await picture(page), bare);
  });
}

test("another puzzle is imagined anew", async () => {
  const page = await open("&ball=128,230,8");
  await followsTheBall(page);
  await page.locator("#next").click();
  await page.locator("#forecast-words").waitFor({ state: "hidden" });
  assert.deepEqual(await legend(page), []);
  await type(page, [128, 230, 8]);
  await forecasts(page, /^The model’s guess: /);
});
