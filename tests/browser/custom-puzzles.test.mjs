// Custom puzzles: opened from links and files, kept in the browser and shown in the grid; what is damaged or foreign is
// a sentence, and nothing that was there is lost.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { axeFindsNothing } from "./axe.mjs";
import { start } from "./harness.mjs";
import { EASY, inMore, openPuzzle } from "./page-actions.mjs";

let session;
before(async () => (session = await start({ sources: true })));
after(() => session.stop());

const SCENE = {
  version: 1,
  name: "Over the wall",
  body1: 0,
  body2: 1,
  bodies: [
    { shape: "ball", radius: 12, x: 60, y: 200, angle: 0, dynamic: true },
    { shape: "bar", length: 80, thickness: 5, x: 200, y: 10, angle: 0, dynamic: false },
    { shape: "bar", length: 60, thickness: 5, x: 128, y: 32, angle: 1.5708, dynamic: false },
  ],
};

/** The text of the link to a scene, made in the page. */
function textOf(page, scene) {
  return page.evaluate(async (scene) => (await import("/editor/scene-link.js")).textOfScene(scene), scene);
}

const file = (name, content) => ({
  name,
  mimeType: "application/json",
  buffer: Buffer.from(typeof content === "string" ? content : JSON.stringify(content)),
});

async function openFiles(page, ...files) {
  await page.locator("#custom-file").setInputFiles(files);
}

async function notice(page, pattern) {
  await page.locator("#notice-text").filter({ hasText: pattern }).waitFor();
}

/** Drops a file on the page. */
async function drop(page, { name, buffer }) {
  const data = await page.evaluateHandle(
    ({ name, text }) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([text], name, { type: "application/json" }));
      return transfer;
    },
    { name, text: buffer.toString() },
  );
  await page.dispatchEvent("main", "drop", { dataTransfer: data });
}

test("a link opens the puzzle elsewhere, with its name and goal", async () => {
  const first = await session.open("/");
  await first.locator("#templates canvas.drawn").first().waitFor();
  const text = await textOf(first, SCENE);
  const page = await session.open(`/#scene=${text}`);
  await page.locator("#puzzle-name").filter({ hasText: "Over the wall" }).waitFor();
  await page
    .locator("#goal")
    .filter({ hasText: /green ball.*purple bar/ })
    .waitFor();
  assert.equal(await page.locator(".picker").isVisible(), false);
  // Beside a puzzle the name of the page is enough, of whatever kind it is.
  await page.setViewportSize({ width: 800, height: 900 });
  const sizes = [];
  for (const fragment of [`scene=${text}`, `task=${EASY}`]) {
    await page.goto(`${session.origin}/#${fragment}`);
    await page.locator("#goal").waitFor();
    sizes.push(
      await page
        .locator("header")
        .first()
        .evaluate((header) => header.querySelector(".brand").clientWidth),
    );
  }
  assert.equal(sizes[0], sizes[1]);
});

test("the table of the model’s balls quotes the name of the puzzle", async () => {
  const first = await session.open("/");
  await first.locator("#custom-open").waitFor();
  const page = await session.open(
    `/#scene=${await textOf(first, { ...SCENE, name: 'Over, "by hand"' })}&panel=compare`,
  );
  const [table] = await Promise.all([
    page.waitForEvent("download"),
    inMore(page, () => page.locator("#proposal-save").click()),
  ]);
  const [head, ...rows] = (await readFile(await table.path(), "utf8")).trimEnd().split("\r\n");
  const name = '"Over, ""by hand""",';
  assert.ok(rows.length > 0 && rows.every((row) => row.startsWith(name)), rows[0]);
  assert.ok(
    rows.every((row) => row.slice(name.length).split(",").length === head.split(",").length - 1),
    rows[0],
  );
});

test("a damaged link is a sentence, and the kept puzzles stay", async () => {
  const page = await session.open("/");
  await page.locator("#custom-open").waitFor();
  const text = await textOf(page, SCENE);
  await page.evaluate((scene) => localStorage.setItem("pathlight.own-puzzles", JSON.stringify([scene])), SCENE);
  for (const damaged of [
    text.slice(0, -9),
    "AAAA",
    await textOf(page, { ...SCENE, body2: 7 }),
    await textOf(page, { foreign: true }),
  ]) {
    const other = await session.openIn(page.context(), `/#scene=${damaged}`);
    await other
      .locator("#problem")
      .filter({ hasText: /^This link holds/ })
      .waitFor();
    await other.locator("#home").click();
    await other.locator("#custom-puzzles li").filter({ hasText: "Over the wall" }).waitFor();
    await other.close();
  }
});

test("a file is opened by the button and by a drop, and saved again as it was", async () => {
  const page = await session.open("/");
  await page.locator("#custom-open").waitFor();
  await openFiles(page, file("wall.json", SCENE));
  await page.locator("#puzzle-name").filter({ hasText: "Over the wall" }).waitFor();
  await page.locator("#tab-make").click();
  const [download] = await Promise.all([page.waitForEvent("download"), page.locator("#make-save").click()]);
  assert.equal(download.suggestedFilename(), "over-the-wall.json");
  assert.deepEqual(JSON.parse(await readFile(await download.path(), "utf8")), SCENE);
  await page.locator("#home").click();
  await page.locator("#gallery").waitFor();
  await drop(page, file("dropped.json", { ...SCENE, name: "Dropped" }));
  await page.locator("#puzzle-name").filter({ hasText: "Dropped" }).waitFor();
});

