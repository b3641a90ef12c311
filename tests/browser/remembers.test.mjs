// "The model remembers": what person and model try at one puzzle helps the model at the next, it says so, and forgets
// at a press. Challenges, lessons and the model's balls one by one are as without.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { TEMPLATES } from "../../www/pkg/constants.js";
import { axeFindsNothingInLightAndDark } from "./axe.mjs";
import { start } from "./harness.mjs";
import {
  EASY,
  becomeRegular,
  focused,
  known,
  modelLoaded,
  openPanel,
  openPuzzle,
  openShare,
  playModelTurn,
  says,
  type,
} from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true };
/** Two puzzles of a kind that is new to this model: the one that is solved first helps at the other. */
const [FIRST, SECOND] = ["00015:134", "00015:154"];
const MODEL = "&model=cross-0";
/** Two puzzles of a kind of which the second is like the first mirrored. */
const [LEFT, RIGHT] = ["00014:183", "00014:191"];
const MEMORY = "pathlight.memory.cross-0";

const remembers = (page) => page.locator("#remembers-on");
const forget = (page) => page.locator("#remembers-forget");
const words = (page, text) => page.locator("#remembers-words").filter({ hasText: text }).waitFor();
const source = (page) => page.locator("#race-source");
const model = (page) => page.locator("#race-model");
/** The place of a task among those of its kind. */
const placeOf = (task) => 1 + (TEMPLATES.find(({ tasks }) => tasks.includes(task))?.tasks.indexOf(task) ?? NaN);

/** Opens a puzzle, without motion, and waits for the model. */
async function open(task = FIRST, options = {}) {
  const page = await openPuzzle(session, { task, fragment: MODEL, reducedMotion: true, ...options });
  await modelLoaded(page);
  return page;
}

/** Goes to another puzzle, as by a link. */
async function goTo(page, task, fragment = MODEL) {
  await page.goto(`${session.origin}/#task=${task}${fragment}`);
  await page.locator("#task").waitFor();
  await modelLoaded(page);
}

/** The balls that have been looked for. */
const balls = new Map();

/** The person drops a ball that solves the open puzzle. */
async function solve(page, task) {
  if (!balls.has(task)) balls.set(task, (await known(task)).solving);
  await type(page, balls.get(task));
  await page.locator("#run").click();
  await says(page, /^Solved!/);
}

/** The person solves a puzzle, then the model plays it. Returns how the model did. */
async function raced(page, task) {
  await solve(page, task);
  await page.locator("#race-it:enabled").click();
  await page.locator("#race-it").filter({ hasText: "Watch it again" }).waitFor({ timeout: 120_000 });
  return model(page).textContent();
}

/** What a browser has stored. */
function stored(entries) {
  const localStorage = Object.entries(entries).map(([name, value]) => ({ name, value }));
  return { cookies: [], origins: [{ origin: session.origin, localStorage }] };
}

/** The number of the attempt that solved. */
const attemptOf = (told) => Number(/^✓ on attempt (\d+)$/.exec(told)?.[1]);

test("what the person solves helps the model at the next puzzle of the kind; forgotten, it plays as before", async () => {
  const page = await open(SECOND);
  assert.ok(!(await remembers(page).isChecked()), "it is off at first");
  const without = attemptOf(await raced(page, SECOND));
  assert.equal(await source(page).textContent(), "");
  await remembers(page).check();
  await words(page, /^It remembers nothing yet\./);
  assert.equal(await model(page).textContent(), "?", "it plays anew");
  await goTo(page, FIRST);
  await solve(page, FIRST);
  await words(page, "It remembers 1 puzzle.");
  await goTo(page, SECOND);
  await page.locator("#race-it:enabled").click();
  await source(page).filter({ hasText: /./ }).waitFor({ timeout: 120_000 });
  const told = await model(page).textContent();
  assert.ok(attemptOf(told) < without, `${told}, and on attempt ${without} without`);
  assert.equal(await source(page).textContent(), `It learned this from Cradle ${placeOf(FIRST)}.`);
  await words(page, "It remembers 2 puzzles.");
  await page
    .locator("#announcement")
    .filter({ hasText: /solved.*It learned this from Cradle/s })
    .waitFor({ state: "attached" });
  await axeFindsNothingInLightAndDark(page, "it has remembered");

  // A reload keeps what it remembers; what was tried at this puzzle itself does not count here.
  await page.reload();
  await words(page, "It remembers 2 puzzles.");
  assert.ok(await remembers(page).isChecked());
  await page.locator("#race-it:enabled").click();
  await source(page).filter({ hasText: /./ }).waitFor({ timeout: 120_000 });
  assert.equal(await model(page).textContent(), told);
  await source(page).locator("a").click();
  await page.waitForURL(new RegExp(`task=${FIRST}${MODEL}$`));

  await forget(page).click();
  await words(page, /^It remembers nothing yet\./);
  assert.ok(await forget(page).isHidden());
  assert.equal(await (await focused(page)).getAttribute("id"), "remembers-on", "the focus is not lost");
  assert.equal(await page.evaluate((key) => localStorage.getItem(key), MEMORY), null);
  await remembers(page).uncheck();
  await goTo(page, SECOND);
  assert.equal(attemptOf(await model(page).textContent()), without, "the turn without memory is still there");
});

