// What the home page shows before any weights are there is what the first model gives today.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { recordHome } from "../../scripts/record-home.mjs";
import { root } from "./project.mjs";

test("assets/home.json is what scripts/record-home.mjs writes", async () => {
  // By way of JSON, which has no -0.
  const recorded = JSON.parse(JSON.stringify(await recordHome()));
  const kept = JSON.parse(readFileSync(join(root, "assets/home.json"), "utf8"));
  assert.deepEqual(kept, recorded, "node scripts/record-home.mjs writes it again");
});
