// What the home page shows before any weights are there is what the first model gives today.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { recordHome } from "../../scripts/record-home.mjs";
import { root } from "./project.mjs";

const kept = JSON.parse(readFileSync(join(root, "assets/home.json"), "utf8"));

test("assets/home.json is what scripts/record-home.mjs writes", async () => {
  // By way of JSON, which has no -0.
  const recorded = JSON.parse(JSON.stringify(await recordHome()));
  assert.deepEqual(kept, recorded, "node scripts/record-home.mjs writes it again");
});

test("the model misses the first puzzle, so whoever has watched can win", async () => {
  const { load } = await import(join(root, "target/package/pathlight.js"));
  const { task, ball } = kept.scene;
  assert.equal((await load({ weights: null })).simulate(task, ball).solved, false);
});
