// The installed package in Chromium, under a sub-path of a plain server: the examples for plain pages.

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { startOn } from "../browser/harness.mjs";
import { serveStatic } from "../browser/static-server.mjs";
import { drawn, open, playBoth } from "./playing.mjs";
import { entryOf, example, makeProject, readmeCode } from "./project.mjs";

const project = makeProject();
const { load } = await import(entryOf(project));

let session;
before(async () => (session = await startOn(await serveStatic(project))));
after(() => session.stop());

test("the example of a page embeds two puzzles, which play", async () => {
  writeFileSync(join(project, "page.html"), example(project, "page.html"));
  await playBoth(await open(session, `${session.origin}/page.html`), await load());
});

test("a plain page draws what the nets imagine", async () => {
  writeFileSync(join(project, "imagine.html"), example(project, "imagine.html"));
  await drawn(await open(session, `${session.origin}/imagine.html`));
});

test("the README's two lines of HTML show a puzzle", async () => {
  writeFileSync(join(project, "lines.html"), readmeCode(project, "html"));
  const page = await open(session, `${session.origin}/lines.html`);
  await page.locator("pathlight-puzzle").getByText("If you do nothing").filter({ visible: true }).first().waitFor();
});
