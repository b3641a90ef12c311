// Editing a scene: with the mouse, a finger, keys and fields. The maps and the path of the scene alone follow while a
// body is dragged; what may be played becomes the puzzle of all panels, and what may not says why.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { axeFindsNothing } from "./axe.mjs";
import { painted, start } from "./harness.mjs";
import {
  EASY,
  ball,
  click,
  dragTo,
  known,
  openPanel,
  openPuzzle,
  openShare,
  pause,
  picture,
  says,
  spot,
  waitForValue,
} from "./page-actions.mjs";

let session;
before(async () => (session = await start({ sources: true })));
after(() => session.stop());

/** Opens a puzzle on the panel Make, with its maps. */
async function openEditor(options = {}) {
  const page = await openPuzzle(session, { fragment: "&panel=make", ...options });
  await page.locator('#make-maps canvas:not([aria-label*="not imagined"])').first().waitFor();
  return page;
}

/** The scene that the address holds. */
async function linked(page) {
  await page.waitForFunction(() => /scene=/.test(location.hash));
  return page.evaluate(async () => {
    const { sceneOfText } = await import("/editor/scene-link.js");
    return sceneOfText(new URLSearchParams(location.hash.slice(1)).get("scene") ?? "");
  });
}

/** The scene of a task as it can be edited. */
function original(page, task = EASY) {
  return page.evaluate(async (task) => (await import("/shell/page-api.js")).pathlight.customScene(task), task);
}

/** Waits until the address holds a scene that passes. */
async function waitForScene(page, passes) {
  const end = Date.now() + 90_000;
  for (;;) {
    const scene = await linked(page);
    if (passes(scene)) return scene;
    assert.ok(Date.now() < end, JSON.stringify(scene));
    await painted(page);
  }
}

const value = (page, id) => page.locator(`#make-${id}`).inputValue().then(Number);

test("a body that is dragged with the mouse is where it was dropped, and in the link", async () => {
  const page = await openEditor();
  const { bodies, body1 } = await original(page);
  const { x, y } = bodies[body1];
  await dragTo(page, [
    [x, y],
    [x + 20, y + 30],
  ]);
  await page.mouse.up();
  await waitForValue(page, "#make-x", (now) => Math.abs(Number(now) - x - 20) <= 1);
  await waitForValue(page, "#make-y", (now) => Math.abs(Number(now) - y - 30) <= 1);
  const scene = await waitForScene(page, ({ bodies: now }) => now[body1].y !== y);
  assert.ok(Math.abs(scene.bodies[body1].x - x - 20) <= 1);
  assert.ok(Math.abs(scene.bodies[body1].y - y - 30) <= 1);
  assert.match(await page.locator("#puzzle-name").textContent(), /, edited$/);
  assert.equal(new URL(page.url()).hash.includes("task="), false);
});

test("the maps and the path alone follow while the pointer is down", async () => {
  const page = await openEditor();
  const { bodies, body1 } = await original(page);
  const { x, y } = bodies[body1];
  const map = "#make-maps canvas >> nth=0";
  const [mapBefore, wordsBefore] = [await picture(page, map), await page.locator("#make-alone").textContent()];
  await page.mouse.move(...(await spot(page, x, y)));
  await page.mouse.down();
  for (let step = 1; step <= 40; step += 1) await page.mouse.move(...(await spot(page, x + step, y + step / 2)));
  await page.waitForFunction((before) => {
    const canvas = document.querySelector("pathlight-puzzle")?.shadowRoot?.querySelector("#make-maps canvas");
    return canvas instanceof HTMLCanvasElement && canvas.toDataURL() !== before;
  }, mapBefore);
  await page
    .locator("#make-alone")
    .filter({ hasNotText: wordsBefore ?? "" })
    .waitFor();
  await page.mouse.up();
});

