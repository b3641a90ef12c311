// The page in Firefox: open, place, solve, imagine, let the model play, without a word in the console.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { startFirefox } from "./firefox.mjs";
import { start } from "./harness.mjs";
import { playThrough } from "./played-through.mjs";

let session, firefox;
before(async () => {
  session = await start();
  firefox = await startFirefox();
});
after(async () => {
  await firefox.close();
  await session.stop();
});

test("a puzzle is solved, imagined, and played by the model", { timeout: 1_800_000 }, async () => {
  const page = await firefox.newPage();
  const problems = [];
  page.on("console", (message) => ["error", "warn"].includes(message.type()) && problems.push(message.text()));
  page.on("pageerror", (error) => problems.push(error.message));
  await playThrough(page, session.origin);
  assert.deepEqual(problems, []);
});
