// The page in WebKit, of which Safari is made, too: as in Firefox. Skipped, with a word, where WebKitGTK is not
// installed: there is none for other systems.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { startServer } from "./harness.mjs";
import { playThrough } from "./played-through.mjs";
import { startWebKit, whyNoWebKit } from "./webkit.mjs";

const skip = whyNoWebKit() ?? false;

let server, webkit;
before(async () => {
  if (skip) return;
  server = await startServer(["--dir", "target/page"]);
  webkit = await startWebKit();
});
after(async () => {
  await webkit?.close();
  await server?.stop();
});

test("a puzzle is played against the model, and imagined", { timeout: 600_000, skip }, async () => {
  await playThrough(await webkit.newPage(), server.origin);
  assert.deepEqual(webkit.problems, []);
});