test("a finger drags the knobs: a bar is turned and resized", async () => {
  const page = await openEditor({ hasTouch: true, isMobile: true, viewport: { width: 390, height: 844 } });
  await page.locator("[data-adds=bar]").click();
  await waitForValue(page, "#make-size", (size) => size === "64");
  const touch = await page.context().newCDPSession(page);
  const drag = async (from, to) => {
    const at = async ([x, y]) => (([px, py]) => [{ x: px, y: py }])(await spot(page, x, y));
    await page.evaluate(() => {
      const { dataset } = document.body;
      dataset.ended = "";
      for (const kind of ["pointerup", "pointercancel"]) {
        addEventListener(kind, () => (dataset.ended ||= kind), { capture: true, once: true });
      }
    });
    await touch.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: await at(from) });
    // Several moves, as a finger makes: the browser may keep the first for itself.
    for (const share of [0.4, 0.7, 1]) {
      const between = (axis) => from[axis] + share * (to[axis] - from[axis]);
      const touchPoints = await at([between(0), between(1)]);
      await touch.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints });
    }
    await touch.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
    await page.waitForFunction(() => document.body.dataset.ended);
    // The browser takes a touch for its own that a busy page does not answer in time. A person would try again.
    if (await page.evaluate(() => document.body.dataset.ended === "pointercancel")) await drag(from, to);
  };
  const [x, y] = [await value(page, "x"), await value(page, "y")];
  // What was changed becomes the puzzle soon after, which ends a drag that has just begun.
  const barIsLinked = (length) => waitForScene(page, ({ bodies }) => Math.abs(bodies.at(-1).length - length) <= 2);
  await barIsLinked(64);
  await drag([x + 32, y], [x + 50, y]);
  await waitForValue(page, "#make-size", (size) => Math.abs(Number(size) - 100) <= 2);
  await barIsLinked(100);
  await drag([x, y + 16.5], [x + 40, y]);
  await waitForValue(page, "#make-angle", (angle) => Math.abs(Number(angle) - 270) <= 3);
});

test("what is added or duplicated lies where there is room", async () => {
  const page = await openEditor();
  const { bodies } = await original(page);
  for (const shape of ["jar", "jar", "standing_sticks", "ball"]) await page.locator(`[data-adds=${shape}]`).click();
  await page.locator("#scene").press("d");
  await waitForScene(page, (scene) => scene.bodies.length === bodies.length + 5);
  assert.equal(await page.locator("#make-problems").isVisible(), false);
});

test("with nothing selected, the keys that move and resize a body leave the ball alone", async () => {
  const page = await openEditor();
  for (const key of ["ArrowUp", "Shift+ArrowRight", "+", "-"]) await page.locator("#scene").press(key);
  await page.locator("#tab-play").click();
  assert.deepEqual(await ball(page), [0, 0, 0]);
});

test("all of it with keys: select, move, turn, resize, duplicate, delete, undo, redo", async () => {
  const page = await openEditor();
  const before = await original(page);
  const scene = page.locator("#scene");
  await scene.press("n");
  const pressed = page.locator("#make-bodies [aria-pressed=true]");
  await pressed.waitFor();
  await page.locator("[data-adds=bar]").click();
  await scene.press("ArrowUp");
  await scene.press("Shift+ArrowRight");
  await scene.press(",");
  await scene.press("+");
  // The fields follow at the next frame.
  await waitForValue(page, "#make-angle", (angle) => angle === "1");
  await waitForValue(page, "#make-size", (size) => size === "65");
  await scene.press("d");
  await waitForScene(page, ({ bodies }) => bodies.length === before.bodies.length + 2);
  await scene.press("Delete");
  await waitForScene(page, ({ bodies }) => bodies.length === before.bodies.length + 1);
  await scene.press("Control+z");
  await waitForScene(page, ({ bodies }) => bodies.length === before.bodies.length + 2);
  // Keys that follow each other quickly are one step; so how many there are depends on the machine.
  for (let step = 0; step < 12 && !(await page.locator("#make-undo").isDisabled()); step += 1)
    await scene.press("Control+z");
  await page.locator("#make-undo:disabled").waitFor();
  await waitForScene(page, ({ bodies }) => JSON.stringify(bodies) === JSON.stringify(before.bodies));
  await scene.press("Control+y");
  await waitForScene(page, ({ bodies }) => bodies.length === before.bodies.length + 1);
});

test("a run that is shown stays until something is edited", async () => {
  const page = await openEditor();
  const scene = page.locator("#scene");
  await page.locator("#make-watch").click();
  await says(page, /^The scene without a ball/);
  for (const key of ["Shift", "q", "Escape", "Delete", "Space"]) await scene.press(key);
  assert.match(await says(page, /scene/), /scene without a ball/);
  await scene.press("n");
  await says(page, /^Drag a body/);
  await page.locator("#make-watch").click();
  await says(page, /^The scene without a ball/);
  await page.locator("#make-x").fill("100");
  await page.locator("#make-x").press("Enter");
  await says(page, /^Drag a body/);
});

