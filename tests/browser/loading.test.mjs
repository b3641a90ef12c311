// Files that cannot be loaded: what the page of www says went wrong, and what helps.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { EASY, button, known, modelIsThere, startPlayer } from "./player.mjs";

let session;
before(async () => {
  session = await startPlayer();
});
after(() => session.stop());

const WEIGHTS = /\.safetensors$/;
const WORKER_WASM = /worker\/pathlight_bg\.wasm$/;
const PAGE_WASM = /page\/pathlight_bg\.wasm$/;
const SCRIPT = /\/worker\.js$/;
const PAGE = /\/a\/$/;
const START_PAGE = "<!DOCTYPE html><title>Log in</title>";

const answer = (status, body, contentType) => (route) => route.fulfill({ status, body, contentType });
/** The file, changed. */
const changed = (change) => async (route) => {
  const response = await route.fetch();
  await route.fulfill({ response, body: change(await response.body()) });
};
const withPolicy = (from, to) => changed((body) => body.toString().replace(from, to));
const flipped = (body) => Buffer.from(body).fill(1, 500, 600);

/** What is wrong, of which file, and what the page says. */
const CASES = [
  ["weights that are not there", WEIGHTS, answer(404, ""), "A file was not found on this server"],
  ["weights from a server that is down", WEIGHTS, answer(503, ""), "The server does not answer"],
  ["no answer", WEIGHTS, (route) => route.abort("connectionrefused"), "The server does not answer"],
  [
    "a start page in place of weights",
    WEIGHTS,
    answer(200, START_PAGE, "text/html"),
    "A web page came in place of a file",
  ],
  ["damaged weights", WEIGHTS, changed(flipped), "A file arrived damaged"],
  ["cut weights", WEIGHTS, changed((body) => body.subarray(0, 1000)), "A file arrived damaged"],
  [
    "a page sent as wasm",
    WORKER_WASM,
    answer(200, START_PAGE, "application/wasm"),
    "A web page came in place of a file",
  ],
  ["cut wasm", WORKER_WASM, changed((body) => body.subarray(0, 1000)), "A file arrived damaged"],
  ["no wasm", WORKER_WASM, answer(404, ""), "A file was not found on this server"],
  ["no worker", SCRIPT, answer(404, ""), "A file was not found on this server"],
  ["a page in place of the worker", SCRIPT, answer(200, START_PAGE, "text/html"), "A web page came in place of a file"],
  ["a page that forbids workers", PAGE, withPolicy("; img-src", "; worker-src 'none'; img-src"), "forbids workers"],
  ["no wasm for the page", PAGE_WASM, answer(404, ""), "A file was not found on this server"],
  [
    "a page sent as the page's wasm",
    PAGE_WASM,
    answer(200, START_PAGE, "application/wasm"),
    "A web page came in place",
  ],
  ["damaged wasm of the page", PAGE_WASM, changed(flipped), "A file arrived damaged"],
  ["a page that forbids wasm", PAGE, withPolicy(" 'wasm-unsafe-eval'", ""), "This page forbids WebAssembly"],
];

for (const [name, url, handler, sentence] of CASES)
  test(`${name}: the page says so, and what helps`, async () => {
    const page = await session.open("");
    await page.route(url, handler);
    await page.goto(`${session.origin}/#task=${EASY}`);
    await page.getByText(sentence).waitFor();
    session.problems.length = 0;
  });

test("in Make a search says that it has no worker, and goes on with the next one", async () => {
  const page = await session.open("");
  await page.route(WORKER_WASM, answer(404, ""));
  await page.goto(`${session.origin}/#task=${EASY}&panel=make`);
  await page.getByRole("checkbox", { name: "Show every place that works" }).check();
  await page.getByText("A file was not found on this server").waitFor();
  await page.unroute(WORKER_WASM);
  await button(page, "Load it again").click();
  await page.getByText(/A ball of this size works at/).waitFor();
  session.problems.length = 0;
});

test("what an earlier version has kept in the browser is taken over once", async () => {
  const { missing } = await known();
  const page = await session.open("");
  const attempt = { task: EASY, by: "player", ball: missing[0], status: "not_solved", steps: 90, simulator: 3 };
  const lines = [attempt, { ...attempt, by: "within-0" }].map((line) => JSON.stringify(line)).join("\n");
  await page.addInitScript(
    (entries) => {
      if (sessionStorage.length === 0) for (const [key, text] of entries) localStorage.setItem(key, text);
      sessionStorage.setItem("begun", "");
    },
    [
      [`pathlight.attempts.${EASY}`, lines],
      ["pathlight.own-puzzles", "damaged"],
      ["pathlight.guess", "off"],
    ],
  );
  await page.goto(`${session.origin}/#task=${EASY}`);
  const list = page.getByRole("list", { name: "You against the model" }).getByRole("button");
  await list.waitFor();
  await page.waitForFunction(() => Object.keys(localStorage).length === 1);
  await page.reload();
  await list.waitFor();
  assert.equal(await list.count(), 1);
  assert.equal(await page.evaluate(() => JSON.parse(localStorage.getItem("pathlight") ?? "").guess), false);
});

test("without a connection one plays on, and the model comes with it", async () => {
  const page = await session.open("");
  await page.route(WEIGHTS, async (route) => {
    await page.context().setOffline(true);
    await route.abort("internetdisconnected");
  });
  await page.goto(`${session.origin}/#task=${EASY}`);
  await page.getByText("No connection").waitFor();
  await button(page, "Drop it").waitFor();
  await page.unroute(WEIGHTS);
  await page.context().setOffline(false);
  await modelIsThere(page);
  session.problems.length = 0;
});
