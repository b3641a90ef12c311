// Weights of the paper's four nets alone: four maps, balls from the placement map, and no ball is imagined.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { binary, start } from "./harness.mjs";
import { modelLoaded, openPuzzle } from "./page-actions.mjs";

let session, folder;
before(async () => {
  // The smallest training.
  folder = mkdtempSync(join(tmpdir(), "pathlight-"));
  const at = (name) => join(folder, name);
  const run = (...words) => execFileSync(join(dirname(binary), "pathlight-lab"), words, { stdio: "pipe" });
  run("data", "collect", "--template", "2", "--limit", "4", "--per-task", "2", "--out", at("solutions.jsonl"));
  run("train", "paths", "--solutions", at("solutions.jsonl"), "--epochs", "1", "--batch", "4", "--out", at("run"));
  run("publish", "weights", at("run/weights.safetensors"), "--assets", at("assets"));
  session = await start({ serve: ["--assets", at("assets")] });
});
after(async () => {
  await session.stop();
  rmSync(folder, { recursive: true });
});

test("the maps of the paper are drawn, and the other says that there is none", async () => {
  const page = await openPuzzle(session, { fragment: "&panel=imagine&layers=placement,success" });
  await page
    .locator("#imagined-in")
    .filter({ hasText: /Imagined in [\d,]+ ms/ })
    .waitFor();
  for (const map of ["base", "target", "action", "placement"]) {
    assert.match(await page.locator(`[data-map=${map}] .summary`).textContent(), /^Most sure /, map);
  }
  const success = page.locator("[data-map=success]");
  assert.equal(await success.locator(".summary").textContent(), "This model has no such map.");
  assert.doesNotMatch(await page.locator("#imagine-intro").textContent(), /success|dynamics/);
  assert.doesNotMatch(await success.locator(".how").textContent(), /the success net|dynamics/i);
  // Its name does not tell what it has learned from, its card does.
  assert.match(await page.locator("#model-words").textContent(), / knows all 25 kinds of puzzles\.$/);
  await page.locator("#walkthrough-dots button:visible").last().click();
  assert.match(await page.locator("#announcement").textContent(), /^Where to start\. Where .+\. It is most sure /);
});

test("its balls come from the placement map", async () => {
  const page = await openPuzzle(session, { fragment: "&panel=compare&proposal=1" });
  await page
    .locator("#proposal-origin")
    .filter({ hasText: /placement map/ })
    .waitFor();
});

test("it does not imagine balls, and the page does not offer it", async () => {
  const page = await openPuzzle(session, { fragment: "&forecast=on&ball=128,230,8" });
  await modelLoaded(page);
  await page.locator("#forecast").waitFor({ state: "hidden" });
  assert.equal(await page.locator("#forecast-words").textContent(), "");
});

test("its story ends with the maps, also if a link asks for more", async () => {
  const page = await openPuzzle(session, { fragment: "&panel=imagine&step=chosen" });
  await page
    .locator("#imagined-in")
    .filter({ hasText: /Imagined in [\d,]+ ms/ })
    .waitFor();
  assert.ok(await page.locator("#choice").isHidden());
  assert.equal(await page.locator("#walkthrough-dots button:visible").count(), 4);
  assert.equal(await page.locator("#walkthrough-all").getAttribute("aria-pressed"), "true");
});
