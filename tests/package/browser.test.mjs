// The installed package in Chromium, under a sub-path of a plain server: the README's pages, and a bundle made by Vite.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { startOn } from "../browser/harness.mjs";
import { serveStatic } from "../browser/static-server.mjs";
import { examples, makeProject, root } from "./project.mjs";

const project = makeProject();
const [puzzles, drawing] = examples(project, "html");
const { load } = await import(join(project, "node_modules/pathlight/api/index.js"));

let session;
before(async () => (session = await startOn(await serveStatic(project))));
after(() => session.stop());

/** Opens a file of the project. Browsers ask for an icon that is not there. */
async function open(path) {
  const page = await session.open("", { reducedMotion: "reduce" });
  await page.route("**/favicon.ico", (route) => route.fulfill({ status: 204 }));
  await page.goto(`${session.origin}/${path}`);
  return page;
}

/** Waits until a path lies over the scene: more green than the object has. */
const drawn = (page) =>
  page.waitForFunction(() => {
    const canvas = /** @type {any} */ (document.getElementById("picture"));
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    let green = 0;
    for (let at = 0; at < data.length; at += 4)
      if (data[at + 1] > data[at] + 20 && data[at + 1] > data[at + 2]) green++;
    return green > (canvas.width * canvas.height) / 50;
  });

/** Solves the first puzzle of the page while the second shows its maps. */
async function play(page) {
  const [first, second] = [page.locator("pathlight-puzzle").nth(0), page.locator("pathlight-puzzle").nth(1)];
  const pathlight = await load();
  const attempts = [...pathlight.turn(await first.getAttribute("task"))];
  const { ball, ending } = attempts.at(-1);
  assert.ok(ending.solved, "the model solves it");
  await first.locator("#run").waitFor();
  const played = first.evaluate(
    (puzzle) =>
      new Promise((resolve) =>
        puzzle.addEventListener("attempt", (event) => resolve(/** @type {CustomEvent} */ (event).detail)),
      ),
  );
  await first.evaluate((puzzle, ball) => puzzle.setAttribute("ball", ball), ball.join());
  await first.locator("#run").click();
  const { solved, task, ball: placed } = await played;
  assert.deepEqual({ solved, task, placed }, { solved: true, task: await first.getAttribute("task"), placed: ball });
  await second.locator('#stages canvas[aria-label*="most sure"]').nth(4).waitFor({ timeout: 60_000 });
}

test("ten lines of HTML embed two puzzles, which play", async () => {
  assert.ok(puzzles.trim().split("\n").length <= 10, "it is short");
  writeFileSync(join(project, "puzzles.html"), puzzles);
  await play(await open("puzzles.html"));
});

test("a plain page draws what the nets imagine", async () => {
  writeFileSync(join(project, "imagine.html"), drawing);
  await drawn(await open("imagine.html"));
});

test("Vite bundles both, with worker, wasm and weights", async () => {
  const app = join(project, "app");
  mkdirSync(app, { recursive: true });
  const bundled = (html) =>
    html
      .replace(
        '<script type="module" src="./node_modules/pathlight/element/pathlight-puzzle.js"></script>',
        '<script type="module">import "pathlight/element";</script>',
      )
      .replace("./node_modules/pathlight/api/index.js", "pathlight");
  assert.doesNotMatch(bundled(puzzles + drawing), /node_modules/);
  writeFileSync(join(app, "index.html"), bundled(puzzles));
  writeFileSync(join(app, "imagine.html"), bundled(drawing));
  writeFileSync(
    join(app, "vite.config.js"),
    'export default { build: { rolldownOptions: { input: ["index.html", "imagine.html"] } } };',
  );
  execFileSync(join(root, "tests/package/node_modules/.bin/vite"), ["build", "--base", "./", "--logLevel", "warn"], {
    cwd: app,
    stdio: "inherit",
  });
  await play(await open("app/dist/index.html"));
  await drawn(await open("app/dist/imagine.html"));
});
