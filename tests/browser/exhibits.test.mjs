// The exhibits "Watch it learn" and "Results": pages of their own on the public package.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { axeFindsNothingInLightAndDark } from "./axe.mjs";
import { load } from "./package.mjs";
import { STILL, button, openPuzzle, startPlayer } from "./player.mjs";

let session;
before(async () => (session = await startPlayer()));
after(() => session.stop());

const PHONE = { viewport: { width: 390, height: 664 }, hasTouch: true, isMobile: true };
/** A kind at which it needs few balls, so that a test is fast. */
const FAST = "Topple to the Wall";
const read = async (path) => JSON.parse(await readFile(new URL(`../../${path}`, import.meta.url), "utf8"));

async function open(exhibit, options = {}) {
  const page = await session.open("", options);
  await page.goto(`${session.origin}/${exhibit}`);
  await page
    .locator(/^learns/.test(exhibit) ? ".radios canvas" : ".tasks a")
    .first()
    .waitFor();
  return page;
}

const isWide = (page) => page.evaluate(() => document.documentElement.scrollWidth > innerWidth);
const played = (page) => page.locator("ol li");
const until = (page, count) =>
  played(page)
    .nth(count - 1)
    .waitFor({ state: "attached", timeout: 120_000 });

test("from the menu, in the language of the page; an earlier link leads there too", async () => {
  const page = await openPuzzle(session);
  await button(page, "Menu").click();
  await button(page, "Deutsch").click();
  await page.getByRole("link", { name: "Dem Modell beim Lernen zusehen" }).click();
  await page.getByRole("heading", { name: "Dem Modell beim Lernen zusehen" }).waitFor();
  assert.equal(await page.locator("html").getAttribute("lang"), "de");
  await page.goto(`${session.origin}/#view=results`);
  await page.getByRole("heading", { name: "Wie gut sind die Modelle?" }).waitFor();
});

test("twenty puzzles take it fewer balls than without memory; all is there after a visit to a puzzle, until it is forgotten", async () => {
  const page = await open("learns.html", STILL);
  assert.equal(await page.getByRole("radio").count(), 5);
  await page.getByText("It remembers nothing yet.").waitFor();
  await button(page, "Let it play 20").click();
  await button(page, "To the end").click();
  await until(page, 20);
  await button(page, "Play 20 more").waitFor();
  const words = await page.getByText("In this one run").textContent();
  const [, learned, fresh] = /took it ([\d,]+) balls with its memory, and ([\d,]+) without/.exec(words) ?? [];
  const [withMemory, without] = [learned, fresh].map((count) => Number(count.replace(",", "")));
  assert.ok(withMemory < without, words);
  assert.match(await page.getByRole("status").textContent(), /^Puzzle 20: /);
  assert.match((await played(page).allTextContents()).join("\n"), /helped by puzzle \d+\. Without memory: /);
  await page.getByText("Puzzle by puzzle").click();
  await axeFindsNothingInLightAndDark(page, "learns");
  const link = played(page).first().getByRole("link");
  const [, task] = /task=(\d{5}:\d{3})$/.exec((await link.getAttribute("href")) ?? "") ?? [];
  await link.click();
  await button(page, "Drop it").waitFor();
  assert.match(page.url(), new RegExp(`task=${task}$`));
  await page.goBack();
  await page.getByText("It remembers 20 puzzles.").waitFor();
  assert.equal(await played(page).count(), 20);
  await button(page, "Forget everything").click();
  await page.getByRole("status").filter({ hasText: "forgotten" }).waitFor();
  assert.equal(await played(page).count(), 0);
  assert.ok(await button(page, "Let it play 20").evaluate((one) => one === document.activeElement));
});

test("it pauses and goes on; another kind has its own list", async () => {
  const page = await open("learns.html", PHONE);
  await page.getByRole("radio", { name: FAST }).check();
  await button(page, "Let it play 20").click();
  await page.locator("figcaption", { hasText: "Without" }).filter({ hasText: "Ball" }).waitFor({ timeout: 120_000 });
  await button(page, "Pause").click();
  const frame = () =>
    page
      .locator("canvas")
      .last()
      .evaluate((canvas) => canvas.toDataURL());
  await button(page, "Go on").waitFor();
  const paused = await frame();
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  assert.equal(await frame(), paused);
  await button(page, "Go on").click();
  await until(page, 1);
  await page.getByRole("radio", { name: "Cradle" }).check();
  await button(page, "Let it play 20").waitFor();
  assert.equal(await played(page).count(), 0);
  await page.getByRole("radio", { name: FAST }).check();
  await until(page, 1);
  assert.ok(!(await isWide(page)));
});

