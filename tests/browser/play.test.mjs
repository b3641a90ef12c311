// The loop of Play on the page of www, as a person plays it: placing, dropping, the duel, going on.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
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
  scene,
  spot,
  startPlayer,
} from "./player.mjs";

let session;
let balls;
before(async () => {
  session = await startPlayer();
  balls = await known();
});
after(() => session.stop());

const attempts = (page) => page.getByRole("list", { name: "You against the model" }).getByRole("button");

test("a drop plays a duel, of which nothing is told before its end", async () => {
  const page = await openPuzzle(session);
  await modelIsThere(page);
  await place(page, balls.missing[0]);
  // The second click of a double click must not pause what the first has begun.
  await button(page, "Drop it").dblclick();
  await button(page, "Pause").waitFor();
  assert.equal(await attempts(page).count(), 0);
  assert.equal(await page.getByRole("status").textContent(), "");
  await page.getByRole("combobox", { name: "Speed" }).selectOption("4×");
  await button(page, "Try again").waitFor();
  assert.match(await says(page, /ball/), /missed the goal by|touched the goal for/);
  assert.match(await says(page, /ball/), /The model gave your ball a chance of .+%; the path it guessed was .+ off/);
  assert.match(await attempts(page).getAttribute("aria-label"), /You: missed\. Model: (missed|solved)/);
  await button(page, "Try again").click();
  await button(page, "Drop it").waitFor();
  await described(page, new RegExp(`x ${balls.missing[0][0]}, y ${balls.missing[0][1]}`));
});

test("a solution leads on to another puzzle, and says whether it was luck", async () => {
  const page = await openPuzzle(session, `#task=${EASY}`, STILL);
  await place(page, balls.solving);
  await drop(page);
  await says(page, /balls beside yours solve it too/);
  await button(page, "Next puzzle").click();
  await button(page, "Drop it").waitFor();
  assert.doesNotMatch(page.url(), new RegExp(EASY));
  await page.goBack();
  await attempts(page).waitFor();
});

test("mouse, knob, wheel and slider place the ball; the wheel is the page's until the scene has the focus", async () => {
  const page = await openPuzzle(session, `#task=${EASY}&ball=128,120,12`);
  await page.mouse.move(...(await spot(page, 128, 120)));
  await page.mouse.wheel(0, -100);
  await page.mouse.down();
  await page.mouse.move(...(await spot(page, 140, 110)), { steps: 4 });
  await page.mouse.up();
  await described(page, /x 140, y 110, with radius 12/);
  await page.mouse.wheel(0, -100);
  await described(page, /radius 13/);
  for (let small = 0; small < 20; small++) await page.mouse.wheel(0, 5);
  await described(page, /radius 12/);
  await page.mouse.move(...(await spot(page, 152, 110)));
  await page.mouse.down();
  await page.mouse.move(...(await spot(page, 160, 110)), { steps: 4 });
  await page.mouse.up();
  await described(page, /x 140, y 110, with radius 20/);
  await page.getByRole("slider", { name: "Size" }).fill("7");
  await described(page, /radius 7/);
});

test("all by keys, also on a layout without Latin letters", async () => {
  const page = await openPuzzle(session, `#task=${EASY}`, STILL);
  await scene(page).focus();
  await page.keyboard.press("ArrowRight");
  await described(page, /Your ball is at/);
  await page.keyboard.press("+");
  await described(page, /radius 13/);
  await scene(page).dispatchEvent("keydown", { key: "я", code: "KeyZ", ctrlKey: true, bubbles: true });
  await described(page, /radius 12/);
  await place(page, balls.missing[0]);
  await page.keyboard.press("Enter");
  await says(page, /Not yet|solve/);
  await page.keyboard.press("Enter");
  await says(page, /Ready/);
});

