// What goes wrong around a person who plays: haste, storage that fails, damaged or hostile input, a worker that stops.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { deflateRawSync } from "node:zlib";
import { after, before, test } from "node:test";
import { EASY, STILL, button, drop, known, modelIsThere, openPuzzle, place, says, startPlayer } from "./player.mjs";
import { customScene, templates } from "../../www/pkg/page/pathlight.js";

let session;
let balls;
before(async () => {
  session = await startPlayer();
  balls = await known();
});
after(() => session.stop());

const maps = (page) => page.getByRole("group", { name: "Maps over the scene" }).getByRole("button");
const labels = (page) => maps(page).evaluateAll((all) => all.map((one) => one.getAttribute("aria-label")));
const go = (page, hash) => page.evaluate((hash) => void (location.hash = hash), hash);

test("whoever hurries through puzzles sees of the last what is its own", async () => {
  const page = await openPuzzle(session, `#task=${EASY}&panel=imagine`, STILL);
  const tasks = templates().map(({ tasks }) => tasks[0]);
  await page.evaluate((tasks) => {
    for (const task of tasks) location.hash = `task=${task}&panel=imagine`;
  }, tasks);
  const next = button(page, "Next puzzle in the list");
  const last = templates().at(-1)?.tasks ?? [];
  await page.waitForURL(new RegExp(last[0]));
  await next.dblclick();
  for (let clicks = 0; clicks < 6; clicks++) await next.click();
  await page.waitForURL(new RegExp(last[8]));
  await maps(page).first().waitFor();
  const other = await openPuzzle(session, `#task=${last[8]}&panel=imagine`, STILL);
  await maps(other).first().waitFor();
  assert.deepEqual(await labels(page), await labels(other));
  for (let steps = 0; steps < 3; steps++) await page.evaluate(() => history.back());
  await page.waitForURL(new RegExp(last[5]));
  await button(page, "Drop it").waitFor();
});

test("a worker that traps is a sentence, and one plays alone; another one goes on with the model", async () => {
  const page = await session.open("", STILL);
  await page.route("**/worker.js", async (route) => {
    const response = await route.fetch();
    // The first model's turn that is asked for traps.
    const trap = `let traps = true;
      addEventListener("message", (event) => {
        if (event.data.call !== "turn" || !traps) return;
        traps = false;
        event.stopImmediatePropagation();
        postMessage({ id: event.data.id, failure: { code: "crashed", reason: "unreachable" } });
      });`;
    await route.fulfill({ response, body: trap + (await response.text()) });
    await page.unroute("**/worker.js");
  });
  await page.goto(`${session.origin}/#task=${EASY}`);
  await page.getByText("It stopped unexpectedly").waitFor();
  await place(page, balls.missing[0]);
  await drop(page);
  assert.match(await says(page, /Not yet/), /^Not yet\./);
  await button(page, "Load it again").click();
  await modelIsThere(page);
  await button(page, "Try again").click();
  await place(page, balls.missing[1]);
  await drop(page);
  await says(page, /model/);
});

test("a browser that keeps nothing, and one that is full, are played in all the same", async () => {
  for (const [break_, notice] of /** @type {const} */ ([
    [
      () =>
        Object.defineProperty(globalThis, "localStorage", {
          get: () => {
            throw new DOMException("", "SecurityError");
          },
        }),
      true,
    ],
    [
      () =>
        (Storage.prototype.setItem = () => {
          throw new DOMException("", "QuotaExceededError");
        }),
      true,
    ],
    [() => localStorage.setItem("pathlight", '{"version":'), false],
  ])) {
    const page = await session.open("", STILL);
    await page.addInitScript(break_);
    await page.goto(`${session.origin}/#task=${EASY}`);
    await button(page, "Drop it").waitFor();
    await place(page, balls.missing[0]);
    await drop(page);
    await page.getByRole("list", { name: "You against the model" }).getByRole("button").waitFor();
    if (notice) await page.getByRole("alert").getByText("This browser keeps nothing here").waitFor();
    else assert.equal(await page.getByRole("alert").count(), 0);
  }
});