test("weights that are missing are said, and asked for again", async () => {
  const page = await open("learns.html", STILL);
  await page.context().route("**/cross-0.safetensors", (route) => route.fulfill({ status: 404, body: "" }));
  await button(page, "Let it play 20").click();
  await page.getByRole("alert").getByText("The model’s weights could not be loaded: the server answered 404").waitFor();
  session.problems.splice(0);
  await page.context().unroute("**/cross-0.safetensors");
  await page.getByRole("radio", { name: FAST }).check();
  await button(page, "Let it play 20").click();
  await until(page, 1);
  assert.equal(await page.getByRole("alert").count(), 0);
});

test("the failures are those that were measured, and links; the headline names its split", async () => {
  const page = await open("results.html");
  for (const [model, agent] of [
    ["within-0", "online"],
    ["cross-0", "paper"],
  ]) {
    const { agents } = await read(`results/shipped/${model}.json`);
    const { first_solved: solved, auccess } = agents.find((one) => one.agent === agent);
    const tasks = (await load({ weights: null })).fold(model === "within-0" ? "within" : "cross", 0).test;
    await page
      .getByLabel("Model")
      .selectOption({ label: await page.locator("option", { hasText: model }).textContent() });
    await page.getByLabel("How it plays").selectOption(agent);
    await page.getByLabel("Show").selectOption("all");
    assert.deepEqual(
      await page.locator(".tasks a").allTextContents(),
      solved.map((first) => (first === null ? "×" : String(first))),
    );
    const headline = page
      .locator("div")
      .filter({ has: page.getByText("AUCCESS on this one split") })
      .last();
    assert.match(await headline.innerText(), new RegExp(`${auccess.toFixed(1)}$`));
    await page.getByLabel("Show").selectOption("failures");
    const failures = tasks.filter((_, index) => solved[index] === null).map((task) => `./#task=${task}`);
    assert.deepEqual(
      await page.locator(".tasks a").evaluateAll((all) => all.map((one) => one.getAttribute("href"))),
      failures,
    );
  }
  await page.locator(".tasks a").first().click();
  await button(page, "Drop it").waitFor();
});

test("it says which nets have learned from more than PHYRE's training tasks, as their cards do", async () => {
  const page = await open("results.html");
  const sentence = () => page.locator("strong").textContent();
  const card = async (model) => {
    const weights = await readFile(new URL(`../../assets/${model}.safetensors`, import.meta.url));
    return (await load({ weights })).card?.dynamics;
  };
  assert.ok(((await card("within-0"))?.unlisted ?? 0) > 0);
  assert.match((await sentence()) ?? "", /also from puzzles of the same kinds that PHYRE does not list/);
  assert.equal((await card("cross-0"))?.learned_from, "random_scenes");
  await page.getByLabel("Model").selectOption("1");
  assert.match((await sentence()) ?? "", /random scenes alone/);
});

test("means over ten folds stand apart, and are those of the report", async () => {
  // The page has no means over fewer folds.
  const report = (await readFile(new URL("../../results/README.md", import.meta.url), "utf8")).replaceAll(
    /[\d.]+( ± [\d.]+)? \(\d of 10 folds\)/g,
    "–",
  );
  const page = await open("results.html", { locale: "en-GB" });
  const means = page.getByRole("group", { name: "Means over all ten splits" });
  const rows = (await means.locator("tr").evaluateAll((all) => all.map((row) => row.innerText.split("\t")))).filter(
    (row) => row.length === 3 && row[0],
  );
  assert.ok(rows.length >= 5);
  for (const [name, ...auccess] of rows.filter(([name]) => !/\(20\d\d\)/.test(name)))
    assert.ok(report.includes(` | ${auccess.join(" | ")} | `), `${name}: ${auccess}`);
  const bins = await read("results/shipped/within-0-calibration.json");
  const last = page.getByRole("row", { name: "90 to 100%" });
  assert.match(await last.innerText(), new RegExp(`${bins.candidates[9].balls.toLocaleString("en")}\\t`));
});

test("the whole is saved as CSV; on a phone nothing is wider than it, and axe finds nothing", async () => {
  const page = await open("results.html", PHONE);
  const [file] = await Promise.all([page.waitForEvent("download"), button(page, "Save all as CSV").click()]);
  assert.equal(file.suggestedFilename(), "pathlight-results.csv");
  assert.match(
    await readFile(await file.path(), "utf8"),
    /^model,simulator,agents_version,agent,task,template,first_solved\r\n/,
  );
  assert.ok(!(await isWide(page)));
  await axeFindsNothingInLightAndDark(page, "results");
});

test("results that cannot be loaded are a sentence, and are asked for again", async () => {
  const page = await session.open("");
  await page.route("**/results.json", (route) => route.fulfill({ status: 503 }));
  await page.goto(`${session.origin}/results.html`);
  await page.getByRole("alert").getByText("The results could not be loaded: 503").waitFor();
  session.problems.splice(0);
  await page.unroute("**/results.json");
  await button(page, "Try again").click();
  await page.locator(".tasks a").first().waitFor();
});
