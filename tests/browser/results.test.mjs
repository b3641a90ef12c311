// The results page: all test tasks of the shipped models by template, filtered, as links and as CSV; how often the
// chances of a model come true.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { axeFindsNothing } from "./axe.mjs";
import { start } from "./harness.mjs";
import { modelLoaded } from "./page-actions.mjs";

let session;
before(async () => (session = await start({ sources: true })));
after(() => session.stop());

/** What was measured, by the evaluation's own files. */
async function measured(model, agent = "online") {
  const { agents } = JSON.parse(
    await readFile(new URL(`../../results/shipped/${model}.json`, import.meta.url), "utf8"),
  );
  return agents.find((one) => one.agent === agent);
}

const cells = (page) => page.locator("#results-templates a");

async function openResults(options = {}) {
  const page = await session.open("/", options);
  await page.locator("#results-link").click();
  await page.locator("#results-templates a").first().waitFor();
  return page;
}

test("from the grid to the failures, and to one of them as a link with the model that failed", async () => {
  const page = await openResults();
  const { first_solved: solved, auccess } = await measured("within-0");
  assert.equal(await cells(page).count(), 500);
  const failures = solved.filter(([, first]) => first === null).map(([task]) => task);
  assert.match(
    await page.locator("#results-summary").textContent(),
    new RegExp(`^${500 - failures.length} of 500 puzzles solved .+ Auccess ${auccess.toFixed(1)}`),
  );
  await page.locator("#results-filter").selectOption("failures");
  assert.deepEqual(await cells(page).evaluateAll((links) => links.map((link) => link.title.slice(0, 9))), failures);
  await cells(page).first().click();
  await page.locator("#compare:visible").waitFor();
  assert.match(page.url(), new RegExp(`task=${failures[0]}&model=within-0&panel=compare$`));
  await modelLoaded(page, "within-0");
  await page.goBack();
  await cells(page).first().waitFor();
});

test("of the other model and of another agent", async () => {
  const page = await openResults();
  await page.locator("#results-model").selectOption("cross-0");
  await page.locator("#results-agent").selectOption("paper");
  const { first_solved: solved } = await measured("cross-0", "paper");
  assert.deepEqual(
    await cells(page).evaluateAll((links) => links.map((link) => link.textContent)),
    solved.map(([, first]) => (first === null ? "×" : String(first))),
  );
  await page.locator("#results-about").filter({ hasText: "cross-0 knows 20 of the 25 kinds" }).waitFor();
  await cells(page).last().click();
  await modelLoaded(page, "cross-0");
});

test("the whole is saved as CSV", async () => {
  const page = await openResults();
  const [file] = await Promise.all([page.waitForEvent("download"), page.locator("#results-csv").click()]);
  assert.equal(file.suggestedFilename(), "pathlight-results.csv");
  const lines = (await readFile(await file.path(), "utf8")).trimEnd().split("\r\n");
  assert.equal(lines[0], "model,simulator,agents_version,agent,task,template,first_solved");
  let expected = 0;
  for (const model of ["within-0", "cross-0"]) {
    const {
      agents,
      simulator,
      agents_version: version,
    } = JSON.parse(await readFile(new URL(`../../results/shipped/${model}.json`, import.meta.url), "utf8"));
    for (const { agent, first_solved: solved } of agents) {
      expected += solved.length;
      const [task, first] = solved[7];
      const prefix = [model, simulator, version, agent, task].join(",");
      const line = lines.find((one) => one.startsWith(`${prefix},`));
      assert.match(line ?? "", new RegExp(`^${prefix},(?:[^",]+|"[^"]+"),${first ?? ""}$`));
    }
  }
  assert.equal(lines.length, 1 + expected);
});