test("a file of 20,000 lines is read beside the play, and its attempts are counted", async () => {
  const page = await openPuzzle(session, `#task=${EASY}`, STILL);
  // Following a link closes messages, so the ball lies there before the file is read.
  await place(page, balls.missing[0]);
  await page.getByRole("tab", { name: "Data" }).click();
  const lines = (await readFile(new URL("../../assets/attempts.jsonl", import.meta.url), "utf8")).trim().split("\n");
  const found = lines.filter((line) => JSON.parse(line).ball).length;
  const outside = '{"task":"00000:000","ball":[0,0,9]}';
  const text = [...lines, ...Array.from({ length: 20_000 - lines.length }, () => outside)].join("\n");
  await page
    .getByLabel("Open a file")
    .setInputFiles({ name: "all.jsonl", mimeType: "text/plain", buffer: Buffer.from(text) });
  const alert = page.getByRole("alert");
  await alert.getByText("The file is read").waitFor();
  await page.getByRole("tab", { name: "Play" }).click();
  await drop(page);
  await alert.getByText(`${found} attempts in the file`).waitFor();
  await alert.getByText(`${(20_000 - found).toLocaleString("en")} lines aren’t attempts`).waitFor();
});

const linkOf = (json) => `#scene=${deflateRawSync(json).toString("base64url")}`;

test("a hostile link or file is refused in a sentence, and one plays on", async () => {
  const deep = (depth) => "[".repeat(depth) + "]".repeat(depth);
  const scene = JSON.stringify(customScene(EASY));
  const page = await openPuzzle(session, `#task=${EASY}`, STILL);
  const refused = () => page.getByRole("alert").getByText("cannot be opened").waitFor();
  for (const json of [
    deep(100_000),
    `{"version":1,"bodies":${deep(50_000)}}`,
    scene.replace('"bodies":', `"extra":${deep(50_000)},"bodies":`).replace('"version":1', '"version":9'),
    `{"version":1,"bodies":[${"0,".repeat(100_000)}0]}`,
    scene.replace(/"x":[\d.]+/, '"x":1e400'),
    `"${"\u0000".repeat(10_000_000)}"`,
  ]) {
    await go(page, linkOf(json));
    await refused();
    await button(page, "Close").click();
  }
  await page.getByRole("tab", { name: "Make" }).click();
  const file = page.getByLabel("Open a file");
  for (const json of [deep(100_000), `[${scene},${deep(50_000)}]`, "null", "[]"]) {
    await file.setInputFiles({ name: "a.json", mimeType: "application/json", buffer: Buffer.from(json) });
    await page.getByRole("alert").getByText("This file was not opened").waitFor();
    await button(page, "Close").click();
  }
  await page.getByRole("tab", { name: "Data" }).click();
  // Until then the field is that of Make.
  await page.getByText(/^0 attempts, kept/).waitFor();
  const lines = [
    deep(30_000),
    `{"scene":${deep(30_000)},"ball":[1,2,3]}`,
    '{"task":{},"ball":[]}',
    "0",
    '{"ball":"x"}',
  ];
  await file.setInputFiles({ name: "a.jsonl", mimeType: "text/plain", buffer: Buffer.from(lines.join("\n")) });
  await page.getByRole("alert").getByText("a.jsonl is not a file of attempts").waitFor();
  await page.getByRole("tab", { name: "Play" }).click();
  await place(page, balls.missing[0]);
  await drop(page);
});

test("what is typed into a field is no shortcut, no key acts behind a dialog, and a key that is held acts once", async () => {
  const page = await openPuzzle(session, `#task=${EASY}`, STILL);
  await page.getByRole("tab", { name: "Make" }).click();
  const name = page.getByRole("textbox", { name: "Name" });
  await name.pressSequentially("r2] 3");
  assert.match(await name.inputValue(), /r2\] 3$/);
  await page.getByRole("tab", { name: "Make", selected: true }).waitFor();
  // The press leaves the field, which renames the puzzle; the release must still meet the tab.
  await page.getByRole("tab", { name: "Play" }).hover();
  await page.mouse.down();
  await page.getByRole("heading", { name: "r2] 3" }).waitFor();
  await page.mouse.up();
  await page.getByRole("tab", { name: "Play", selected: true }).waitFor();
  await button(page, "Share").click();
  await page.getByRole("dialog").waitFor();
  for (const key of ["2", "]", "r", "Control+z"]) await page.keyboard.press(key);
  await page.keyboard.press("Escape");
  await page.getByRole("dialog").waitFor({ state: "detached" });
  await page.getByRole("tab", { name: "Play", selected: true }).waitFor();
  await place(page, balls.missing[0]);
  await page.getByRole("application").focus();
  for (let repeats = 0; repeats < 3; repeats++) await page.keyboard.down("Enter");
  await page.keyboard.up("Enter");
  await button(page, "Try again").waitFor();
});
