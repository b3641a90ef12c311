// <pathlight-puzzle> in another page: two puzzles are played independently of each other, follow their attributes and
// the width of their container, and free their worker and memory when they are removed.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { LESSON, embed, imagined, single, wait, workers } from "./embedding.mjs";
import { start } from "./harness.mjs";
import { focused, known, openPanel, pause } from "./page-actions.mjs";

let session, models;
before(async () => {
  session = await start({ sources: true });
  models = (await (await fetch(`${session.origin}/assets/model.json`)).json()).models.map(({ name }) => name);
});
after(() => session.stop());

/** The place on the screen of a point of a puzzle's scene, px. */
async function spot(puzzle, x, y) {
  const scene = puzzle.locator("#scene");
  await scene.scrollIntoViewIfNeeded();
  const box = await scene.boundingBox();
  return { x: box.x + (x / 256) * box.width, y: box.y + box.height - (y / 256) * box.height };
}

const ballOf = async (puzzle) =>
  Promise.all(["x", "y", "r"].map(async (name) => Number(await puzzle.locator(`#ball-${name}`).inputValue())));
const status = (puzzle, pattern) => puzzle.locator("#status").filter({ hasText: pattern }).waitFor();

test("the page ends where the last puzzle ends", async () => {
  const page = await embed(session, LESSON, { viewport: { width: 1000, height: 700 } });
  const two = page.locator("#two");
  await imagined(two);
  const below = await two.evaluate(
    (puzzle) => document.documentElement.scrollHeight - scrollY - puzzle.getBoundingClientRect().bottom,
  );
  assert.ok(below < 30, `${below} px below the last puzzle`);
});

test("two puzzles in one page are played with the mouse, independently of each other", async () => {
  const page = await embed(session);
  const [one, two] = [page.locator("#one"), page.locator("#two")];
  await imagined(two);
  const { solving } = await known();
  await page.evaluate(() => {
    globalThis.heard = [];
    document.addEventListener("attempt", (/** @type {any} */ { target, detail }) =>
      globalThis.heard.push([target.id, detail]),
    );
  });
  const { x, y } = await spot(one, solving[0], solving[1]);
  await page.mouse.click(x, y);
  await one.locator("#more-button").click();
  await one.locator("#ball-r").fill(String(solving[2]));
  await one.locator("#ball-r").press("Tab");
  await page.keyboard.press("Escape");
  assert.deepEqual(await ballOf(one), solving);
  assert.deepEqual(await ballOf(two), [0, 0, 0]);
  await one.locator("#run").click();
  await status(one, /^Solved! Your attempt 1/);
  await status(two, /^Click or tap the scene/);
  assert.deepEqual(await page.evaluate(() => globalThis.heard), [
    ["one", { task: "00000:000", number: 1, ball: solving, solved: true }],
  ]);
  assert.equal(
    await page.evaluate(() => Object.keys(localStorage).length),
    0,
    "nothing is kept in the browser of a page that did not ask for it",
  );
});

test("keys act only in the puzzle that has the focus", async () => {
  const page = await embed(session);
  const [one, two] = [page.locator("#one"), page.locator("#two")];
  await imagined(two);
  await two.evaluate((element) => element.focus());
  assert.equal(await (await focused(page)).getAttribute("id"), "scene");
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("3");
  await two.locator("#make").waitFor();
  assert.ok(await one.locator("#play").isVisible(), "the other stays where it was");
  await page.keyboard.press("?");
  await two.locator("#keys-dialog[open]").waitFor();
  assert.equal(await one.locator("#keys-dialog[open]").count(), 0);
  assert.ok(await two.getByText("previous, next puzzle").isHidden(), "there is no way to other puzzles");
  await page.keyboard.press("Escape");
  await one.locator("#scene").press("Shift+ArrowLeft");
  await one.locator("#scene").press("Space");
  await status(one, /attempt 1|Not here/);
  assert.equal(await two.locator("#time").isDisabled(), true, "the other does not run");
  await (await focused(page)).evaluate((element) => element.blur());
  const before = await ballOf(one);
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("2");
  assert.deepEqual(await ballOf(one), before);
  assert.ok(await one.locator("#play").isVisible());
});