test("published figures stand beside ours, with their source and simulator, and are those of the report", async () => {
  const report = await readFile(new URL("../../results/README.md", import.meta.url), "utf8");
  /** The auccess, within and cross, of the rows that were measured in a simulator. */
  const reported = (engine) =>
    [...report.matchAll(new RegExp(`\\| ${engine} \\| (.+) \\| (.+) \\|`, "g"))].map(([, ...auccess]) => auccess);
  const page = await openResults();
  const shown = (rows) =>
    page.locator(`#results-${rows} tr`).evaluateAll((all) => all.map((row) => row.innerText.split("\t")));
  const ours = await shown("ours");
  const [, ...otherData] = ours.shift();
  assert.ok(
    report.includes(`| **online, with proposed balls or random scenes** | ours | ${otherData.join(" | ")} |`),
    `${otherData}`,
  );
  assert.deepEqual(
    ours.map(([name]) => name.split(":")[0]),
    ["online", "dynamics", "success", "paper", "random"],
  );
  const labels = { success: "success net", paper: "the paper's four nets" };
  for (const [name, ...auccess] of ours) {
    const label = labels[name.split(":")[0]] ?? name.split(":")[0];
    assert.ok(report.includes(`| **${label}** | ours | ${auccess.join(" | ")} |`), `${name}: ${auccess}`);
  }
  const published = await shown("published");
  assert.deepEqual(
    published.map(([name]) => name),
    [
      "Ahmed et al. (2021)",
      "RPIN, Qi et al. (2021)",
      "DQN, Harter et al. (2020)",
      "Harter et al. (2020)",
      "RAND, Bakhtin et al. (2019)",
    ],
  );
  assert.deepEqual(
    published.slice(2).map(([, ...auccess]) => auccess),
    reported("PHYRE's"),
  );
  const best = await readFile(new URL("../../docs/results.md", import.meta.url), "utf8");
  assert.ok(best.includes(`${published[0][1]} within (Ahmed`) && best.includes(`${published[1][2]} cross (Qi`));
  await page.locator("tbody", { hasText: "Published, in PHYRE’s own simulator" }).waitFor();
  for (const link of await page.locator("#results-published a").all())
    assert.match((await link.getAttribute("href")) ?? "", /^https:\/\/arxiv\.org\/abs\//);
});

test("the paper's nets stand beside what was published of them, by template", async () => {
  const report = await readFile(new URL("../../results/paper/README.md", import.meta.url), "utf8");
  /** The published number and ours of each template that a setup tests. */
  const reported = (setup) => {
    const [section] = report.split(`## By template, ${setup}`)[1].split("\n## ");
    return new Map(
      [...section.matchAll(/\| \d{5} (.+?) \| (\S+) \| (\S+) \|/g)].map(([, ...row]) => [row[0], row.slice(1)]),
    );
  };
  const [within, cross] = ["within", "cross"].map(reported);
  const page = await openResults();
  await page.getByText("The paper’s nets, kind by kind").click();
  const rows = page.locator("#results-paper tbody tr");
  assert.deepEqual(
    await rows.evaluateAll((all) => all.map((row) => row.innerText.split("\t"))),
    [...within].map(([name, numbers]) => [name, ...numbers, ...(cross.get(name) ?? ["–", "–"])]),
  );
});

test("the chances are laid beside what happened, as a chart and in numbers", async () => {
  const page = await openResults();
  const bins = JSON.parse(
    await readFile(new URL("../../results/shipped/within-0-calibration.json", import.meta.url), "utf8"),
  );
  const rows = await page
    .locator("#calibration-rows tr")
    .evaluateAll((all) => all.map((row) => row.innerText.split("\t")));
  assert.equal(rows.length, 10);
  const last = bins.candidates[9];
  assert.deepEqual(rows[9].slice(3), [
    last.balls.toLocaleString("en"),
    `${((100 * last.solved) / last.balls).toFixed(1)}%`,
  ]);
  assert.ok((await page.locator("#calibration-chart rect").count()) === 10);
});

test("a link opens it; one that hides puzzles or the model does not tell of it", async () => {
  const page = await session.open("/#model=cross-0&view=results");
  await cells(page).first().waitFor();
  assert.equal(await page.locator("#results-model").inputValue(), "cross-0");
  await page.goto(`${session.origin}/#hide=compare`);
  await page.locator("#templates a").first().waitFor();
  assert.ok(await page.locator("#results-link").isHidden());
  await page.goto(`${session.origin}/#view=results&hide=imagine`);
  await page.locator("#templates a").first().waitFor();
  assert.ok(await page.locator("#results").isHidden());
});

test("results that cannot be loaded are a sentence, and are asked for again", async () => {
  const page = await session.open("/icon.svg");
  await page.route("**/results.json", (route) => route.fulfill({ status: 503 }));
  await page.goto(`${session.origin}/#model=cross-0&view=results`);
  await page
    .locator("#results-failure-words")
    .filter({ hasText: "The results could not be loaded: the server answered 503" })
    .waitFor();
  session.takeProblems();
  await page.unroute("**/results.json");
  await page.locator("#results-retry").click();
  await cells(page).first().waitFor();
  assert.equal(await page.locator("#results-model").inputValue(), "cross-0");
});

for (const [screen, options] of Object.entries({
  "a desktop, dark": { viewport: { width: 1280, height: 800 }, colorScheme: "dark" },
  "a phone": { viewport: { width: 320, height: 568 }, hasTouch: true, isMobile: true },
})) {
  test(`axe finds nothing on ${screen}, and nothing scrolls sideways`, async () => {
    const page = await openResults(options);
    await axeFindsNothing(page);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  });
}

test("a link at its top leads back to all puzzles", async () => {
  const page = await openResults();
  await page.locator("#results a.back").click();
  await page.locator("#templates").waitFor();
  assert.ok(await page.locator("#results").isHidden());
});
