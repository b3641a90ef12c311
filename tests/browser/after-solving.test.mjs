// After solving: a celebration, the next puzzle, the model's turn, and a result to share, which challenges others
// without telling the ball.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { axeFindsNothing } from "./axe.mjs";
import { start } from "./harness.mjs";
import {
  EASY,
  inMore,
  known,
  modelLoaded,
  openPanel,
  openPuzzle,
  openShare,
  pause,
  playModelTurn,
  says,
  type,
} from "./page-actions.mjs";
import { load } from "../../www/api/index.js";

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

let session;
before(async () => (session = await start({ sources: true })));
after(() => session.stop());

/** What the celebration shows when it begins; it is over after some seconds. */
const celebrated = (page) =>
  page.locator("#celebration").evaluate(
    (celebration) =>
      new Promise((resolve) =>
        new MutationObserver(() => {
          const [first] = celebration.children;
          const [areSeen, animations] = [first.checkVisibility(), first.getAnimations().length];
          resolve({ sparks: celebration.children.length, areSeen, animations });
        }).observe(celebration, { attributeFilter: ["hidden"] }),
      ),
  );

/**
 * A puzzle that has just been solved at the second attempt.
 * @param {object} [options]
 * @param {(page: import("playwright-core").Page) => void} [before] gets the page before the first attempt
 */
async function solved(options = {}, before) {
  const page = await openPuzzle(session, { reducedMotion: true, ...options });
  before?.(page);
  const { solving, missing } = await known();
  for (const [ball, words] of /** @type {const} */ ([
    [missing, /^Not solved/],
    [solving, /^Solved!/],
  ])) {
    await type(page, ball);
    await page.locator("#run").click();
    await says(page, words);
  }
  return { page, solving };
}

const task = (page) => new URLSearchParams(new URL(page.url()).hash.slice(1)).get("task");
const unsolved = (page) => page.locator("#solved").isHidden();

test("a solved puzzle is celebrated, and motionless with reduced motion", async () => {
  let celebrations;
  const { page } = await solved({}, (page) => (celebrations = celebrated(page)));
  const { sparks, areSeen, animations } = await celebrations;
  assert.ok(sparks > 10 && areSeen);
  assert.equal(animations, 0);
  await page.locator("#celebration").waitFor({ state: "hidden" });
  assert.equal(await page.locator("#solved-title").textContent(), "Solved in 2 attempts!");

  const moving = await openPuzzle(session);
  assert.ok(await unsolved(moving));
  await type(moving, (await known()).solving);
  await moving.locator("#speed").selectOption("0.25");
  const celebration = celebrated(moving);
  await moving.locator("#run").click();
  await says(moving, /is running/);
  assert.ok(await unsolved(moving), "nothing is told before it has run");
  await moving.locator("#speed").selectOption("4");
  await says(moving, /^Solved!/);
  assert.equal((await celebration).animations, 1);
});

for (const [width, height] of [
  [390, 844],
  [1280, 800],
])
  for (const reducedMotion of [true, false])
    test(`nothing of the celebration lies over the picture at ${width} x ${height}${reducedMotion ? ", motionless" : ""}`, async () => {
      const page = await openPuzzle(session, { viewport: { width, height }, reducedMotion });
      await type(page, (await known()).solving);
      await page.locator("#run").click();
      if (!reducedMotion) await page.locator("#time").press("End");
      await says(page, /^Solved!/);
      const scene = await page.locator("#scene").boundingBox();
      const sparks = await page.locator("#celebration").evaluate((celebration) => {
        // On a slow machine it may be over.
        celebration.hidden = false;
        const { left, top } = celebration.getBoundingClientRect();
        return { left, top, overflow: getComputedStyle(celebration).overflow };
      });
      assert.ok(sparks.top > scene.y + scene.height || sparks.left > scene.x + scene.width);
      assert.equal(sparks.overflow, "hidden");
    });

