// The page in Firefox, without a word in the console.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { startFirefox } from "./firefox.mjs";
import { startServer } from "./harness.mjs";
import { playThrough } from "./played-through.mjs";

let server, firefox;
before(async () => {
  server = await startServer(["--dir", "target/page"]);
  firefox = await startFirefox();
});
after(async () => {
  await firefox.close();
  await server.stop();
});

test("a puzzle is played against the model, and imagined", { timeout: 600_000 }, async () => {
  const page = await firefox.newPage();
  const problems = [];
  page.on("console", (message) => ["error", "warn"].includes(message.type()) && problems.push(message.text()));
  page.on("pageerror", (error) => problems.push(error.message));
  await playThrough(page, server.origin);
  assert.deepEqual(problems, []);
});
