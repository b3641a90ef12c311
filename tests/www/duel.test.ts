// The duel: what is told when, verdicts, the model's veiled solution, playback.

import assert from "node:assert/strict";
import { test } from "node:test";
import { choose } from "../../www/core/change/kept.ts";
import { answered } from "../../www/core/change/model.ts";
import { place } from "../../www/core/change/placement.ts";
import { advance, again, drop, seek, setSpeed, show, stepBy, togglePlaying } from "../../www/core/change/run.ts";
import {
  attempts,
  missesInARow,
  modelSolvedAt,
  nextStep,
  playerSolvedAt,
  rounds,
  verdict,
} from "../../www/core/derived/duel.ts";
import { ATTEMPT_LIMIT } from "../../www/pkg/constants.ts";
import { LAST, MISSING, SOLVING, dropAt, fresh, line, playAt, withTurn } from "./player.ts";
import type { Ball, ImaginedBall } from "../../www/pkg/page/pathlight.js";
import type { State } from "../../www/core/state.ts";

const miss = (index: number): Ball => [30 + index, 100, 12];
const ownersOf = ({ run }: State) => run!.balls.map(({ of_model }) => (of_model ? "model" : "player"));

test("a drop is a duel of which nothing is told before both have ended", () => {
  const running = dropAt(withTurn(fresh, miss(9)), MISSING);
  assert.deepEqual(ownersOf(running), ["player", "model"]);
  const middle = advance(running, 500);
  assert.deepEqual([verdict(middle), rounds(middle), nextStep(middle)], [null, [], "pause"]);
  assert.deepEqual([playerSolvedAt(middle), modelSolvedAt(middle)], [null, null]);
  const over = advance(middle, 600);
  assert.equal(verdict(over)!.outcome, "neither");
  assert.deepEqual(
    rounds(over).map(({ model }) => model),
    [{ solved: false }],
  );
  assert.equal(nextStep(over), "again");
});

test("verdicts name who needed fewer balls", () => {
  const outcomes = (model: Ball[], ...player: Ball[]) => {
    let state = withTurn(fresh, ...model);
    return player.map((ball) => verdict((state = playAt(state, ball)))!.outcome);
  };
  assert.deepEqual(outcomes([miss(1), SOLVING], SOLVING), ["won"]);
  assert.deepEqual(outcomes([SOLVING], SOLVING), ["draw"]);
  assert.deepEqual(outcomes([SOLVING], miss(1), miss(2), SOLVING), ["lost", "behind", "late"]);
  assert.deepEqual(outcomes([miss(1), miss(2), miss(3)], miss(4), SOLVING), ["neither", "won"]);
  assert.deepEqual(outcomes([miss(1), miss(2), SOLVING], SOLVING, miss(3), miss(4)), ["won", "after", "after"]);
});

test("a ball that changes nothing for green is told apart from a near miss", () => {
  const { puzzle } = fresh;
  const unmoved = { ...fresh, puzzle: { ...puzzle, rollout: (ball: Ball | null) => puzzle.rollout(ball ?? MISSING) } };
  assert.deepEqual(
    [fresh, unmoved].map((state) => verdict(playAt(state, MISSING))!.changedNothing),
    [false, true],
  );
});

test("the next ball of the model, which has been computed already, is not told", () => {
  const over = playAt(withTurn(fresh, miss(1), SOLVING), MISSING);
  assert.equal(modelSolvedAt(over), null);
  assert.equal(verdict(over)!.modelAt, null);
});

test("while the weights load, or by a choice, one drops alone", () => {
  const alone = playAt(fresh, MISSING);
  assert.deepEqual([ownersOf(alone), verdict(alone)!.outcome], [["player"], "missed"]);
  const chosen = playAt(choose(withTurn(fresh, SOLVING), { alone: true }), SOLVING);
  assert.deepEqual(
    [ownersOf(chosen), verdict(chosen)!.outcome, rounds(chosen)[0]!.model],
    [["player"], "solved", null],
  );
});

test("the model's solution is played once, and then veiled until it is asked for or the person has solved", () => {
  const lost = playAt(withTurn(fresh, SOLVING), MISSING);
  assert.deepEqual(ownersOf(lost), ["player", "model"]);
  assert.deepEqual(ownersOf(show(lost, 1)), ["player"]);
  assert.deepEqual(ownersOf(show(lost, 1, true)), ["player", "model"]);
  const second = dropAt(lost, miss(2));
  assert.deepEqual(ownersOf(second), ["player"]);
  const solved = playAt(lost, [230, 90, 12]);
  assert.deepEqual(ownersOf(show(solved, 1)), ["player", "model"]);
});

test("a ball that was tried before is shown again and counts once", () => {
  const twice = playAt(playAt(fresh, MISSING), MISSING);
  assert.equal(attempts(twice).length, 1);
  assert.equal(twice.run!.round, 1);
});

test("no ball is dropped where it may not lie, nor beyond the limit, nor twice by two clicks", () => {
  assert.equal(drop(fresh), fresh);
  const invalid = place(fresh, [5, 5, 12], null);
  assert.equal(drop(invalid), invalid);
  const running = dropAt(fresh, MISSING);
  assert.equal(drop(running), running);
  const lines = Array.from({ length: ATTEMPT_LIMIT }, (_, index) => line(miss(index)));
  const full = { ...fresh, kept: { ...fresh.kept, attempts: { [fresh.puzzle.key]: lines } } };
  assert.equal(dropAt(full, SOLVING).run, null);
  assert.equal(dropAt(full, miss(3)).run!.round, 4);
});

test("the verdict has the chance that the model gave, and how far off its guess was", () => {
  const imagined = { object: Float32Array.of(3, 4), probability: 0.25 } as ImaginedBall;
  const over = playAt(answered(fresh, fresh.puzzle.key, { guess: { of: MISSING, imagined } }), MISSING);
  assert.deepEqual(verdict(over)!.guessed, { chance: 0.25, off: 5 });
});

test("the large button leads on only once the person has solved", () => {
  assert.equal(nextStep(fresh), "drop");
  const solved = playAt(playAt(fresh, MISSING), SOLVING);
  assert.equal(nextStep(solved), "next");
  assert.equal(nextStep(seek(show(solved, 1), Infinity)), "next");
  assert.equal(nextStep(again(solved)), "drop");
});

test("misses are counted from the last solution", () => {
  const three = [miss(1), miss(2), miss(3)].reduce(playAt, fresh);
  assert.equal(missesInARow(three), 3);
  assert.equal(missesInARow(playAt(three, SOLVING)), 0);
});

test("playback: pause, scrub, steps and speed; replaying tells the outcome at once", () => {
  const half = advance(setSpeed(dropAt(fresh, MISSING), 0.25), 2000);
  assert.equal(half.run!.step, LAST / 2);
  const paused = togglePlaying(half);
  assert.equal(advance(paused, 1000), paused);
  assert.equal(stepBy(paused, -1).run!.step, LAST / 2 - 1);
  const end = seek(paused, 1e9);
  assert.deepEqual([end.run!.step, end.run!.playing], [LAST, false]);
  const again = advance(togglePlaying(end), 100);
  assert.deepEqual([again.run!.step < LAST, rounds(again).length, again.run!.fresh], [true, 1, false]);
});

test("where motion is unwelcome, a drop shows its end", () => {
  const still = { ...fresh, device: { ...fresh.device, stillness: true } };
  assert.equal(verdict(dropAt(still, MISSING))!.outcome, "missed");
});

test("an answer about another puzzle comes too late", () => {
  assert.equal(answered(fresh, "00009:009", { practised: true }), fresh);
});