test("the next puzzle is of the same kind, or a little harder or easier", async () => {
  const { page } = await solved();
  const pathlight = await load({ weights: null });
  const rate = (task) => pathlight.difficulty(task).solve_rate;
  const next = page.locator("#solved-next");
  assert.equal(await next.getAttribute("href"), "#task=00000:001");
  for (const [by, fits] of /** @type {const} */ ([
    ["harder", (other) => rate(other) < rate(EASY)],
    ["easier", (other) => rate(other) > rate(EASY)],
  ])) {
    await page.locator("#next-by").selectOption(by);
    const other = (await next.getAttribute("href")).slice("#task=".length);
    assert.ok(fits(other), `${by}: ${rate(other)} after ${rate(EASY)}`);
    assert.notEqual(other.split(":")[0], EASY.split(":")[0], "of another kind");
  }
  const other = (await next.getAttribute("href")).slice("#task=".length);
  await next.click();
  await says(page, /place the red ball/);
  assert.equal(task(page), other);
  assert.ok(await unsolved(page));
});

test("the model’s turn is one click away", async () => {
  const { page } = await solved();
  await modelLoaded(page);
  await page.locator("#race-it").click();
  await page
    .locator("#race-verdict")
    .filter({ hasText: /^(You|The model) .*solved it/ })
    .waitFor({ timeout: 60_000 });
  assert.equal(await page.locator("#tab-play").getAttribute("aria-selected"), "true");
});

test("a link that hides the puzzles and the model leads to neither", async () => {
  const { page } = await solved({ fragment: "&hide=puzzles,imagine,compare,predict,map" });
  for (const id of ["solved-next", "race-it", "solved-share", "next-by"])
    assert.ok(await page.locator(`#${id}`).isHidden(), id);
});

test("whoever solved it at the first attempt asks who can match it", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  const { solving } = await known();
  await type(page, solving);
  await page.locator("#run").click();
  await says(page, /^Solved!/);
  await page.locator("#solved-share").click();
  await page.locator("#share-text", { hasText: /at the first attempt\. Can you match it\?$/ }).waitFor();
});

test("whoever clears misses has not solved it any earlier: title, race, picker, text and challenge agree", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  const { solving, missing } = await known();
  const drop = async (ball, words) => {
    await type(page, ball);
    await page.locator("#run").click();
    await says(page, words);
  };
  await drop(missing, /^Not solved/);
  await inMore(page, () => page.locator("#clear-attempts").click());
  await drop(solving, /^Solved!/);
  assert.equal(await page.locator("#solved-title").textContent(), "Solved in 2 attempts!");
  assert.equal(await page.locator("#play-count").textContent(), "solved on attempt 2");
  assert.equal(await page.locator("#race-player").textContent(), "✓ on attempt 2");
  assert.match(await page.locator("#task option:checked").textContent(), /solved at try 2$/);
  await page.locator("#solved-share").click();
  await page.locator("#share-text", { hasText: /in 2 attempts\. Can you do better\?$/ }).waitFor();
  await page.locator("#share-ball").check();
  await page.evaluate(() =>
    Object.assign(navigator.clipboard, { writeText: async (words) => Object.assign(window, { copied: words }) }),
  );
  await page.locator("#share-copy").click();
  await page.locator("#share-done").filter({ hasText: "copied" }).waitFor();
  assert.match(await page.evaluate(() => /** @type {any} */ (window).copied), /&challenge=2$/);
});

test("a sheet that cannot be loaded is a sentence, and is asked for again", async () => {
  const { page } = await solved();
  await page.route("**/share-dialog.js", (route) => route.abort());
  await page.locator("#solved-share").click();
  await page.locator("#notice-text").filter({ hasText: "The sheet to share a puzzle could not be loaded." }).waitFor();
  session.takeProblems();
});

