// The model's hundred proposals, one by one: the outcome of each, and the map that it comes from.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import {
  EASY,
  inMore,
  openPanel,
  openPuzzle,
  pause,
  picture,
  playModelTurn,
  says,
  spot,
  unsolvedTask,
} from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

// Many of the model's balls fail there.
const HARD = await unsolvedTask();
const ORIGIN =
  /^(Of all balls not tried yet, .+ \(.+%\)\.|Before the first attempt .+%\. Then ball \d+ failed, .+ the best of those not tried yet\.)$/;

async function compare(fragment = "", task = HARD) {
  const page = await openPuzzle(session, { task, fragment: `&panel=compare${fragment}`, reducedMotion: true });
  await page.locator("#proposals:visible").waitFor();
  return page;
}

const fact = (page, name) => page.locator(`#proposal-${name}`).textContent();

test("every ball can be looked at: where it is, its outcome, where it comes from", async () => {
  const page = await compare();
  const bare = await picture(page);
  const balls = new Set();
  await page.locator("#proposal-next").click();
  const [looked, count] = [8, 100];
  for (let number = 1; number <= looked; number += 1) {
    assert.equal(await fact(page, "number"), `${number} of ${count}`);
    balls.add(await fact(page, "ball"));
    assert.match(await fact(page, "ball"), /^x \d+, y \d+, radius \d+$/);
    assert.match(await fact(page, "outcome"), /^[✓×] .+\. $/);
    assert.match(await fact(page, "origin"), ORIGIN);
    await says(page, new RegExp(`The model’s ball ${number}:`));
    if (number < looked) await page.locator("#proposal-next").click();
  }
  assert.equal(balls.size, looked, "no two are alike");
  assert.notEqual(await picture(page), bare, "its paths and the marks are in the scene");
  await page.locator("#proposal-slider").fill(String(count));
  assert.equal(await fact(page, "number"), `${count} of ${count}`);
  await page.locator("#proposal-next").click();
  assert.equal(await fact(page, "number"), `${count} of ${count}`, "there is no more");
  assert.equal(await page.locator("#model-attempts li").count(), 0, "looking is no attempt");
});

test("the list of a puzzle that the model solves ends with the ball that solves", async () => {
  const page = await compare("", EASY);
  await page.locator("#proposal-next").click();
  const [, count] = /^1 of (\d+)$/.exec(await fact(page, "number")) ?? [];
  await page.locator("#proposal-slider").fill(String(count));
  assert.equal(await fact(page, "number"), `${count} of ${count}`);
  assert.match(await fact(page, "outcome"), /^✓/);
});

test("what comes of its balls is not told before the model has played, or before they are looked at", async () => {
  const page = await compare("", EASY);
  await page.locator("#proposals").waitFor();
  assert.ok(await page.locator("#proposal-outcomes").isHidden());
  await playModelTurn(page);
  await page.locator("#proposal-outcomes").waitFor();
});

test("where no other outcome follows, the panel says so", async () => {
  const page = await compare("&proposal=1", "00009:013");
  await page.locator("#proposal-number", { hasText: "1 of 1" }).waitFor();
  await page.locator("#proposal-other").click();
  await page.locator("#proposal-none", { hasText: "No ball after this one has another result." }).waitFor();
});

test("a ball of the turn is the same ball with the same outcome", async () => {
  const page = await compare("", EASY);
  await playModelTurn(page);
  const title = await page.locator("#model-attempts li").first().locator("button").first().getAttribute("title");
  const words = await page.locator("#model-attempts li").first().locator(".words").textContent();
  await page.locator("#proposal-next").click();
  await page.locator("#proposal-facts:visible").waitFor();
  assert.equal(title, `Replay: ball at ${await fact(page, "ball")}`);
  const outcome = await fact(page, "outcome");
  assert.ok(outcome.toLowerCase().includes(words.toLowerCase()) && !/not tried/.test(outcome), outcome);
});

test("it is in the link, goes by keys, and ends when something else is done", async () => {
  const page = await compare("&proposal=3");
  await page.locator("#proposal-number", { hasText: "3 of" }).waitFor();
  await page.locator("#proposal-slider").focus();
  await page.keyboard.press("ArrowRight");
  await page.locator("#proposal-number", { hasText: "4 of" }).waitFor();
  await page.waitForFunction(() => /proposal=4/.test(location.hash));
  await page.mouse.click(...(await spot(page, 30, 240)));
  await page.locator("#proposal-facts").waitFor({ state: "hidden" });
  await page.waitForFunction(() => !/proposal=/.test(location.hash));
  await says(page, /Ready|Not here/);
});

test("another puzzle opens without a ball of the model’s", async () => {
  const page = await compare("&proposal=2");
  await page.locator("#proposal-number", { hasText: "2 of" }).waitFor();
  await page.locator("#next").click();
  await says(page, /place the red ball/);
  await page.locator("#proposals:visible").waitFor();
  assert.equal(await fact(page, "number"), "–");
  assert.doesNotMatch(page.url(), /proposal=/);
});