test("fields set the numbers, and the announcement says what was changed", async () => {
  const page = await openEditor();
  const { body1 } = await original(page);
  await page.locator("#make-bodies button").nth(body1).click();
  await page.locator("#make-x").fill("100.25");
  await page.locator("#make-x").press("Enter");
  await waitForScene(page, ({ bodies }) => bodies[body1].x === 100.25);
  await page
    .locator("#announcement")
    .filter({ hasText: /Green ball: x 100.25,.*moves/ })
    .waitFor({ state: "attached" });
});

test("the goal pair and whether a body moves can be chosen", async () => {
  const page = await openEditor();
  const before = await original(page);
  await page.locator("[data-adds=ball]").click();
  const added = before.bodies.length;
  await page.locator("#make-goal").click();
  await waitForScene(page, ({ body2 }) => body2 === added);
  assert.match(await page.locator("#goal").textContent(), /blue ball/);
  await page.locator("#make-dynamic").uncheck();
  await page
    .locator("#goal")
    .filter({ hasText: /purple ball/ })
    .waitFor();
  await page.locator("#make-object").click();
  await waitForScene(page, ({ body1, body2 }) => body1 === added && body2 === before.body1);
  assert.equal(await page.locator("#make-dynamic").isDisabled(), true);
});

test("a scene that may not be played says which body is in the way, and the puzzle stays the one before", async () => {
  const page = await openEditor();
  const { bodies, body1 } = await original(page);
  await page.locator("#make-bodies button").nth(body1).click();
  await page.locator("#make-y").fill(String(bodies[body1].y + 5));
  await page.locator("#make-y").press("Enter");
  const good = await linked(page);
  await page.locator("#make-y").fill("-3");
  await page.locator("#make-y").press("Enter");
  await page.locator("#make-problems:visible").filter({ hasText: "green ball" }).waitFor();
  assert.equal(await page.locator("#make-keep").isDisabled(), true);
  await pause(page, 600);
  assert.deepEqual(await linked(page), good);
  await page.locator("#make-undo").click();
  await page.locator("#make-problems").waitFor({ state: "hidden" });
});

test("the edited scene is the puzzle of every panel: placed, run, played by the model, mapped", async () => {
  const page = await openEditor({ reducedMotion: true });
  const { bodies, body1 } = await original(page);
  const { x, y } = bodies[body1];
  await dragTo(page, [
    [x, y],
    [x + 6, y + 12],
  ]);
  await page.mouse.up();
  await linked(page);
  await page.locator("#tab-imagine").click();
  await page
    .locator("#imagined-in")
    .filter({ hasText: /Imagined in/ })
    .waitFor();
  await page.locator("#tab-play").click();
  await click(page, 30, 240);
  await page.locator("#run").click();
  await says(page, /attempt 1/);
  await openPanel(page, "compare");
  await page.locator("#model-turn:enabled").click();
  await page.locator("#model-attempts li").first().waitFor({ timeout: 60_000 });
  await openPanel(page, "map");
  await page.locator("#solve-map-search").click();
  await page.locator("#solve-map-words").filter({ hasText: /tried/ }).waitFor();
});

test("Back returns to the puzzle that was edited", async () => {
  const page = await openEditor();
  const { bodies, body1 } = await original(page);
  const { x, y } = bodies[body1];
  await dragTo(page, [
    [x, y],
    [x, y + 10],
  ]);
  await page.mouse.up();
  await linked(page);
  await page.goBack();
  await page.waitForFunction((task) => location.hash.includes(task), EASY);
  await page.locator("#task").waitFor();
});

for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
  test(`axe finds nothing in the panel, ${colorScheme}`, async () => {
    const page = await openEditor({ colorScheme });
    await page.locator("#make-bodies button").first().click();
    await page.locator("#make-x").fill("-50");
    await page.locator("#make-x").press("Enter");
    await page.locator("#make-problems:visible").waitFor();
    await axeFindsNothing(page);
  });
}