test("a puzzle that is not solved is shared as a question, and its run as a film", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  await openShare(page);
  assert.equal(await page.locator("#share-text").textContent(), "“Two Drops, 1 of 100”: can you solve it?");
  assert.ok(await page.locator("#share-film").isHidden(), "nothing has run");
  await page.locator("#share-dialog form button").click();
  await type(page, (await known()).missing);
  await page.locator("#run").click();
  await says(page, /^Not solved/);
  await openShare(page);
  await page.locator("#share-film").click();
  const [film] = await Promise.all([
    page.waitForEvent("download", { timeout: 60_000 }),
    page.locator("#share-save").filter({ hasText: "Save the film" }).click({ timeout: 60_000 }),
  ]);
  assert.equal(film.suggestedFilename(), "pathlight-00000-000.webm");
  await page.locator("#lesson-button").click();
  await page.locator("#lesson-dialog[open]").waitFor();
  assert.ok(await page.locator("#share-dialog").isHidden());
});

for (const [screen, options] of Object.entries({ "a desktop": {}, "a phone": PHONE })) {
  test(`a result is shared as picture, text and challenge on ${screen}`, async () => {
    const { page, solving } = await solved({ ...options, permissions: ["clipboard-read", "clipboard-write"] });
    await page.locator("#solved-share").focus();
    await page.keyboard.press("Enter");
    await page.locator("#share-dialog[open]").waitFor();
    assert.equal(
      await page.locator("#share-text").textContent(),
      "I solved Pathlight’s puzzle “Two Drops, 1 of 100” in 2 attempts. Can you do better?",
    );
    assert.equal(await page.locator("#share-dialog button.primary:visible").count(), 1);
    const picture = page.locator("#share-picture");
    await page.waitForFunction(
      () => /** @type {HTMLImageElement} */ (document.getElementById("share-picture")).naturalWidth === 1200,
    );
    assert.match(await picture.getAttribute("alt"), /^Two Drops, 1 of 100\. Solved in 2 attempts/);
    const without = await picture.getAttribute("src");
    await page.locator("#share-ball").check();
    await page.waitForFunction((src) => document.querySelector("#share-picture")?.getAttribute("src") !== src, without);
    await axeFindsNothing(page);

    const [file] = await Promise.all([page.waitForEvent("download"), page.locator("#share-save").click()]);
    assert.equal(file.suggestedFilename(), "pathlight-00000-000.png");
    const bytes = await readFile(await file.path());
    assert.deepEqual([bytes.readUInt32BE(16), bytes.readUInt32BE(20)], [1200, 630]);

    await page.locator("#share-copy").click();
    await page.locator("#share-done").filter({ hasText: "copied" }).waitFor();
    const text = await page.evaluate(() => navigator.clipboard.readText());
    const link = text.split("\n").at(-1);
    assert.equal(new URL(link).hash, `#task=${EASY}&challenge=2`, "the ball is not told");

    const friend = await session.open(link.slice(session.origin.length), { reducedMotion: "reduce" });
    await friend
      .locator("#challenge")
      .filter({ hasText: "A challenge: somebody solved this puzzle in 2 attempts. Can you?" })
      .waitFor();
    await type(friend, solving);
    await friend.locator("#run").click();
    await friend.locator("#challenge").filter({ hasText: "You have beaten the challenge" }).waitFor();
    await friend.locator("#next").click();
    await friend.locator("#challenge").waitFor({ state: "hidden" });
  });
}

test("while the model plays, the person's result is told, and not the model's", async () => {
  const page = await openPuzzle(session);
  await type(page, (await known()).solving);
  await page.locator("#speed").selectOption("4");
  await page.locator("#run").click();
  await says(page, /^Solved!/);
  await page.locator("#speed").selectOption("0.25");
  await openPanel(page, "compare");
  await page.locator("#model-turn:enabled").click();
  await says(page, /(The model|Attempt \d+ of the model)/);
  await openShare(page);
  const words = await page.locator("#share-text").textContent();
  assert.match(words, /I solved/);
  assert.doesNotMatch(words, /model/i);
});