test("both teach it, also by a puzzle that is the other way round", async () => {
  const page = await open(LEFT);
  await remembers(page).check();
  await type(page, (await known(LEFT)).missing);
  await page.locator("#run").click();
  await says(page, /^Not solved/);
  await words(page, "It remembers 1 puzzle.");
  await page.locator("#reset").click();
  await raced(page, LEFT);
  const [{ attempts: both }] = await page.evaluate((key) => JSON.parse(localStorage[key]).puzzles, MEMORY);
  const of = async (author) => Number(await page.locator(`#${author}-attempts li`).count());
  assert.equal(both.length, (await of("play")) + (await of("model")));
  assert.equal(both.filter(({ solved }) => solved).length, 2);
  await goTo(page, RIGHT);
  await raced(page, RIGHT);
  assert.equal(await source(page).textContent(), `It learned this from Over the Divide ${placeOf(LEFT)} (mirrored).`);
});

test("each model remembers for itself, and what it is shown beside is without", async () => {
  const page = await open(EASY, { fragment: "" });
  await remembers(page).check();
  await raced(page, EASY);
  await words(page, "It remembers 1 puzzle.");
  assert.ok(await page.locator("#score").isHidden(), "its score is that of its turns without memory");
  await openPanel(page, "compare");
  await page.locator("#proposals-afresh:visible").waitFor();
  await openShare(page);
  const shared = page.locator("#share-text");
  await shared.filter({ hasText: /The model, with its memory, needed (one attempt|\d+ attempts)\./ }).waitFor();
  await page.keyboard.press("Escape");
  await goTo(page, EASY);
  await words(page, /^It remembers nothing yet\./);
  await goTo(page, EASY, "");
  await words(page, "It remembers 1 puzzle.");
  await remembers(page).uncheck();
  assert.equal(await page.locator("#remembers-words").textContent(), "");
  await openPanel(page, "compare");
  assert.ok(await page.locator("#proposals-afresh").isHidden());
});

