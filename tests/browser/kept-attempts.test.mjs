// Attempts are kept for each puzzle and model, come back when the puzzle is opened again, and are saved to a file and
// read back whole.

import assert from "node:assert/strict";
import { readFile, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import {
  EASY,
  attempts,
  inMore,
  known,
  modelLoaded,
  openPanel,
  openPuzzle,
  playModelTurn,
  says,
  type,
} from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

async function run(page, ball, words) {
  await type(page, ball);
  await page.locator("#run").click();
  await says(page, words);
}

/** A miss and a solution of the player's, and the model's turn. */
async function played(options = {}) {
  const page = await openPuzzle(session, { reducedMotion: true, ...options });
  const { missing, solving } = await known();
  await run(page, missing, /^Not solved/);
  await page.locator("#reset").click();
  await run(page, solving, /^Solved/);
  await openPanel(page, "compare");
  await playModelTurn(page);
  return page;
}

const titles = (page, list) =>
  page
    .locator(`#${list} [data-act=replay]`)
    .evaluateAll((buttons) => buttons.map((button) => button.title + button.textContent));

/** The player's balls that are listed, in words. */
const balls = (page) =>
  page.locator("#play-attempts [data-act=replay]").evaluateAll((buttons) => buttons.map((button) => button.title));

test("the attempts of both come back after a reload and after another puzzle, and are replayed", async () => {
  const page = await played();
  const [player, model] = [await titles(page, "play-attempts"), await titles(page, "model-attempts")];
  assert.equal(player.length, 2);
  assert.ok(model.length >= 1);
  const verdict = await page.locator("#race-verdict").textContent();
  await page.reload();
  await page.locator("#model-turn").filter({ hasText: "The model has played" }).waitFor();
  assert.deepEqual(await titles(page, "play-attempts"), player);
  assert.deepEqual(await titles(page, "model-attempts"), model);
  assert.equal(await page.locator("#race-verdict").textContent(), verdict);
  assert.match(
    await page.locator("#task option:checked").textContent(),
    /solved at try 2$/,
    "the picker counts them alike",
  );
  await page.locator("#play-attempts [data-act=replay]").first().click();
  await says(page, /^Not solved. Your attempt 1/);
  await page.locator("#next").click();
  assert.equal(await attempts(page), 0);
  await page.locator("#previous").click();
  assert.equal(await attempts(page), 2);
});

test("another model has attempts of its own, and those of the first stay", async () => {
  const page = await played();
  const model = await titles(page, "model-attempts");
  await page.locator("#tab-imagine").click();
  await inMore(page, () => page.locator("#model-select").selectOption("cross-0"));
  await modelLoaded(page, "cross-0");
  await openPanel(page, "compare");
  assert.deepEqual(await titles(page, "model-attempts"), []);
  await page.goBack();
  await page.locator("#tab-imagine").click();
  await inMore(page, () => page.locator("#model-select").selectOption("within-0"));
  await modelLoaded(page, "within-0");
  await openPanel(page, "compare");
  await page.locator("#model-attempts li").first().waitFor();
  assert.deepEqual(await titles(page, "model-attempts"), model);
});

test("a model that is asked for by its name, when it is there already as the first, keeps its attempts", async () => {
  const page = await played();
  const model = await titles(page, "model-attempts");
  await page.locator("#tab-imagine").click();
  await inMore(page, () => page.locator("#model-select").selectOption("within-0"));
  await openPanel(page, "compare");
  await page.locator("#model-attempts li").first().waitFor();
  assert.deepEqual(await titles(page, "model-attempts"), model);
});

test("an attempt that is deleted, and all that are cleared, stay away", async () => {
  const page = await played();
  await page.locator("#play-attempts [data-act=remove]").first().click();
  await page.reload();
  await page.locator("#model-attempts li").first().waitFor();
  assert.equal((await titles(page, "play-attempts")).length, 1);
  await inMore(page, () => page.locator("#clear-attempts").click());
  await page.reload();
  await modelLoaded(page);
  assert.deepEqual([...(await titles(page, "play-attempts")), ...(await titles(page, "model-attempts"))], []);
});

test("attempts of two tabs stay both", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  const other = await page.context().newPage();
  await other.emulateMedia({ reducedMotion: "reduce" });
  await other.goto(page.url());
  const { missing, solving } = await known();
  await run(page, missing, /^Not solved/);
  await run(other, solving, /^Solved/);
  await other.reload();
  await other.locator("#play-attempts li").nth(1).waitFor();
  // What is deleted in one stays away when the other goes on.
  await page.locator("#play-attempts [data-act=remove]").click();
  await page.reload();
  await page.locator("#play-attempts li").first().waitFor();
  assert.equal(await attempts(page), 1);
});