test("once the model has solved it too, the picture shows both paths", async () => {
  const { page } = await solved();
  /** The pixels of the scene in the picture that shows the ball. */
  const sceneWithBall = async () => {
    await page.locator("#solved-share").click();
    await page.locator("#share-dialog[open]").waitFor();
    const picture = page.locator("#share-picture");
    const without = await picture.getAttribute("src");
    await page.locator("#share-ball").check();
    await page.waitForFunction((src) => document.querySelector("#share-picture")?.getAttribute("src") !== src, without);
    return picture.evaluate(async (/** @type {HTMLImageElement} */ image) => {
      await image.decode();
      const context = new OffscreenCanvas(630, 630).getContext("2d");
      context?.drawImage(image, 0, 0);
      return String(context?.getImageData(0, 0, 630, 630).data);
    });
  };
  const words = page.locator("#share-ball-words");
  const alone = await sceneWithBall();
  assert.equal(await words.textContent(), "Show my ball in the picture");
  await page.locator("#share-dialog form button").click();
  await openPanel(page, "compare");
  await playModelTurn(page);
  assert.notEqual(await sceneWithBall(), alone);
  assert.equal(await words.textContent(), "Show my path and the model’s in the picture");
  assert.match(await page.locator("#share-picture").getAttribute("alt"), /The model needed .+\. Its path is dashed\.$/);
});

test("the result is a short film too, with the run in the card, which is saved and shared like the picture", async () => {
  const { page } = await solved();
  await page.evaluate(() =>
    Object.assign(navigator, { canShare: () => true, share: async (data) => Object.assign(window, { shared: data }) }),
  );
  await page.locator("#solved-share").click();
  const film = page.locator("#share-film");
  const done = (words) => page.locator("#share-done").filter({ hasText: words }).waitFor();
  await film.click();
  // The run moves in the card while it is recorded; its words stay.
  const card = page.locator("#share-dialog canvas");
  const seen = await card.evaluate(async (canvas) => {
    const context = /** @type {HTMLCanvasElement} */ (canvas).getContext("2d");
    const part = (x, width) => context?.getImageData(x, 0, width, 420).data.join();
    const [scene, words] = [part(0, 400), part(410, 390)];
    while (canvas.isConnected && part(0, 400) === scene) await new Promise(requestAnimationFrame);
    return { moves: part(0, 400) !== scene, stays: part(410, 390) === words };
  });
  assert.deepEqual(seen, { moves: true, stays: true });
  await done("The film is ready");
  assert.equal(await card.count(), 0);
  const [file] = await Promise.all([
    page.waitForEvent("download"),
    page.locator("#share-save").filter({ hasText: "Save the film" }).click(),
  ]);
  assert.equal(file.suggestedFilename(), "pathlight-00000-000.webm");
  const bytes = await readFile(await file.path());
  assert.equal(bytes.readUInt32BE(0), 0x1a45dfa3, "it begins as Matroska does");
  assert.ok(bytes.length > 20_000, `${bytes.length} bytes`);
  await page.locator("#share-system").click();
  assert.equal(await page.evaluate(() => /** @type {any} */ (window).shared.files[0].type), "video/webm");

  // With another picture, that is what is shared again; a film that is given up changes nothing.
  await page.locator("#share-ball").check();
  await page.locator("#share-save").filter({ hasText: "Save the picture" }).waitFor();
  await film.click();
  await page.locator("#share-progress:visible").waitFor();
  await film.filter({ hasText: "Stop" }).click();
  await done("film was stopped");
  await page.evaluate(
    () =>
      (MediaRecorder.prototype.start = () => {
        throw new DOMException("no encoder", "NotSupportedError");
      }),
  );
  await film.click();
  await done("could not record");
  assert.ok(await page.locator("#share-save").filter({ hasText: "Save the picture" }).isVisible());
});