test("a finger places and drags", async () => {
  const page = await embed(session, LESSON, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  const two = page.locator("#two");
  await imagined(two);
  await two.locator("#tab-play").tap();
  const { x, y } = await spot(two, 128, 200);
  await page.touchscreen.tap(x, y);
  assert.deepEqual((await ballOf(two)).slice(0, 2), [128, 200]);
  assert.deepEqual(await ballOf(page.locator("#one")), [0, 0, 0]);
});

test("the puzzle follows its attributes, and the attributes follow the person", async () => {
  const page = await embed(session);
  const one = page.locator("#one");
  await one.locator("#scene").waitFor();
  const goal = await one.locator("#goal").textContent();
  await one.evaluate((element) => {
    element.setAttribute("task", "00012:002");
    element.setAttribute("panel", "map");
    element.setAttribute("ball", "100,200,20");
  });
  await one.locator("#map").waitFor();
  assert.notEqual(await one.locator("#goal").textContent(), goal);
  assert.deepEqual(await ballOf(one), [100, 200, 20]);
  await page.evaluate(() => {
    globalThis.heard = [];
    document.addEventListener("statechange", (/** @type {any} */ { detail }) => globalThis.heard.push(detail.panel));
  });
  await one.locator("#tab-imagine").click();
  await one.locator("[data-map=action] input").uncheck();
  assert.equal(await one.getAttribute("panel"), "imagine");
  assert.equal(await one.getAttribute("layers"), "target");
  assert.deepEqual(await page.evaluate(() => globalThis.heard), ["imagine", "imagine"]);
  await one.locator("#scene").press("ArrowLeft");
  assert.equal(await one.getAttribute("ball"), "99,200,20");
  assert.equal(await one.evaluate((element) => element.ball), "99,200,20");
  await one.evaluate((element) => {
    element.theme = "dark";
    element.layers = null;
  });
  await wait(
    async () => (await one.locator(".puzzle").evaluate((puzzle) => getComputedStyle(puzzle).colorScheme)) === "dark",
    "dark",
  );
  assert.ok(await one.locator("[data-map=action] input").isChecked(), "the two of the panel are back");
});

test("the attribute stage, the old name of step, and the old name of the presentation are read", async () => {
  const page = await embed(session, single('task="00000:000" stage="target" view="stage"'));
  const puzzle = page.locator("pathlight-puzzle");
  await puzzle.locator("#presentation:visible").waitFor();
  const step = () => puzzle.evaluate((/** @type {any} */ element) => [element.step, element.state.step]);
  assert.deepEqual(await step(), ["target", "target"]);
  await puzzle.evaluate((element) => element.setAttribute("stage", "base"));
  assert.deepEqual(await step(), ["base", "base"]);
  await puzzle.evaluate((/** @type {any} */ element) => (element.stage = null));
  assert.deepEqual(await step(), [null, null]);
});

test("the old name of the map Success is read", async () => {
  const page = await embed(session, single('task="00000:000" panel="imagine" layers="judge" step="judge"'));
  const puzzle = page.locator("pathlight-puzzle");
  await puzzle.locator("[data-map=success]").waitFor();
  const shown = await puzzle.evaluate((/** @type {any} */ element) => [element.state.layers, element.state.step]);
  assert.deepEqual(shown, [["success"], "placement"]);
});

test("a ball does not go on to another puzzle, unless it is set with it", async () => {
  const page = await embed(session, single('task="00000:000" ball="100,200,20"'));
  const puzzle = page.locator("pathlight-puzzle");
  await puzzle.locator("#scene").waitFor();
  assert.deepEqual(await ballOf(puzzle), [100, 200, 20]);
  await puzzle.evaluate((element) => (element.task = "00012:002"));
  await puzzle.getByRole("group", { name: /00012:002/ }).waitFor();
  assert.deepEqual([await puzzle.getAttribute("ball"), await ballOf(puzzle)], [null, [0, 0, 0]]);
  await puzzle.locator("#scene").press("ArrowLeft");
  const placed = await puzzle.getAttribute("ball");
  await puzzle.evaluate((element, ball) => Object.assign(element, { ball, task: "00000:001" }), placed);
  await puzzle.getByRole("group", { name: /00000:001/ }).waitFor();
  assert.equal(await puzzle.getAttribute("ball"), placed);
});

test("an attribute without a value is off if it is “false”", async () => {
  const page = await embed(session, single('task="00000:000" fill="false" remember="false"', "height: 400px"));
  const puzzle = page.locator("pathlight-puzzle");
  await puzzle.locator("#scene").waitFor();
  const height = () => puzzle.evaluate((element) => element.clientHeight);
  assert.notEqual(await height(), 400);
  const { solving } = await known();
  await puzzle.evaluate((element, ball) => element.setAttribute("ball", ball), String(solving));
  await puzzle.locator("#run").click();
  await status(puzzle, /^Solved!/);
  assert.equal(await page.evaluate(() => localStorage.length), 0);
  await puzzle.evaluate((element) => element.setAttribute("fill", "true"));
  assert.equal(await height(), 400);
  await puzzle.evaluate((element) => element.setAttribute("fill", "false"));
  assert.notEqual(await height(), 400);
});

test("properties that were set before the element was defined take effect", async () => {
  const early = `<!doctype html><html lang="en"><title>Early</title><main><h1>Early</h1></main>
    <script>
      const puzzle = document.createElement('pathlight-puzzle');
      Object.assign(puzzle, { task: '00007:008', panel: 'map', hrefOf: (task) => '#' + task });
      document.querySelector('main').append(puzzle);
    </script>
    <script type="module" src="/element/pathlight-puzzle.js"></script></html>`;
  const page = await embed(session, early);
  const puzzle = page.locator("pathlight-puzzle");
  await puzzle.locator("#map").waitFor();
  assert.equal(await puzzle.getAttribute("task"), "00007:008");
  assert.equal(await puzzle.evaluate((element) => element.hrefOf("00000:000")), "#00000:000");
});

test("a puzzle that is removed frees its worker and its memory, and can be played again when it is put back", async () => {
  const page = await embed(session);
  await imagined(page.locator("#two"));
  await page.evaluate(async () => {
    const { Game } = await import("/pkg/pathlight.js");
    const free = Game.prototype.free;
    globalThis.freed = 0;
    Game.prototype.free = function () {
      globalThis.freed += 1;
      free.call(this);
    };
    globalThis.puzzles = [...document.querySelectorAll("pathlight-puzzle")];
  });
  await page.evaluate(() => globalThis.puzzles.forEach((puzzle) => puzzle.remove()));
  await wait(() => page.workers().length === 0, "the worker ends");
  assert.equal(await page.evaluate(() => globalThis.freed), 2);
  await page.evaluate(() => document.querySelector("main")?.append(...globalThis.puzzles));
  await imagined(page.locator("#two"));
  const { solving } = await known();
  await page.locator("#one").evaluate((element, ball) => element.setAttribute("ball", ball), String(solving));
  await page.locator("#one #run").click();
  await status(page.locator("#one"), /^Solved!/);
  // A puzzle that is moved within its page keeps its attempts.
  await page.evaluate(() => document.querySelector("main")?.prepend(globalThis.puzzles[0]));
  await pause(page, 100);
  assert.equal(await page.locator("#one #play-attempts li").count(), 1);
});

test("puzzles of one model share its worker, those of another have their own", async () => {
  const page = await embed(session);
  const [one, two] = [page.locator("#one"), page.locator("#two")];
  await imagined(two);
  workers(page, 1);
  await page.evaluate(() => {
    globalThis.heard = [];
    document.addEventListener("modelchange", (/** @type {any} */ { target, detail }) =>
      globalThis.heard.push([target.id, detail.status, detail.name]),
    );
  });
  await two.evaluate((element, name) => element.setAttribute("model", name), models[1]);
  await two
    .locator("#card")
    .filter({ hasText: `model “${models[1]}”` })
    .waitFor({ state: "attached" });
  await one
    .locator("#card")
    .filter({ hasText: `model “${models[0]}”` })
    .waitFor({ state: "attached" });
  await imagined(two);
  workers(page, 2);
  assert.deepEqual(await page.evaluate(() => globalThis.heard), [
    ["two", "loading", null],
    ["two", "ready", models[1]],
  ]);
  await two.evaluate((element) => element.removeAttribute("model"));
  await two
    .locator("#card")
    .filter({ hasText: `model “${models[0]}”` })
    .waitFor({ state: "attached" });
  await imagined(two);
  await wait(() => page.workers().length === 1, "the worker of the second model ends");
  // The first model by its name is the same model.
  await two.evaluate((element, name) => element.setAttribute("model", name), models[0]);
  await page.evaluate((name) => {
    const third = Object.assign(document.createElement("pathlight-puzzle"), {
      id: "three",
      task: "00000:001",
      panel: "imagine",
      model: name,
    });
    document.querySelector("main")?.append(third);
  }, models[0]);
  await imagined(two);
  await imagined(page.locator("#three"));
  workers(page, 1);
  assert.equal(await two.getAttribute("model"), models[0]);
});

for (const { attributes, words, playable = false } of [
  { attributes: 'task="00007:999"', words: /There is no puzzle 00007:999/ },
  { attributes: 'task="funnel"', words: /task="funnel", which Pathlight does not understand/ },
  {
    attributes: 'task="00007:008" panel="soup" layers="soup"',
    words: /panel="soup" and layers="soup"/,
    playable: true,
  },
]) {
  test(`a bad attribute (${attributes}) is a sentence in the element`, async () => {
    const page = await embed(session, single(attributes));
    await page.locator("#problem").filter({ hasText: words }).waitFor();
    assert.equal(await page.locator("#scene").isVisible(), playable);
    if (playable) {
      await openPanel(page, "map");
      await page.locator("#problem").waitFor({ state: "hidden" });
    }
    await page.locator("pathlight-puzzle").evaluate((element) => {
      for (const name of ["panel", "layers"]) element.removeAttribute(name);
      element.setAttribute("task", "00000:000");
    });
    await page.locator("#scene").waitFor();
    await page.locator("#problem").waitFor({ state: "hidden" });
  });
}

test("a puzzle that hides all panels of the model loads no weights", async () => {
  const page = await embed(session, single('task="00000:000" hide="imagine, compare,predict, map ,story"'));
  await page.locator("#run").waitFor();
  for (const hidden of ["#tab-imagine", "#race", "#open-compare", "#story"])
    assert.ok(await page.locator(hidden).isHidden(), hidden);
  workers(page, 0);
});

for (const width of [320, 400, 700, 1200]) {
  test(`${width} px wide, everything fits its container, whatever the window is`, async () => {
    const page = await embed(session, single('task="00007:008"', `width: ${width}px`));
    await page.locator("#scene").waitFor();
    for (const panel of ["play", "imagine", "compare", "predict", "map", "make"]) {
      await openPanel(page, panel);
      const sizes = await page
        .locator(".puzzle")
        .evaluate((puzzle) => [puzzle.scrollWidth, puzzle.clientWidth, puzzle.parentNode.host.clientWidth]);
      assert.ok(sizes[0] <= sizes[1] && sizes[1] <= width && sizes[2] === width, `${panel}: ${sizes}`);
      const cut = await page
        .locator(".tabs button")
        .evaluateAll((tabs) => tabs.filter((tab) => tab.scrollWidth > tab.clientWidth).map((tab) => tab.id));
      assert.deepEqual(cut, [], "no name of a panel runs into the next");
      for (const button of await page.locator("button:visible, select:visible, #time").all()) {
        const box = await button.boundingBox();
        assert.ok(
          box.width >= 24 && box.height >= 24,
          `${await button.getAttribute("id")} is ${box.width} x ${box.height}`,
        );
      }
    }
    const [scene, tabs] = await Promise.all(["#scene", ".tabs"].map((one) => page.locator(one).boundingBox()));
    if (width > 760) assert.ok(tabs.x > scene.x + scene.width, "the panel is right of the scene");
    else assert.ok(tabs.y > scene.y + scene.height, "the panel is under the scene");
  });
}
