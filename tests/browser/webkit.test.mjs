// The page in WebKit, of which Safari is made, too: as in Firefox. Skipped, with a word, where WebKitGTK is not
// installed: there is none for other systems.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { playThrough } from "./played-through.mjs";
import { startWebKit, whyNoWebKit } from "./webkit.mjs";

const skip = whyNoWebKit() ?? false;

let session, webkit;
before(async () => {
  if (skip) return;
  session = await start();
  webkit = await startWebKit();
});
after(async () => {
  await webkit?.close();
  await session?.stop();
});

test("a puzzle is solved, imagined, and played by the model", { timeout: 1_800_000, skip }, async () => {
  await playThrough(await webkit.newPage(), session.origin);
  assert.deepEqual(webkit.problems, []);
});
