// What is said of attempts, in both languages.

import assert from "node:assert/strict";
import { afterEach, test } from "node:test";
import { endingWords } from "../../www/play/ending-words.js";
import { verdictWords } from "../../www/play/verdict.js";
import { firstKnown } from "../../www/text/language.js";
import { text, useLanguage } from "../../www/text/text.js";

/** @typedef {import("../../www/text/en/puzzles.js").NamedBody} NamedBody */

const GOAL_STEPS = 180;
/** @type {(longest_touch: number, final_touch: number, solved?: boolean, steps?: number) => string} */
const words = (longest_touch, final_touch, solved = false, steps = 1000) =>
  endingWords({ solved, steps, longest_touch, final_touch });

afterEach(() => useLanguage("en"));

test("an ending in words", () => {
  assert.equal(words(0, 0), "never touched");
  assert.equal(words(84, 0), "touched for 1.4 s, then lost");
  assert.equal(words(1, 0), "touched for a moment, then lost");
  assert.equal(words(84, 84), "touching for 1.4 s when time ran out");
  assert.equal(words(GOAL_STEPS, GOAL_STEPS, true, 312), "solved after 5.2 s");
});

test("the verdict names the quicker", () => {
  const none = { used: 0, solved_at: null };
  assert.equal(verdictWords(none, none), "Nobody has tried yet.");
  const missed = { used: 1, solved_at: null };
  assert.equal(verdictWords(missed, none), "Not solved yet: 1 attempt by you, 0 attempts by the model.");
  const first = { used: 1, solved_at: 1 };
  assert.equal(verdictWords(missed, first), "The model solved it on attempt 1. You have not yet, in 1 attempt.");
  assert.equal(
    verdictWords({ used: 2, solved_at: 2 }, first),
    "The model solved it on attempt 1, you on attempt 2. The model was quicker.",
  );
  assert.equal(verdictWords(first, first), "You and the model both solved it on attempt 1. A draw.");
});

test("German declines the bodies of a goal", async () => {
  await useLanguage("de");
  /** @type {NamedBody} */
  const ball = { role: "green", shape: "ball" };
  assert.equal(
    text.puzzles.goal(ball, { role: "purple", shape: "bar" }, 3),
    "Die grüne Kugel soll 3 Sekunden lang den violetten Balken berühren.",
  );
  assert.equal(
    text.play.invalid.overlaps({ role: "gray", shape: "standing_sticks" }),
    "die Kugel überschneidet sich mit den grauen Stäben",
  );
  assert.equal(words(84, 0), "1,4 s lang berührt, dann verloren");
});

test("the first language that the page has is taken", () => {
  assert.equal(firstKnown([null, "fr-CA", "de-AT", "en"]), "de");
  assert.equal(firstKnown(["fr"]), "en");
  assert.equal(firstKnown([undefined, "constructor"]), "en");
});