test("the attempts saved at a puzzle are read back as those of the player and of the model", async () => {
  const page = await played();
  const [player, model] = [await titles(page, "play-attempts"), await titles(page, "model-attempts")];
  await page.locator("#tab-play").click();
  const [file] = await Promise.all([
    page.waitForEvent("download"),
    inMore(page, () => page.locator("#attempts-save").click()),
  ]);
  const elsewhere = await session.open("/");
  await elsewhere.locator("#templates a").first().waitFor();
  await elsewhere.locator("#progress-file").setInputFiles(await file.path());
  await elsewhere.locator("#progress-words").filter({ hasText: "solved 1, in 2 attempts" }).waitFor();
  await elsewhere.goto(`${session.origin}/#task=${EASY}&panel=compare`);
  await elsewhere.locator("#model-attempts li").first().waitFor();
  assert.deepEqual(await titles(elsewhere, "play-attempts"), player);
  assert.deepEqual(await titles(elsewhere, "model-attempts"), model);
});

test("all is saved to a file and read back whole on another device", async () => {
  const page = await played();
  const [player, model] = [await titles(page, "play-attempts"), await titles(page, "model-attempts")];
  await page.locator("#home").click();
  const [file] = await Promise.all([page.waitForEvent("download"), page.locator("#progress-save").click()]);
  const path = await file.path();
  const saved = JSON.parse(await readFile(path, "utf8"));
  assert.deepEqual(saved.tasks, { [EASY]: { attempts: 2, solved: 2 } });
  assert.deepEqual(
    saved.attempts
      .map(({ task, by, status, simulator }) => [task, by, status, Number.isInteger(simulator)])
      .slice(0, 2),
    [
      [EASY, "player", "not_solved", true],
      [EASY, "player", "solved", true],
    ],
  );
  assert.equal(saved.attempts.filter(({ by }) => by === "within-0").length, model.length);
  assert.equal(saved.models["within-0"][EASY].attempts, model.length);

  const elsewhere = await session.open("/");
  await elsewhere.locator("#templates a").first().waitFor();
  await elsewhere.locator("#progress-file").setInputFiles(path);
  await elsewhere
    .locator("#notice-text")
    .filter({ hasText: `Loaded: 1 puzzle, with ${2 + model.length} attempts.` })
    .waitFor();
  await elsewhere.locator("#progress-words").filter({ hasText: "solved 1, in 2 attempts" }).waitFor();
  await elsewhere.goto(`${session.origin}/#task=${EASY}&panel=compare`);
  await elsewhere.locator("#model-attempts li").first().waitFor();
  assert.deepEqual(await titles(elsewhere, "play-attempts"), player);
  assert.deepEqual(await titles(elsewhere, "model-attempts"), model);
  await elsewhere.locator("#score-words", { hasText: "over one puzzle" }).waitFor();

  // JSON lines of attempts alone are read too.
  const lines = join(tmpdir(), `pathlight-${process.pid}.jsonl`);
  await writeFile(lines, saved.attempts.map((one) => `${JSON.stringify({ ...one, digest: "more" })}\n`).join(""));
  const third = await session.open("/");
  await third.locator("#templates a").first().waitFor();
  await third.locator("#progress-file").setInputFiles(lines);
  await third.locator("#progress-words").filter({ hasText: "solved 1, in 2 attempts" }).waitFor();
});

test("a file of older attempts, shorter or longer, takes nothing away: they are added", async () => {
  const page = await played();
  const [player, model] = [await balls(page), await titles(page, "model-attempts")];
  await page.locator("#home").click();
  const line = (x) => ({
    task: EASY,
    by: "player",
    ball: [x, 240, 8],
    status: "not_solved",
    steps: 900,
    longest_touch: 0,
    final_touch: 0,
    simulator: 1,
  });
  for (const [count, added] of [
    [1, 1],
    [3, 2],
    [3, 0],
  ]) {
    const buffer = Buffer.from(
      JSON.stringify({ tasks: {}, attempts: Array.from({ length: count }, (_, index) => line(20 + 30 * index)) }),
    );
    await page.locator("#progress-file").setInputFiles({ name: "file.json", mimeType: "application/json", buffer });
    await page
      .locator("#notice-text")
      .filter({ hasText: `${count} attempt${count === 1 ? "" : "s"}. New here: ${added} attempt` })
      .waitFor();
    await page.goto(`${session.origin}/#task=${EASY}&panel=compare`);
    await page.locator("#model-attempts li").first().waitFor();
    const kept = await balls(page);
    assert.equal(kept.length, player.length + count);
    for (const ball of player) assert.ok(kept.includes(ball), `${ball} is gone`);
    assert.deepEqual(await titles(page, "model-attempts"), model);
    await page.locator("#home").click();
  }
});

