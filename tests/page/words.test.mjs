// What the page says in words and tables, without a page.

import assert from "node:assert/strict";
import { test } from "node:test";
import { chanceWords, percent } from "../../www/model/chance-words.js";
import { summary, valueAt } from "../../www/model/map-summary.js";
import { ballsCsv, otherOutcome, outcomesWords } from "../../www/model/outcomes.js";
import { toCsv } from "../../www/model/csv.js";
import { sentence } from "../../www/text/sentence.js";
import { text } from "../../www/text/text.js";
import { degreesOf, nameOf, wordsOf } from "../../www/editor/body-words.js";

/** @returns {import("../../www/pkg/pathlight.js").TriedProposal} */
const tried = (solved, longest_touch) => ({
  ball: [20, 30, 5],
  ending: { solved, steps: 300, longest_touch, final_touch: 0 },
  origin: { kind: "imagined", prior: 0.5, probability: 0.25, lowered_by: null },
  rejected: 0,
});
const TRIED = [tried(false, 0), tried(false, 60), tried(false, 60), tried(true, 180)];

test("a chance is never told as none or all", () => {
  assert.deepEqual([0, 0.004, 0.5, 0.996, 1].map(percent), ["under 1%", "under 1%", "50%", "over 99%", "over 99%"]);
  assert.equal(chanceWords(0.03), "almost surely won’t work (chance 3%)");
  assert.equal(chanceWords(1), "almost surely works (chance over 99%)");
});

test("what a model knows does not contradict that it practised a puzzle", () => {
  const { knows, seen, unseen } = text.model;
  for (const setup of /** @type {const} */ (["within", "cross"]))
    assert.doesNotMatch(knows[setup], /other puzzles|never/);
  assert.notEqual(seen, unseen);
});

test("the outcomes of balls are counted, and the next other one is found", () => {
  assert.equal(
    outcomesWords(TRIED),
    "Of 4 balls, 1 solves the puzzle, 2 get green to touch its goal for a while, and 1 never does.",
  );
  assert.equal(outcomesWords([tried(true, 180)]), "Its first idea works.");
  assert.equal(otherOutcome(TRIED, 1, 1), 3);
  assert.equal(otherOutcome(TRIED, 2, -1), 0);
  assert.equal(otherOutcome(TRIED, 3, 1), null);
});

test("a table has a line for each ball", () => {
  const [names, first] = ballsCsv(TRIED, { task: "00007:008", model: "within-0", seen: true, simulator: 4 }).split(
    "\r\n",
  );
  assert.equal(names.split(",").length, first.split(",").length);
  assert.equal(first, "00007:008,within-0,true,4,1,20,30,5,missed,0.00,5.00,imagined,0.25,0.5,");
});

test("fields of a table are quoted where they have to be", () => {
  assert.equal(toCsv([["a", null, 'say "no"', "1,5", "two\nlines"]]), 'a,,"say ""no""","1,5","two\nlines"\r\n');
});

test("a map is told by its peak and its halves", () => {
  const map = new Float32Array(64 * 64);
  map[10 * 64 + 2] = 1;
  map[10 * 64 + 60] = 1 / 3;
  assert.equal(summary(map), "strongest at x 10, y 42; 75 percent on the left, 25 on the right");
  assert.equal(valueAt(map, [11.9, 40]), 1);
  assert.equal(valueAt(map, [-5, 300]), 0);
});

test("a body is told by colour, shape and numbers", () => {
  const place = { x: 10, y: 20.005, angle: -Math.PI / 2, dynamic: true };
  /** @type {import("../../www/pkg/pathlight.js").CustomScene} */
  const scene = {
    version: 1,
    body1: 0,
    body2: 1,
    bodies: [
      { shape: "ball", radius: 5, ...place },
      { shape: "jar", height: 30, ...place, dynamic: false },
      { shape: "bar", length: 9, thickness: 3, ...place },
      { shape: "bar", length: 8, thickness: 3, ...place },
    ],
  };
  assert.deepEqual(
    [0, 1, 3].map((index) => nameOf(scene, index)),
    ["green ball", "purple jar", "gray bar (body 3)"],
  );
  assert.equal(wordsOf(scene, 0), "Green ball: x 10, y 20.01, turned by 270 degrees, radius 5, moves.");
  assert.equal(wordsOf(scene, null), "Nothing is selected.");
  assert.equal(degreesOf({ ...scene.bodies[0], angle: 4 * Math.PI }), 0);
});

test("words become a sentence once", () => {
  assert.deepEqual(["the ball falls", "Why?"].map(sentence), ["The ball falls.", "Why?"]);
});