test("what was typed counts for a run and for the link at once", async () => {
  const page = await openEditor({ permissions: ["clipboard-read", "clipboard-write"] });
  const { bodies, body1 } = await original(page);
  await page.locator("#make-bodies button").nth(body1).click();
  await page.locator("#make-x").fill(String(bodies[body1].x + 3));
  await page.locator("#make-watch").click();
  await says(page, /^The scene without a ball/);
  await page.waitForFunction(() => location.hash.includes("scene="));
  await pause(page, 600);
  await says(page, /^(The scene without a ball|That was the scene)/);
  assert.equal((await linked(page)).bodies[body1].x, bodies[body1].x + 3);

  // The sheet comes after the edited scene has become the puzzle.
  const before = page.url();
  await page.route("**/share-dialog.js", async (route) => {
    await page.waitForURL((url) => url.href !== before);
    await route.continue();
  });
  await page.locator("#make-x").fill(String(bodies[body1].x + 5));
  await openShare(page);
  await page.locator("#copy").click();
  await page.locator("#notice-text").filter({ hasText: "copied" }).waitFor();
  const other = await session.open("");
  await other.goto(await page.evaluate(() => navigator.clipboard.readText()));
  await other.locator("#scene").waitFor();
  assert.equal((await linked(other)).bodies[body1].x, bodies[body1].x + 5);
});

test("a drag that another panel interrupts is over, and what follows is kept", async () => {
  const page = await openEditor();
  const { bodies, body1 } = await original(page);
  const { x, y } = bodies[body1];
  await dragTo(page, [
    [x, y],
    [x + 10, y + 20],
  ]);
  await page.keyboard.press("1");
  await page.mouse.up();
  await page.locator("#tab-make").click();
  await page.locator("#make-x").fill(String(x + 7));
  await page.locator("#make-x").press("Tab");
  await waitForScene(page, (scene) => scene.bodies[body1].x === x + 7);
});

test("a drag in whose middle the scene is run is over, and what follows is kept", async () => {
  const page = await openEditor();
  const { bodies, body1 } = await original(page);
  const { x, y } = bodies[body1];
  await dragTo(page, [
    [x, y],
    [x + 10, y + 20],
  ]);
  await page.keyboard.press("Space");
  await page.waitForFunction(() => location.hash.includes("scene="));
  await page.mouse.up();
  await page.locator("#make-x").fill(String(x + 7));
  await page.locator("#make-x").press("Tab");
  await waitForScene(page, (scene) => scene.bodies[body1].x === x + 7);
});

test("what may not be played does not run, and says why; a step begins the scene that is seen", async () => {
  const { missing } = await known();
  const page = await openEditor({ fragment: `&panel=make&ball=${missing}` });
  const { bodies, body1 } = await original(page);
  await page.locator("#make-bodies button").nth(body1).click();
  await page.locator("#make-fields").waitFor();
  await page.locator("#make-x").fill("-50");
  await page.locator("#make-x").press("Enter");
  await page.locator("#make-problems:visible").waitFor();
  const problem = await page.locator("#make-problems li").first().textContent();
  await page.locator("#make-watch").click();
  await says(page, problem);
  await page.locator("#share-button").click();
  await painted(page);
  assert.equal(await page.locator("#share-dialog").isVisible(), false, "no other puzzle is shared instead");
  await page.locator("#make-x").fill(String(bodies[body1].x + 2));
  await page.locator("#make-x").press("Enter");
  await page.locator("#step").click();
  await says(page, /^Your attempt/);
  assert.equal((await linked(page)).bodies[body1].x, bodies[body1].x + 2);
  assert.equal(await page.locator("#time").inputValue(), "1", "at its first step");
});

test("a number that is far from any scene is not taken", async () => {
  const page = await openEditor();
  await page.locator("#make-bodies button").first().click();
  // The fields are filled a frame later.
  await page.locator("#make-fields").waitFor();
  for (const name of ["x", "y", "angle"]) {
    const before = await value(page, name);
    await page.locator(`#make-${name}`).fill("1e308");
    await page.locator(`#make-${name}`).press("Tab");
    await waitForValue(page, `#make-${name}`, (now) => Number(now) === before);
  }
});

test("the puzzle that is made of a challenge is none", async () => {
  const page = await openEditor({ fragment: "&panel=make&challenge=3" });
  const { bodies, body1 } = await original(page);
  await page.locator("#make-bodies button").nth(body1).click();
  await page.locator("#make-x").fill(String(bodies[body1].x + 3));
  await page.locator("#make-x").press("Tab");
  await linked(page);
  assert.doesNotMatch(page.url(), /challenge/);
});
