// What the home page shows before any weights are there is what the shipped model and the simulator give today.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { recordHome } from "../../scripts/record-home.mjs";
import { load } from "../../www/api/index.js";
import { FIRST_TASK, SCENE_TASK } from "../../www/home/home-tasks.js";

const ASSETS = new URL("../../assets/", import.meta.url);
const HOME = new URL("home.json", ASSETS);
/** Beyond this it would hold up the first moving path, bytes. */
const MAX_SIZE = 40_000;

test("assets/home.json is what scripts/record-home.mjs writes", async () => {
  const text = await readFile(HOME, "utf8");
  // By way of JSON, which has no -0.
  const recorded = JSON.parse(JSON.stringify(await recordHome()));
  assert.deepEqual(JSON.parse(text), recorded, "node scripts/record-home.mjs writes it again");
  assert.ok(text.length < MAX_SIZE, `${text.length} bytes`);
});

test("its rollout is one that anybody can simulate again", async () => {
  const { scene } = JSON.parse(await readFile(HOME, "utf8"));
  const { task, ball, simulator, steps, digest } = scene;
  const pathlight = await load({ weights: null });
  const line = { task, ball, simulator, steps, digest, status: scene.solved ? "solved" : "not_solved" };
  assert.deepEqual(pathlight.verifyAttempt(line), { verdict: "same" });
});

test("the scene is new to the first model, and the puzzle of the introduction to all of them, and easy", async () => {
  const { models } = JSON.parse(await readFile(new URL("model.json", ASSETS), "utf8"));
  const pathlight = await load({ weights: null });
  for (const [index, { file }] of models.entries()) {
    await pathlight.loadWeights(new URL(file, ASSETS));
    assert.equal(pathlight.hasSeen(FIRST_TASK), false, file);
    if (index === 0) assert.equal(pathlight.hasSeen(SCENE_TASK), false, file);
  }
  assert.ok(pathlight.difficulty(FIRST_TASK).solve_rate >= 0.02);
});
