// Attempts as files: a hundred made in the browser are saved with their digests, verified by the native program, read
// back, the same to the bit, and replayed; what was changed or is foreign is found out. The badge of a run names its
// digest.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { binary, start } from "./harness.mjs";
import { EASY, attempts, inMore, known, openPuzzle, playModelTurn, says, type, unsolvedTask } from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

async function savedAttempts(page) {
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    inMore(page, () => page.locator("#attempts-save").click()),
  ]);
  assert.match(download.suggestedFilename(), /attempts\.jsonl$/);
  return (await readFile(await download.path(), "utf8"))
    .trimEnd()
    .split("\n")
    .map((line) => JSON.parse(line));
}

async function openAttempts(page, name, text) {
  if (await page.locator("#more").isHidden()) await page.locator("#more-button").click();
  await page
    .locator("#attempts-file")
    .setInputFiles({ name, mimeType: "application/jsonl", buffer: Buffer.from(text) });
}

/** Has the native program verify attempts. */
function verify(text) {
  const { status, stdout, stderr } = spawnSync(binary, ["verify", "-"], { input: text, encoding: "utf8" });
  return {
    status,
    stderr,
    verdicts: stdout
      .trimEnd()
      .split("\n")
      .map((line) => JSON.parse(line).verdict),
  };
}

const words = (page, pattern) => page.locator("#attempts-words").filter({ hasText: pattern }).waitFor();

test("a hundred attempts of the model are saved and come out the same, and one of them is replayed", async () => {
  const page = await openPuzzle(session, {
    task: await unsolvedTask(),
    fragment: "&panel=compare",
    reducedMotion: true,
  });
  await playModelTurn(page);
  await page.locator("#tab-play").click();
  const lines = await savedAttempts(page);
  assert.equal(lines.length, 100);
  assert.ok(lines.every(({ digest, ball, status }) => /^[0-9a-f]{16}$/.test(digest) && ball.length === 3 && status));
  const text = lines.map((line) => JSON.stringify(line)).join("\n");
  const verified = verify(text);
  assert.equal(verified.status, 0, verified.stderr);
  assert.deepEqual(verified.verdicts, Array(100).fill("same"), "natively too");
  const other = await openPuzzle(session, { reducedMotion: true });
  await openAttempts(other, "hundred.jsonl", text);
  await words(other, "hundred.jsonl: 100 of 100 attempts come out the same to the bit");
  await other.locator("#attempts-read button").nth(41).click();
  await says(other, /^Not solved\. The opened attempt: /);
  await other.waitForFunction((task) => location.hash.includes(task), lines[41].task);
  assert.ok(await other.locator("#more").isHidden(), "the menu does not cover what runs");
  assert.equal(await attempts(other), 0, "it is not the person’s own");
});

test("an attempt that was changed is found out, and a foreign file is a sentence", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  const { solving, missing } = await known();
  for (const one of [solving, missing]) {
    await type(page, one);
    await page.locator("#run").click();
    await says(page, /^(Solved|Not solved)/);
  }
  const [line] = await savedAttempts(page);
  const changed = [
    { ...line, steps: line.steps + 1 },
    { ...line, digest: "0".repeat(64) },
    { ...line, ball: [-9, 0, 5] },
    { beach: true },
  ];
  await openAttempts(page, "changed.jsonl", [line, ...changed].map((one) => JSON.stringify(one)).join("\n"));
  await words(page, "changed.jsonl: 1 of 5 attempts comes out the same to the bit");
  for (const [name, text] of [
    ["noise.jsonl", "\u0001 noise"],
    ["empty.jsonl", "\n"],
  ]) {
    await openAttempts(page, name, text);
    await words(page, new RegExp(`${name} is not a file of attempts`));
    assert.equal(await page.locator("#attempts-read li").count(), 5);
  }
});

test("an attempt at a custom scene carries the scene", async () => {
  const page = await openPuzzle(session, { fragment: "&panel=make", reducedMotion: true });
  await page.locator("[data-adds=bar]").click();
  await page.waitForFunction(() => /scene=/.test(location.hash));
  await page.locator("#tab-play").click();
  await type(page, [30, 240, 8]);
  await page.locator("#run").click();
  await says(page, /attempt/);
  const [line] = await savedAttempts(page);
  assert.equal(line.task, undefined);
  assert.ok(line.scene.bodies.length > 2);
  const other = await openPuzzle(session, { reducedMotion: true });
  await openAttempts(other, "own.jsonl", JSON.stringify(line));
  await words(other, "1 of 1 attempt");
  await other.locator("#attempts-read button").click();
  await other.locator("#puzzle-name").filter({ hasText: "edited" }).waitFor();
});

test("an attempt that was not valid is told as one, and cannot be replayed", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  const requests = [
    { task: EASY, ball: [-9, 0, 5] },
    { task: EASY, ball: [128, 240, 8] },
  ]
    .map((one) => JSON.stringify(one))
    .join("\n");
  const { stdout } = spawnSync(binary, ["simulate", "--batch", "-", "--verifiable"], {
    input: requests,
    encoding: "utf8",
  });
  await openAttempts(page, "two.jsonl", stdout);
  await words(page, "two.jsonl: 2 of 2 attempts come out the same to the bit");
  assert.match(await page.locator("#attempts-read li").first().textContent(), /: not valid, the same$/);
  assert.equal(await page.locator("#attempts-read button").count(), 1);
});
