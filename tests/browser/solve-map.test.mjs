// Where a ball of this radius solves the puzzle: searched in the worker, with progress and an end at any time.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { painted, start } from "./harness.mjs";
import { known, modelLoaded, openPanel, openPuzzle, pause, picture, pressDuring } from "./page-actions.mjs";

let session;
before(async () => (session = await start({ sources: true })));
after(() => session.stop());

const words = (page) => page.locator("#solve-map-words");
const search = (page) => page.locator("#solve-map-search");

test("the map grows, and ends when it is told to", async () => {
  const page = await openPuzzle(session, { fragment: "&panel=map" });
  const bare = await picture(page);
  const stopped = pressDuring(page, "#solve-map-search", "#solve-map-words", { after: 8 });
  await search(page).click();
  const said = await stopped;
  for (const sentence of said)
    assert.match(sentence, /^\d+% tried so far: (about \d+|less than 1)% of the places solve it with radius 12/);
  const shares = said.map((sentence) => parseInt(sentence, 10));
  // A sentence about the placement map may come without more that has been tried.
  assert.deepEqual(
    shares,
    shares.toSorted((a, b) => a - b),
  );
  assert.ok(shares[7] > shares[0], said.join("\n"));
  await search(page).filter({ hasText: "Try every place" }).waitFor();
  await painted(page);
  assert.notEqual(await picture(page), bare, "what is known is in the scene");
  // What is said of the placement map may come later.
  const found = async () => ((await words(page).textContent()) ?? "").split(" The model")[0];
  const last = await found();
  await pause(page, 400);
  assert.equal(await found(), last);
});

test("it says of a ball what its simulation says", async () => {
  const page = await openPuzzle(session);
  const { solving } = await known();
  const outcomes = await page.evaluate(async (r) => {
    const { Game, SolveMap } = await import("/pkg/pathlight.js");
    const map = new SolveMap("00000:000", r);
    // The coarsest round: every eighth place.
    for (let place = 0; place < 64; place += 1) map.advance();
    const picture = map.outcomes();
    const game = new Game("00000:000");
    const wrong = [];
    for (let row = 0; row < 64; row += 8) {
      for (let column = 0; column < 64; column += 8) {
        const [x, y] = [column * 4 + 2, row * 4 + 2];
        const expected = game.whyInvalid(x, y, r) ? 1 : game.attempt(x, y, r).ending.solved ? 3 : 2;
        if (picture[row * 64 + column] !== expected) wrong.push([x, y]);
      }
    }
    return { wrong, kinds: new Set(picture).size };
  }, solving[2]);
  assert.deepEqual(outcomes.wrong, []);
  assert.ok(outcomes.kinds >= 2);
});

test("every place is tried in the end, for the ball’s own radius, and the placement map lies over it", async () => {
  // Few places are free for the largest ball, so that this takes little time.
  const page = await openPuzzle(session, { fragment: "&panel=predict&ball=128,200,32" });
  const bare = await picture(page);
  await openPanel(page, "map");
  assert.equal(await search(page).textContent(), "Try every place with radius 32");
  await search(page).click();
  await words(page)
    .filter({
      hasText: /^Every place tried: .+ of the places solve it with radius 32, and \d+% have no room for a ball\./,
    })
    .waitFor({ timeout: 120_000 });
  await page.locator("#solve-map-progress").waitFor({ state: "hidden" });
  const alone = await picture(page);
  await page.locator("#solve-map-placement").check();
  await page.waitForFunction(() => /layers=placement/.test(location.hash));
  assert.notEqual(await picture(page), alone);
  const lying = await picture(page);
  await openPanel(page, "predict");
  await page.locator("#solve-map-placement").waitFor({ state: "hidden" });
  assert.equal(await picture(page), bare, "in Predict neither map tells the answer");
  await openPanel(page, "map");
  await page.locator("#solve-map-placement").waitFor();
  assert.equal(await picture(page), lying);
  await page.locator("#tab-play").click();
  await page.locator("#solve-map-placement").waitFor({ state: "hidden" });
});

test("a key starts it; another puzzle ends it", async () => {
  const page = await openPuzzle(session, { fragment: "&panel=map" });
  await search(page).focus();
  await page.keyboard.press("Enter");
  await words(page).filter({ hasText: /tried/ }).waitFor();
  await page.locator("#next").click();
  await search(page).filter({ hasText: "Try every place" }).waitFor();
  assert.equal(await words(page).textContent(), "");
});

test("a search that is stopped and started again at once goes to its end", async () => {
  const page = await openPuzzle(session, { fragment: "&panel=map&ball=128,200,32" });
  const pressed = pressDuring(page, "#solve-map-search", "#solve-map-words", { after: 1, times: 2 });
  await search(page).click();
  await pressed;
  await words(page).filter({ hasText: "Every place tried" }).waitFor({ timeout: 120_000 });
});

test("a link that hides what the model imagines is not told of it", async () => {
  const page = await openPuzzle(session, { fragment: "&panel=map&hide=imagine" });
  await modelLoaded(page);
  await search(page).click();
  await words(page).filter({ hasText: "Every place tried" }).waitFor({ timeout: 120_000 });
  assert.doesNotMatch((await words(page).textContent()) ?? "", /model/);
});