test("where there is a share sheet, picture, text and link go to it", async () => {
  const page = await session.open("");
  await page.addInitScript(() => {
    Object.assign(navigator, { canShare: () => true, share: async (data) => Object.assign(window, { shared: data }) });
  });
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.goto(`${session.origin}/#task=${EASY}`);
  await type(page, (await known()).solving);
  await page.locator("#run").click();
  await page.locator("#solved-share").click();
  await page.locator("#share-system").click();
  const shared = await page.evaluate(() => {
    const {
      files: [{ name, type, size }],
      text,
      url,
    } = /** @type {any} */ (window).shared;
    return { name, type, size, text, url };
  });
  assert.equal(shared.name, "pathlight-00000-000.png");
  assert.ok(shared.type === "image/png" && shared.size > 5000);
  assert.match(shared.text, /at the first attempt/);
  assert.match(shared.url, /#task=00000:000&challenge=1$/);
});

test("a card of the home page leads to a puzzle that the model does not solve, and to another once that is solved", async () => {
  const { agents } = JSON.parse(
    await readFile(new URL("../../results/shipped/within-0.json", import.meta.url), "utf8"),
  );
  const unsolvedTasks = agents
    .find(({ agent }) => agent === "online")
    .first_solved.filter(([, attempt]) => attempt === null)
    .map(([task]) => task);
  const page = await session.open("/", { reducedMotion: "reduce" });
  const stump = page.locator("[data-pick=unsolved] a:visible");
  await stump.focus();
  await page.keyboard.press("Enter");
  await says(page, /place the red ball/);
  const first = task(page);
  assert.ok(unsolvedTasks.includes(first), String(first));
  await page.evaluate(
    (first) =>
      localStorage.setItem("pathlight.progress", JSON.stringify({ tasks: { [first]: { attempts: 1, solved: 1 } } })),
    first,
  );
  await page.goto(`${session.origin}/`);
  await page.reload();
  await stump.click();
  await says(page, /place the red ball/);
  assert.ok(unsolvedTasks.includes(task(page)) && task(page) !== first);
});

test("the puzzle of the day depends on the date alone, and its result is a text of marks", async () => {
  const picks = new Set();
  for (const date of ["2026-11-22T00:10", "2026-11-22T23:50", "2026-11-23T12:00"]) {
    const context = await session.browser.newContext({ reducedMotion: "reduce" });
    await context.clock.setFixedTime(new Date(date));
    const page = await session.openIn(context);
    picks.add(await page.locator("[data-pick=day] a:visible").getAttribute("href"));
    assert.match(
      await page.locator("[data-pick=day] a:visible").textContent(),
      /^Puzzle of the day2[23] November 2026: .+, \d+ of 100, (easy|medium)$/,
    );
  }
  assert.equal(picks.size, 2, "one for each day");

  const context = await session.browser.newContext({ reducedMotion: "reduce" });
  await context.clock.setFixedTime(new Date("2026-11-22T12:00"));
  const page = await session.openIn(context);
  await page.locator("[data-pick=day] a:visible").click();
  await says(page, /place the red ball/);
  const solutions = (await readFile(new URL("../../assets/solutions.jsonl", import.meta.url), "utf8")).split("\n");
  const { balls } = JSON.parse(solutions.find((line) => line.includes(`"${task(page)}"`)) ?? "null");
  await type(page, balls[0]);
  await page.locator("#run").click();
  await page.locator("#solved-share").click();
  await page.locator("#share-dialog[open]").waitFor();
  assert.match(await page.locator("#share-text").textContent(), /^Pathlight, 22 November 2026: .+, \d+ of 100\n🟢$/);
});

test("a sheet that comes when the next puzzle is open stays away", async () => {
  const { page } = await solved();
  let open = () => {};
  const gate = new Promise((resolve) => (open = () => resolve(null)));
  await page.route("**/share-dialog.js", (route) => gate.then(() => route.continue()));
  const loaded = page.waitForResponse("**/share-dialog.js").then((response) => response.finished());
  await page.locator("#solved-share").click();
  await page.locator("#next").click();
  await says(page, /place the red ball/);
  open();
  await loaded;
  await pause(page);
  assert.equal(await page.locator("#share-dialog[open]").count(), 0);
});

test("a link that hides what is told of the model has no puzzle that stumps it", async () => {
  const page = await session.open("/#hide=imagine,compare");
  await page.locator("[data-pick=day] a:visible").waitFor();
  assert.ok(await page.locator("[data-pick=unsolved]").isHidden());
});
