// The focus is not lost when what has it is hidden, disabled or removed: keys and screen readers go on from a place
// that makes sense.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import {
  MODEL_TRIES_AGAIN,
  becomeRegular,
  focused,
  known,
  openPuzzle,
  says,
  type,
  unsolvedTask,
} from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

/** Presses a control by key once it is shown, as somebody without a mouse does. */
async function press(control) {
  await control.waitFor();
  await control.focus();
  await control.press("Enter");
}

/** Waits until the element of this id has the focus, also inside a puzzle. */
async function waitForFocus(page, id) {
  await page.locator(`#${id}:focus`).waitFor();
}

/** A page in which the puzzle has been solved, or missed. */
async function played(which) {
  const page = await openPuzzle(session, { reducedMotion: true });
  await type(page, (await known())[which]);
  await page.locator("#run").click();
  await says(page, /^(Solved|Not solved)/);
  return page;
}

/** Opens a page of Pathlight that shows no puzzle. */
async function openView(fragment) {
  const page = await session.open("");
  await page.addInitScript(becomeRegular);
  await page.goto(`${session.origin}/${fragment}`);
  return page;
}

test("the next puzzle is ready for the arrows", async () => {
  const page = await played("solving");
  const solved = page.url();
  await press(page.locator("#solved-next"));
  await page.waitForFunction((url) => location.href !== url, solved);
  await waitForFocus(page, "scene");
});

test("a puzzle that is asked for the focus before it is loaded takes it then, unless something else has it", async () => {
  const page = await openView("");
  await page.locator("#templates canvas.drawn").first().waitFor();
  for (const [id, goesOn] of /** @type {const} */ ([
    ["first", false],
    ["second", true],
  ])) {
    await page.evaluate(([id, goesOn]) => {
      const puzzle = Object.assign(document.createElement("pathlight-puzzle"), { id, task: "00000:000" });
      document.body.append(puzzle);
      puzzle.focus();
      if (goesOn) document.getElementById("about-button")?.focus();
    }, /** @type {const} */ ([id, goesOn]));
    await page.locator(`#${id} #scene`).waitFor();
    await waitForFocus(page, goesOn ? "about-button" : `${id} #scene`);
  }
});

test("from the results and back, more than once", async () => {
  const page = await openView("#view=results");
  for (let visit = 0; visit < 2; visit += 1) {
    await press(page.locator("#results-templates a").first());
    await waitForFocus(page, "scene");
    await page.goBack();
    await waitForFocus(page, "results-title");
  }
  await press(page.locator("#results .back"));
  await waitForFocus(page, "gallery-title");
});

test("watching it learn begins at its title, also the second time", async () => {
  const page = await openView("");
  for (let visit = 0; visit < 2; visit += 1) {
    await press(page.locator("[data-pick=learns] a"));
    await waitForFocus(page, "learns-title");
    await press(page.locator("#learns .back"));
    await waitForFocus(page, "gallery-title");
  }
});

test("reset and the last attempt that is deleted leave it to the scene", async () => {
  const page = await played("missing");
  await press(page.locator("#reset"));
  await waitForFocus(page, "scene");
  await press(page.getByRole("button", { name: "Delete attempt 1" }));
  await waitForFocus(page, "scene");
});

test("so does the model’s turn that is skipped, and its ball that is left", async () => {
  const page = await openPuzzle(session, { task: await unsolvedTask(), fragment: "&panel=compare" });
  await page.locator("#model-turn:enabled").click();
  await says(page, MODEL_TRIES_AGAIN);
  await press(page.locator("#model-skip"));
  await waitForFocus(page, "scene");
  await page.locator("#proposal-next").click();
  await press(page.locator("#proposal-close"));
  await waitForFocus(page, "scene");
});

test("another try at what failed leaves it to the scene, or to the title", async () => {
  const results = await session.open("/icon.svg");
  await results.route("**/results.json", (route) => route.fulfill({ status: 503 }));
  await results.goto(`${session.origin}/#view=results`);
  const retry = results.locator("#results-retry");
  await retry.waitFor();
  await results.unroute("**/results.json");
  await press(retry);
  await waitForFocus(results, "results-title");

  const page = await openPuzzle(session, { fragment: "&panel=imagine&model=nobody" });
  await press(page.locator("#imagine-trouble:visible button"));
  await waitForFocus(page, "scene");
  session.takeProblems();
});

test("a custom puzzle that is deleted leaves it to its neighbour, and a notice that is closed gives it back", async () => {
  const page = await openView("");
  const body = { angle: 0, dynamic: true };
  const scene = (name) => ({
    version: 1,
    name,
    body1: 0,
    body2: 1,
    bodies: [
      { shape: "ball", radius: 12, x: 60, y: 200, ...body },
      { shape: "bar", length: 80, thickness: 5, x: 200, y: 10, ...body, dynamic: false },
    ],
  });
  const buffer = Buffer.from(JSON.stringify([scene("First"), scene("Second")]));
  await page.locator("#custom-open").waitFor();
  await page.locator("#custom-file").setInputFiles({ name: "two.json", mimeType: "application/json", buffer });
  const deletes = (name) => page.getByRole("button", { name: `Delete ${name}` });
  const label = async () => (await focused(page)).getAttribute("aria-label");
  await press(deletes("Second"));
  assert.equal(await label(), "Delete First");
  await press(page.getByRole("button", { name: "Undo" }));
  assert.equal(await (await focused(page)).textContent(), "Close");
  await deletes("Second").waitFor();
  await page.keyboard.press("Enter");
  assert.equal(await label(), "Delete First");
  await press(deletes("First"));
  await press(deletes("Second"));
  await waitForFocus(page, "custom-open");
});

test("progress that is forgotten leaves it to what follows", async () => {
  const page = await played("missing");
  await page.locator("#home").click();
  await press(page.locator("#progress-forget"));
  await press(page.locator("#forget-dialog [value=keep]"));
  await waitForFocus(page, "progress-forget");
  await press(page.locator("#progress-forget"));
  await press(page.locator("#forget-dialog [value=forget]"));
  await waitForFocus(page, "gallery-order");
});
