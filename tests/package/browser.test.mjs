// The installed package in Chromium, under a sub-path of a plain server: the README's pages.

import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { startOn } from "../browser/harness.mjs";
import { serveStatic } from "../browser/static-server.mjs";
import { drawn, open, playBoth } from "./playing.mjs";
import { examples, makeProject } from "./project.mjs";

const project = makeProject();
const [puzzles, drawing] = examples(project, "html");
const { load } = await import(join(project, "node_modules/pathlight/api/index.js"));

let session;
before(async () => (session = await startOn(await serveStatic(project))));
after(() => session.stop());

test("ten lines of HTML embed two puzzles, which play", async () => {
  assert.ok(puzzles.trim().split("\n").length <= 10, "it is short");
  writeFileSync(join(project, "puzzles.html"), puzzles);
  await playBoth(await open(session, `${session.origin}/puzzles.html`), await load());
});

test("a plain page draws what the nets imagine", async () => {
  writeFileSync(join(project, "imagine.html"), drawing);
  await drawn(await open(session, `${session.origin}/imagine.html`));
});