test("two devices: what one has solved at once stays so when it reads the other’s misses, which can be undone", async () => {
  const { missing, solving } = await known();
  const first = await openPuzzle(session, { reducedMotion: true });
  await run(first, solving, /^Solved/);
  await first.locator("#home").click();
  const before = await first.locator("#progress-words").textContent();
  assert.match(before, /tried 1 puzzle and solved 1, in 1 attempt\./);

  const second = await openPuzzle(session, { reducedMotion: true });
  for (const ball of [missing, [30, 240, 8]]) {
    await run(second, ball, /^Not solved/);
    await second.locator("#reset").click();
  }
  await second.locator("#home").click();
  const [file] = await Promise.all([second.waitForEvent("download"), second.locator("#progress-save").click()]);

  const read = async () => {
    await first.locator("#progress-file").setInputFiles(await file.path());
    await first
      .locator("#notice-text")
      .filter({ hasText: "Loaded: 1 puzzle, with 2 attempts. New here: 2 attempts, 0 solved puzzles." })
      .waitFor();
  };
  await read();
  await first.locator("#notice button", { hasText: "Undo" }).click();
  await first.locator("#notice-text").filter({ hasText: "as it was before" }).waitFor();
  assert.equal(await first.locator("#progress-words").textContent(), before);
  await read();
  await first.locator("#progress-words").filter({ hasText: "tried 1 puzzle and solved 1, in 3 attempts." }).waitFor();
  await first.goto(`${session.origin}/#task=${EASY}`);
  await first.locator("#play-attempts li").nth(2).waitFor();
  assert.match(await first.locator("#task option:checked").textContent(), /solved at try 1$/);
  assert.equal(await first.locator("#play-attempts li .mark.solved").count(), 1);
  await first.locator("#home").click();

  // The other way round the solution comes over.
  const [other] = await Promise.all([first.waitForEvent("download"), first.locator("#progress-save").click()]);
  await second.locator("#progress-file").setInputFiles(await other.path());
  await second.locator("#notice-text").filter({ hasText: "New here: 1 attempt, 1 solved puzzle." }).waitFor();
  assert.equal(
    await second.locator("#progress-words").textContent(),
    await first.locator("#progress-words").textContent(),
  );
});

test("a file with a longer turn of other agents takes nothing away", async () => {
  const page = await played();
  const model = await titles(page, "model-attempts");
  await page.locator("#home").click();
  const line = (x) => ({
    task: EASY,
    by: "within-0",
    ball: [x, 240, 8],
    status: "not_solved",
    steps: 900,
    longest_touch: 0,
    final_touch: 0,
    simulator: 3,
    agents: 1,
  });
  const buffer = Buffer.from(
    JSON.stringify({ tasks: {}, attempts: Array.from({ length: 90 }, (_, index) => line(20 + 2 * index)) }),
  );
  await page.locator("#progress-file").setInputFiles({ name: "file.json", mimeType: "application/json", buffer });
  await page.locator("#notice-text").filter({ hasText: "Loaded" }).waitFor();
  await page.goto(`${session.origin}/#task=${EASY}&panel=compare`);
  await page.locator("#model-attempts li").first().waitFor();
  assert.deepEqual(await titles(page, "model-attempts"), model);
});

for (const [what, content] of Object.entries({
  "no JSON": "soup",
  "another form": "[1, 2]",
  "impossible attempts": JSON.stringify({
    tasks: {},
    attempts: [{ task: "soup", ball: [1], status: "solved", steps: 1 }],
  }),
})) {
  test(`a file with ${what} is a sentence, and nothing is lost`, async () => {
    const page = await played();
    await page.locator("#home").click();
    await page
      .locator("#progress-file")
      .setInputFiles({ name: "file.json", mimeType: "application/json", buffer: Buffer.from(content) });
    await page.locator("#notice-text").filter({ hasText: "This file holds no progress of Pathlight" }).waitFor();
    await page.locator("#templates a").first().click();
    assert.equal(await attempts(page), 2);
  });
}

for (const [whose, others] of Object.entries({ agents: { agents: 1 }, weights: { weights: "0123abcd" } })) {
  test(`a turn that other ${whose} made is not brought back, and the new one takes its place`, async () => {
    const page = await played();
    await page.evaluate(([task, others]) => {
      const key = `pathlight.attempts.${task}`;
      const lines = (localStorage.getItem(key) ?? "")
        .trim()
        .split("\n")
        .map((line) => JSON.parse(line));
      localStorage.setItem(
        key,
        lines.map((line) => `${JSON.stringify(line.agents ? { ...line, ...others } : line)}\n`).join(""),
      );
    }, /** @type {const} */ ([EASY, others]));
    await page.reload();
    await modelLoaded(page);
    assert.deepEqual(await titles(page, "model-attempts"), []);
    await playModelTurn(page);
    const kept = await page.evaluate(
      (task) =>
        (localStorage.getItem(`pathlight.attempts.${task}`) ?? "")
          .trim()
          .split("\n")
          .map((line) => JSON.parse(line)),
      EASY,
    );
    const turn = kept.filter(({ by }) => by === "within-0");
    assert.ok(turn.length > 0);
    for (const { agents, weights } of turn) {
      assert.ok(agents > 1 && /^[0-9a-f]{8}$/.test(weights) && weights !== "0123abcd", JSON.stringify(kept));
    }
  });
}
