// What the page says of puzzles that the model played with a memory and without, and when it shows which try.

import assert from "node:assert/strict";
import { afterEach, test } from "node:test";
import { useLanguage } from "../../www/text/text.js";
import { playedWords, runningMeans, shownTries, totalWords } from "../../www/page/learns-words.js";

const FIRST = "00015:014";
const SECOND = "00015:016";
/** @type {import("../../www/pkg/pathlight.js").Reminder} */
const reminder = { puzzle: 1, task: FIRST, change: 2, ball: [1, 2, 3], solved: true, mirrored: false };

afterEach(() => useLanguage("en"));

test("the last try is always shown, of those before it a few, in a time that does not grow", () => {
  for (let count = 1; count <= 100; count += 1) {
    const shown = shownTries(count);
    const numbers = shown.map(({ number }) => number);
    assert.equal(numbers.at(-1), count);
    assert.deepEqual(
      numbers,
      [...new Set(numbers)].sort((a, b) => a - b),
    );
    assert.equal(numbers[0], 1);
    assert.ok(shown.every(({ start, end }, index) => start === (shown[index - 1]?.end ?? 0) && end > start));
    assert.ok((shown.at(-1)?.end ?? 0) < 2.5, `${count}`);
  }
});

test("a mean is that of the last five, and geometric", () => {
  const means = runningMeans([100, 1, 1, 1, 1, 1]).map((mean) => Number(mean.toFixed(3)));
  assert.deepEqual(means, [100, 10, 4.642, 3.162, 2.512, 1]);
});

test("a puzzle in words names the one that helped", () => {
  const words = (/** @type {object} */ more, earlier = [FIRST]) =>
    playedWords({ task: SECOND, learned: 1, fresh: null, reminder, ...more }, earlier, 100);
  assert.equal(words({}), "solved at once, helped by puzzle 1. Without memory: not solved in 100 attempts.");
  assert.equal(words({ learned: 4, fresh: 1, reminder: null }), "solved on attempt 4. Without memory: at once.");
  assert.equal(words({ learned: null }), "not solved in 100 attempts. Without memory: not solved in 100 attempts.");
  const mirrored = { ...reminder, mirrored: true };
  assert.match(words({ reminder: mirrored }), /, helped by puzzle 1 \(mirrored\)\. /);
  const other = { ...reminder, task: "00003:007" };
  assert.match(words({ reminder: other }), /, helped by Topple to the Wall 00003:007\. /);
  assert.match(words({ reminder: { ...reminder, solved: false, change: -2 } }), /^solved at once\. /);
});

test("all puzzles are summed up, and one that was not solved took all tries", () => {
  const played = { task: FIRST, learned: 1, fresh: null, reminder: null };
  assert.equal(
    totalWords([played], 100),
    "In this one run, 1 puzzle took it 1 attempt with its memory, and 100 attempts without.",
  );
  const many = Array.from({ length: 20 }, () => played);
  assert.equal(
    totalWords(many, 100),
    "In this one run, 20 puzzles took it 20 attempts with its memory, and 2,000 attempts without.",
  );
});

test("German says the same in its own order", async () => {
  await useLanguage("de");
  const played = { task: SECOND, learned: 4, fresh: null, reminder };
  assert.equal(
    playedWords(played, [FIRST], 100),
    "im 4. Versuch gelöst, dank Rätsel 1. Ohne Gedächtnis: nicht in 100 Versuchen.",
  );
  assert.equal(
    totalWords([played], 100),
    "In diesem einen Durchgang brauchte es für 1 Rätsel mit Gedächtnis 4 Versuche, ohne 100.",
  );
});