test("a foreign or invalid file is a sentence that names it, and changes nothing", async () => {
  const page = await openPuzzle(session);
  const hash = new URL(page.url()).hash;
  const wrong = [
    [file("holiday.json", '{"beach": true}'), /holiday\.json cannot be played/],
    [file("noise.json", "\u0000\u0001 nothing"), /noise\.json is not a file of puzzles/],
    [file("two.json", [SCENE, { ...SCENE, bodies: [] }]), /puzzle 2 of two\.json cannot be played/i],
    [file("none.json", []), /none\.json holds no puzzle/],
    [file("tries.jsonl", "{}"), /tries\.jsonl is a file of attempts.*“Open attempts”/],
  ];
  for (const [one, sentence] of wrong) {
    await openFiles(page, one);
    await notice(page, sentence);
    assert.equal(new URL(page.url()).hash, hash);
  }
  assert.equal(await page.evaluate(() => localStorage.getItem("pathlight.own-puzzles")), null);
});

test("hide=puzzles: a file that is dropped opens no other puzzle", async () => {
  const page = await openPuzzle(session, { fragment: "&hide=puzzles" });
  await drop(page, file("dropped.json", SCENE));
  await notice(page, /no file is opened here/);
  assert.match(page.url(), /task=/);
});

test("a file dropped on the results leaves them behind", async () => {
  const page = await session.open("/#view=results");
  await page.locator("#results-templates a").first().waitFor();
  await drop(page, file("one.json", SCENE));
  await page.locator("#puzzle-name").filter({ hasText: "Over the wall" }).waitFor();
  assert.doesNotMatch(page.url(), /view=/);
  await page.locator("#forecast:visible").waitFor();
});

test("a puzzle is kept, shown in the grid after a reload, opened, deleted and brought back; all are saved", async () => {
  const page = await openPuzzle(session, { fragment: "&panel=make" });
  await page.locator("[data-adds=ball]").click();
  await page.locator("#make-name").fill("Mine");
  await page.locator("#make-name").press("Enter");
  await page.waitForFunction(() => /scene=/.test(location.hash));
  await page.locator("#make-keep").click();
  await page.locator("#make-said").filter({ hasText: "“Mine” is kept" }).waitFor();
  await page.locator("#home").click();
  await page.reload();
  await page.locator("#custom-puzzles li").first().scrollIntoViewIfNeeded();
  await page.locator("#custom-puzzles canvas.drawn").first().waitFor();
  await openFiles(page, file("many.json", [SCENE, { ...SCENE, name: "Second" }]));
  await notice(page, /2 puzzles are kept/);
  const [download] = await Promise.all([page.waitForEvent("download"), page.locator("#custom-save").click()]);
  const saved = JSON.parse(await readFile(await download.path(), "utf8"));
  assert.deepEqual(
    saved.map(({ name }) => name),
    ["Mine", "Over the wall", "Second"],
  );
  await page.locator('#custom-puzzles button[aria-label="Delete Second"]').click();
  await notice(page, /“Second” is deleted/);
  assert.equal(await page.locator("#custom-puzzles li").count(), 2);
  await page.locator("#notice button", { hasText: "Undo" }).click();
  await page.locator("#custom-puzzles li").nth(2).waitFor();
  await page.locator('#custom-puzzles a[href*="scene="]', { hasText: "Mine" }).click();
  await page.locator("#puzzle-name").filter({ hasText: "Mine" }).waitFor();
});

test("a ball that is moved writes no link of a kept puzzle again", async () => {
  const page = await session.open("/");
  await page.evaluate((scene) => localStorage.setItem("pathlight.own-puzzles", JSON.stringify([scene])), SCENE);
  await page.reload();
  const link = page.locator("#custom-puzzles a");
  await page.locator('#custom-puzzles a[href*="scene="]').waitFor();
  const href = await link.getAttribute("href");
  await page.goto(`${session.origin}/#task=${EASY}&hide=map`);
  await page.locator("#scene").waitFor();
  assert.equal(await link.getAttribute("href"), `${href}&hide=map`);
  const written = await page.evaluateHandle(() => {
    const count = { written: 0 };
    globalThis.CompressionStream = class extends CompressionStream {
      constructor(/** @type {CompressionFormat} */ format) {
        super(format);
        count.written += 1;
      }
    };
    return count;
  });
  for (let step = 0; step < 5; step += 1) await page.locator("#scene").press("ArrowRight");
  await page.waitForFunction(() => /ball=/.test(location.hash));
  assert.equal(await written.evaluate((count) => count.written), 0);
});

test("axe finds nothing in a grid with custom puzzles", async () => {
  const page = await session.open("/");
  await page.evaluate((scene) => localStorage.setItem("pathlight.own-puzzles", JSON.stringify([scene])), SCENE);
  await page.reload();
  await page.locator("#custom-puzzles li").first().scrollIntoViewIfNeeded();
  await page.locator("#custom-puzzles canvas.drawn").first().waitFor();
  await axeFindsNothing(page);
});

test("a store that is damaged or full never breaks the page", async () => {
  const page = await session.open("/");
  await page.evaluate(() => localStorage.setItem("pathlight.own-puzzles", '{"not": ["what it was'));
  await page.goto(`${session.origin}/#task=${EASY}&panel=make`);
  await page.reload();
  await page.locator("[data-adds=ball]").click();
  await page.evaluate(
    () =>
      (Storage.prototype.setItem = () => {
        throw new DOMException("full", "QuotaExceededError");
      }),
  );
  await page.locator("#make-keep:enabled").click();
  await page.locator("#make-said").filter({ hasText: "has no room left" }).waitFor();
});