test("a number past the last proposal is refused in a sentence", async () => {
  const page = await session.open("/#task=00000:000&proposal=101");
  await page.locator("#notice-text").filter({ hasText: "“proposal=101”" }).waitFor();
});

test("each shows what the model imagined for it, beside what really happened", async () => {
  const page = await compare("&proposal=1");
  const imagined = page.locator("#proposal-imagined");
  await imagined
    .filter({ hasText: /^[A-Z][a-z’ ]+ \(.+%\)\. Its path for green was \d+ px off, on average\.$/ })
    .waitFor();
  const first = await picture(page);
  await page.locator("#proposal-next").click();
  await page.locator("#proposal-number", { hasText: "2 of" }).waitFor();
  await imagined.filter({ hasText: "Its path for green" }).waitFor();
  assert.notEqual(await picture(page), first);
});

test("the outcomes are counted, a key leads to another one, and all are saved, also from another tab", async () => {
  const {
    agents: [{ first_solved: solved }],
  } = JSON.parse(await readFile(new URL("../../results/shipped/within-0.json", import.meta.url), "utf8"));
  const [late, total] = solved.find(([, first]) => first > 50);
  const page = await openPuzzle(session, { task: late, fragment: "&panel=imagine", reducedMotion: true });
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
  const [file] = await Promise.all([
    page.waitForEvent("download"),
    inMore(page, () => page.locator("#proposal-save").click()),
  ]);
  const lines = (await readFile(await file.path(), "utf8")).trimEnd().split("\r\n");
  assert.equal(lines.length, total + 1);
  const [head, ...rows] = lines.map((line) => line.split(","));
  const of = (row, name) => row[head.indexOf(name)];
  const outcomes = rows.map((row) => of(row, "outcome"));
  assert.ok(outcomes.indexOf("solved") === total - 1, `${outcomes}`);
  assert.deepEqual(
    [of(rows[0], "task"), of(rows[0], "model"), of(rows[0], "seen_in_training")],
    [late, "within-0", "false"],
  );

  await openPanel(page, "compare");
  await page.locator("#proposal-next").click();
  const some = (outcome, one, more) => {
    const count = outcomes.filter((other) => other === outcome).length;
    return `${count} ${count === 1 ? one : more}`;
  };
  assert.equal(
    await page.locator("#proposal-outcomes").textContent(),
    `Of ${total} balls, 1 solves the puzzle, ${some("touched", "gets", "get")} green to touch its goal for a while, and ${some("missed", "never does", "never do")}.`,
  );
  const first = await page.locator("#proposal-facts dt").first().textContent();
  assert.equal(first, "Why this one", "where it comes from stands first");
  const other = outcomes.findIndex((outcome) => outcome !== outcomes[0]) + 1;
  await page.locator("#proposal-slider").press("n");
  assert.equal(await fact(page, "number"), `${other} of ${total}`);
  const row = rows[other - 1];
  assert.equal(await fact(page, "ball"), `x ${of(row, "x")}, y ${of(row, "y")}, radius ${of(row, "r")}`);
  await page.keyboard.press("Shift+N");
  assert.equal(await fact(page, "number"), `${other - 1} of ${total}`);
  await page.locator("#proposal-other").click();
  assert.equal(await fact(page, "number"), `${other} of ${total}`);
});

test("wherever a result stands it says what the model knows, and whether it has seen the puzzle", async () => {
  const page = await compare();
  const badge = (panel) => page.locator(`${panel} .model-badge`).first();
  assert.equal((await badge("#compare").innerText()).replace(/\s+/g, " "), "Knows all 25 kinds new to the model");
  await page.locator("#tab-imagine").click();
  await badge("#imagine").filter({ hasText: "new to the model" }).waitFor();
  await inMore(page, () => page.locator("#model-select").selectOption("cross-0"));
  await badge("#imagine")
    .filter({ hasText: /Knows 20 of 25 kinds\s+only its maps practised this one/ })
    .waitFor();
  await page
    .locator("#model-words")
    .filter({ hasText: "cross-0 knows 20 of the 25 kinds" })
    .waitFor({ state: "attached" });
});

test("a number past the last ball of this puzzle leaves the address", async () => {
  const page = await compare("&proposal=90", EASY);
  await page.waitForFunction(() => !location.hash.includes("proposal="));
  await page.locator("#proposal-next").click();
  await page.locator("#proposal-number", { hasText: "1 of" }).waitFor();
  // Also from the address of the open puzzle, when the list is there.
  await page.waitForFunction(() => location.hash.includes("proposal=1"));
  await page.evaluate(() => (location.hash = location.hash.replace(/proposal=\d+/, "proposal=90")));
  await page.waitForFunction(() => !location.hash.includes("proposal=90"));
  // The address is written a moment after what it tells.
  await pause(page, 600);
  assert.doesNotMatch(page.url(), /proposal=/);
});