test("a second pointer does not take the ball, and a pointer that the browser takes away leaves it", async () => {
  const page = await openPuzzle(session, `#task=${EASY}&ball=128,120,12`);
  const pointer = async (type, pointerId, x, y) => {
    const [clientX, clientY] = await spot(page, x, y);
    const facts = { pointerId, clientX, clientY, bubbles: true, isPrimary: pointerId === 1, pointerType: "touch" };
    await scene(page).evaluate((canvas) => (canvas.setPointerCapture = () => {}));
    await scene(page).dispatchEvent(type, facts);
  };
  await pointer("pointerdown", 1, 128, 120);
  await pointer("pointerdown", 2, 30, 30);
  await pointer("pointermove", 2, 40, 40);
  await pointer("pointermove", 1, 140, 120);
  await described(page, /x 140, y 120/);
  await pointer("pointercancel", 1, 140, 120);
  await described(page, /x 128, y 120/);
});

test("attempts and choices are still there when the page is loaded again, and come to other tabs", async () => {
  const page = await openPuzzle(session, `#task=${EASY}`, STILL);
  const other = await session.openIn(page.context(), `/#task=${EASY}`);
  await button(other, "Drop it").waitFor();
  await place(page, balls.missing[0]);
  await drop(page);
  await attempts(other).waitFor();
  await button(page, "Menu").click();
  await button(page, "Deutsch").click();
  await button(page, "Neuer Versuch").waitFor();
  await page.reload();
  await button(page, "Fallen lassen").waitFor();
  assert.equal(await page.locator("html").getAttribute("lang"), "de");
  assert.equal(await page.getByRole("list", { name: "Du gegen das Modell" }).getByRole("button").count(), 1);
});

test("after three misses every place that works can be shown", async () => {
  const page = await openPuzzle(session, `#task=${EASY}`, STILL);
  for (const ball of balls.missing.slice(0, 3)) {
    await place(page, ball);
    await drop(page);
  }
  await page.getByRole("checkbox", { name: "Show every place that works" }).check();
  await page.getByText(/A ball of this size works at .+ of all places/).waitFor();
});

test("what a browser takes away comes back: the picture of the scene, and a model that failed", async () => {
  const page = await session.open("", STILL);
  await page.route(/safetensors/, (route) => route.abort());
  await page.goto(`${session.origin}/#task=${EASY}`);
  await page.getByText("The server does not answer").waitFor();
  const restored = await scene(page).evaluate((canvas) => {
    const context = canvas.getContext("2d");
    context.clearRect(0, 0, canvas.width, canvas.height);
    canvas.dispatchEvent(new Event("contextrestored"));
    return context.getImageData(2, 2, 1, 1).data[3];
  });
  assert.equal(restored, 255);
  await page.unroute(/safetensors/);
  // Another tab has stored a choice meanwhile.
  await page.evaluate(() => localStorage.setItem("pathlight", '{"version":1,"language":"de"}'));
  await page.evaluate(() => dispatchEvent(new PageTransitionEvent("pageshow", { persisted: true })));
  await modelIsThere(page);
  await button(page, "Fallen lassen").waitFor();
  assert.ok(session.problems.splice(0).every((problem) => problem.includes("safetensors")));
});

test("a scene of another size is painted before it is seen", async () => {
  const page = await openPuzzle(session);
  const alpha = await scene(page).evaluateHandle((canvas) => {
    const { width } = canvas;
    let seen = null;
    // Called after the page's own observer, which is older, and before the browser shows the frame.
    new ResizeObserver(() => {
      if (canvas.width !== width) seen ??= canvas.getContext("2d").getImageData(2, 2, 1, 1).data[3];
    }).observe(canvas);
    return () => seen;
  });
  await page.setViewportSize({ width: 390, height: 664 });
  await page.waitForFunction((alpha) => alpha() !== null, alpha);
  assert.equal(await alpha.evaluate((alpha) => alpha()), 255);
});

test("a puzzle is opened by its number; one that there is not is said", async () => {
  const page = await openPuzzle(session);
  const number = page.getByRole("textbox", { name: "Number of the puzzle" });
  await number.fill("7:8");
  await number.press("Enter");
  await page.getByRole("heading", { name: "Funnel" }).waitFor();
  await number.fill("77:8");
  await number.press("Enter");
  await page.getByRole("alert").getByText("There is no puzzle 00077:008").waitFor();
});