test("a custom puzzle is remembered by its name", async () => {
  const page = await open(FIRST);
  await remembers(page).check();
  await page.locator("#tab-make").click();
  await page.locator("#make-name").fill("My slide");
  await page.locator("#make-name").press("Tab");
  await page.waitForURL(/#scene=/);
  await page.locator("#tab-play").click();
  await modelLoaded(page);
  await solve(page, FIRST);
  await words(page, "It remembers 1 puzzle.");
  await goTo(page, SECOND);
  await raced(page, SECOND);
  assert.equal(await source(page).textContent(), "It learned this from “My slide”.");
  assert.equal(await source(page).locator("a").count(), 0);
  await words(page, "It remembers 2 puzzles.");
});

test("in a challenge or a lesson it plays without memory, unless the person asks for it there", async () => {
  const page = await open(FIRST);
  await remembers(page).check();
  await solve(page, FIRST);
  await words(page, "It remembers 1 puzzle.");
  for (const link of ["&challenge=3", "&hide=hint"]) {
    await goTo(page, SECOND, MODEL + link);
    assert.ok(!(await remembers(page).isChecked()), link);
    assert.equal(await page.locator("#remembers-words").textContent(), "");
  }
  await goTo(page, SECOND, `${MODEL}&challenge=3`);
  const without = attemptOf(await raced(page, SECOND));
  assert.equal(await source(page).textContent(), "");
  await remembers(page).check();
  await words(page, "It remembers 1 puzzle.");
  await page.locator("#race-it:enabled").click();
  await source(page).filter({ hasText: /./ }).waitFor({ timeout: 120_000 });
  assert.ok(attemptOf(await model(page).textContent()) < without);
  await goTo(page, SECOND, `${MODEL}&challenge=4`);
  assert.ok(!(await remembers(page).isChecked()), "another challenge begins without");
  await goTo(page, SECOND);
  assert.ok(await remembers(page).isChecked(), "elsewhere it is as it was");
});

test("what is damaged or of other weights is forgotten, with a word, and it goes on", async () => {
  const entry = { key: FIRST, task: FIRST, attempts: [{ ball: [132, 226, 24], chance: 0.02, solved: true }] };
  const whole = { version: 1, weights: "0".repeat(64), forgotten: 0, puzzles: [entry] };
  for (const damaged of [
    "{",
    "null",
    '{"puzzles":[1]}',
    JSON.stringify(whole),
    JSON.stringify({ ...whole, version: 9 }),
  ]) {
    const page = await open(SECOND, { storageState: stored({ [MEMORY]: damaged, "pathlight.remembers": "on" }) });
    await solve(page, SECOND);
    await words(
      page,
      /^Its memory was damaged or from another version, so it starts again with an empty one\. It remembers 1 puzzle\.$/,
    );
    await page.reload();
    await words(page, /^It remembers 1 puzzle\.$/);
    await page.context().close();
  }
  const page = await open(SECOND, {
    fragment: `${MODEL}&panel=compare`,
    storageState: stored({ [MEMORY]: JSON.stringify(whole), "pathlight.remembers": "on" }),
  });
  await playModelTurn(page);
  await words(page, /with an empty one\. It remembers 1 puzzle\.$/);
});

test("in a browser that keeps nothing it remembers as long as the page is open", async () => {
  const page = await session.open("", { reducedMotion: "reduce" });
  await page.addInitScript(becomeRegular);
  await page.addInitScript(() => {
    Storage.prototype.setItem = () => {
      throw new DOMException("full", "QuotaExceededError");
    };
  });
  await page.goto(`${session.origin}/#task=${FIRST}${MODEL}`);
  await modelLoaded(page);
  await remembers(page).check();
  await solve(page, FIRST);
  await words(page, "It remembers 1 puzzle.");
  await page.evaluate((task) => (location.hash = location.hash.replace(/task=[^&]+/, `task=${task}`)), SECOND);
  await raced(page, SECOND);
  assert.match(await source(page).textContent(), /^It learned this from Cradle/);
});

test("by keyboard and by touch on a phone, in German too", async () => {
  const page = await openPuzzle(session, { task: FIRST, fragment: MODEL, reducedMotion: true, ...PHONE, locale: "de" });
  await page.locator("#race-verdict").filter({ hasText: "Du zuerst" }).waitFor();
  await remembers(page).tap();
  await words(page, /^Noch erinnert es sich an nichts\./);
  await page.keyboard.press("Space");
  assert.ok(!(await remembers(page).isChecked()));
  await page.keyboard.press("Space");
  await type(page, (await known(FIRST)).solving);
  await page.locator("#run").tap();
  await words(page, "Es erinnert sich an 1 Rätsel.");
  const out = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.equal(out, 0, "nothing sticks out");
  await axeFindsNothingInLightAndDark(page, "on a phone");
  await remembers(page).focus();
  await page.keyboard.press("Tab");
  assert.equal(await (await focused(page)).textContent(), "Vergessen");
  await page.keyboard.press("Enter");
  await words(page, /^Noch erinnert es sich an nichts\./);
  await page.locator("#announcement").filter({ hasText: "Es hat alles vergessen." }).waitFor({ state: "attached" });
});

test("another tab forgets too, and so does all progress", async () => {
  const page = await open(FIRST);
  await remembers(page).check();
  await solve(page, FIRST);
  await words(page, "It remembers 1 puzzle.");
  const other = await session.openIn(page.context(), `/#task=${SECOND}${MODEL}`);
  await words(other, "It remembers 1 puzzle.");
  await forget(other).click();
  await words(page, /^It remembers nothing yet\./);
  await type(page, (await known(FIRST)).missing);
  await page.locator("#run").click();
  await words(page, "It remembers 1 puzzle.");
  await page.locator("#home").click();
  await page.locator("#progress-forget").click();
  await page.locator("#forget-dialog [value=forget]").click();
  assert.equal(await page.evaluate((key) => localStorage.getItem(key), MEMORY), null);
});
