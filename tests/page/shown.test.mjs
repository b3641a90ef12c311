// What the scene shows, as one state: which states follow each other, and what each keeps.

import assert from "node:assert/strict";
import { test } from "node:test";
import * as shown from "../../www/play/shown.js";

// A test knows which state it has made.
const {
  START,
  attemptRun,
  editing,
  ended,
  hiddenAuthor,
  neverTouched,
  overlaid,
  placing,
  refused,
  revealed,
  running,
  visibleAttempts,
} = /** @type {any} */ (shown);

const attempt = (author, number, ending = {}) => ({
  author,
  number,
  ball: [100, 200, 10],
  words: "never touched",
  ending: { solved: false, steps: 1000, longest_touch: 0, final_touch: 0, ...ending },
});
const shows = (run) => running(START, run);

test("a run begins unended, ends, and is left for the ball", () => {
  const watch = shows({ kind: "watch" });
  assert.deepEqual([watch.kind, watch.ended], ["watch", false]);
  assert.equal(ended(watch, null).ended, true);
  assert.deepEqual(placing(ended(watch, null)), START);
});

test("placing the ball has no end", () => {
  assert.equal(ended(START, null), START);
});

test("a refusal is told while the ball is placed, and is gone after a run", () => {
  const words = "Place the ball first.";
  const refusal = refused(START, words);
  assert.equal(refusal.refusal, words);
  assert.equal(refused(refusal, null).refusal, null);
  const run = running(refusal, { kind: "watch" });
  assert.equal("refusal" in run, false);
  assert.equal(refused(run, words), run);
  assert.equal(placing(run).refusal, null);
});

test("the result of a new attempt is hidden until it is revealed; a replay's never is", () => {
  const first = shows(attemptRun(attempt("player", 1), { hidden: "player" }));
  const race = shows({ kind: "compare", pair: [attempt("player", 1), attempt("model", 1)], hidden: "model" });
  assert.deepEqual([first, race].map(hiddenAuthor), ["player", "model"]);
  assert.deepEqual([first, race].map(revealed).map(hiddenAuthor), [null, null]);
  assert.equal(hiddenAuthor(shows(attemptRun(attempt("player", 1)))), null);
  assert.equal(hiddenAuthor(shows({ kind: "watch" })), null);
  assert.equal(revealed(START), START);
});

test("the tool and the edited outlast runs", () => {
  const drawn = editing(editing(START, { tool: "bodies" }), { edited: true });
  const run = running(drawn, attemptRun(attempt("model", 2)));
  assert.deepEqual([run.tool, run.edited], ["bodies", true]);
  const back = placing(editing(run, { edited: false }));
  assert.deepEqual([back.kind, back.tool, back.edited], ["placing", "bodies", false]);
});

test("the nearest moment is worth showing only of a miss that never touched", () => {
  const miss = shows(attemptRun(attempt("player", 1)));
  assert.ok(neverTouched(miss));
  const touched = attempt("player", 1, { longest_touch: 3 });
  const solved = attempt("player", 1, { solved: true, longest_touch: 180 });
  const inTheShow = attemptRun(attempt("model", 1), { ghosts: [] });
  for (const run of [attemptRun(touched), attemptRun(solved), inTheShow, { kind: "watch" }])
    assert.equal(neverTouched(shows(run)), false);
  const approach = { step: 12, gap: 3.5, points: [] };
  const over = ended(miss, approach);
  assert.equal(over.approach, approach);
  assert.equal(running(over, attemptRun(attempt("player", 2))).approach, null);
  assert.equal("approach" in ended(shows({ kind: "watch" }), approach), false);
});

test("a state is never changed in place", () => {
  const run = Object.freeze(shows(attemptRun(attempt("player", 1), { hidden: "player" })));
  for (const next of [ended(run, null), revealed(run), editing(run, { tool: "line" }), placing(run)])
    assert.notEqual(next, run);
});

test("the attempts that are shown do not include a preview", () => {
  const own = attempt("player", 3);
  assert.deepEqual(visibleAttempts(shows(attemptRun(own))), [own]);
  assert.deepEqual(visibleAttempts(shows(attemptRun({ ...attempt("model", 3), preview: true }))), []);
  assert.deepEqual(
    visibleAttempts(shows({ kind: "compare", pair: [own, attempt("model", 1)], hidden: null })).length,
    2,
  );
  assert.deepEqual(visibleAttempts(START), []);
});

test("an attempt is laid over the one that is shown, else the other's last, else its neighbour", () => {
  const names = (chosen, shown, used) =>
    overlaid(chosen, shown, used).map(({ author, number }) => `${author} ${number}`);
  const player2 = { author: "player", number: 2 };
  const model1 = { author: "model", number: 1 };
  const used = { player: 3, model: 4 };
  assert.deepEqual(names(player2, shows(attemptRun(attempt("player", 3))), used), ["player 2", "player 3"]);
  assert.deepEqual(names(model1, shows(attemptRun(attempt("player", 3))), used), ["player 3", "model 1"]);
  assert.deepEqual(names(player2, shows(attemptRun(attempt("player", 2))), used), ["player 2", "model 4"]);
  assert.deepEqual(names(player2, START, { player: 3, model: 0 }), ["player 2", "player 1"]);
  assert.deepEqual(names({ author: "player", number: 1 }, START, { player: 3, model: 0 }), ["player 1", "player 2"]);
  assert.deepEqual(names({ author: "player", number: 1 }, START, { player: 1, model: 0 }), ["player 1"]);
});
