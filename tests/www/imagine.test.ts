// The walkthrough and what it shows: its steps, maps over the scene, the model's favourite ball at its end.

import assert from "node:assert/strict";
import { test } from "node:test";
import { answered, chooseModel, setModel } from "../../www/core/change/model.ts";
import { place } from "../../www/core/change/placement.ts";
import { START, openPanel, opened, routed, toggleLayer } from "../../www/core/change/route.ts";
import { advance, again } from "../../www/core/change/run.ts";
import { STEPS, go, goTo, toggleTour, tourOn } from "../../www/core/change/walkthrough.ts";
import { attempts } from "../../www/core/derived/duel.ts";
import { extent, favourite, hints, overlap, shownGuess, shownLayers } from "../../www/core/derived/imagined.ts";
import { start } from "../../www/core/state.ts";
import { walkthroughEffect } from "../../www/effects/walkthrough.ts";
import { linkOf } from "../../www/effects/address.ts";
import { GRID_SIDE } from "../../www/pkg/constants.ts";
import { MISSING, SOLVING, dropAt, fresh, playAt, puzzle, withTurn } from "./player.ts";
import type { Candidate, ImaginedBall, Maps } from "../../www/pkg/page/pathlight.js";
import type { State } from "../../www/core/state.ts";

const imagining = openPanel(fresh, "imagine");
const IMAGINED = { object: Float32Array.of(3, 4), probability: 0.7 } as ImaginedBall;

test("a step lays its maps over the scene; a tile goes on from there, with any number of maps", () => {
  const fourth = goTo(imagining, "placement");
  assert.deepEqual(shownLayers(fourth), ["placement", "success"]);
  let all = toggleLayer(fourth, "base");
  for (const name of ["target", "action"] as const) all = toggleLayer(all, name);
  assert.deepEqual(shownLayers(all), ["placement", "success", "base", "target", "action"]);
  assert.equal(all.route.step, null);
  assert.deepEqual(shownLayers(toggleLayer(all, "success")), ["placement", "base", "target", "action"]);
});

test("arrows lead through the steps and all together, and stop at the ends", () => {
  const seen = [imagining.route.step];
  for (let state = imagining, count = 0; count < 8; count++) seen.push((state = go(state, 1)).route.step);
  assert.deepEqual(seen, [null, ...STEPS, "run", "run"]);
  assert.equal(go(go(goTo(imagining, "base"), -1), -1).route.step, null);
});

test("what ran in Play does not lie over a step", () => {
  const played = openPanel(playAt(fresh, MISSING), "imagine");
  assert.ok(played.run);
  assert.equal(goTo(played, "base").run, null);
});

test("the panel comes back to the step that was left", () => {
  const away = openPanel(goTo(imagining, "action"), "play");
  assert.deepEqual(shownLayers(away), []);
  assert.deepEqual(shownLayers(openPanel(away, "imagine")), ["action"]);
});

test("the last step plays the model's first ball as soon as that is known, and says how far off its guess was", () => {
  const waiting = goTo(imagining, "run");
  assert.equal(waiting.run, null);
  const running = withTurn(waiting, SOLVING);
  assert.deepEqual(running.run!.balls, [{ ball: SOLVING, of_model: true }]);
  const answer = answered(running, running.puzzle.key, { guess: { of: SOLVING, imagined: IMAGINED } });
  assert.ok(shownGuess(answer), "the guess lies beside the run");
  assert.equal(favourite(answer), null);
  const { chance, off, facts } = favourite(advance(answer, 1e6))!;
  assert.deepEqual([chance, off, facts.ending.solved], [0.7, 5, true]);
  assert.equal(attempts(answer).length, 0);
});

test("a link with a ball and the last step opens both", () => {
  const link = { ...START, task: "00000:000", panel: "imagine", step: "run", ball: MISSING } as const;
  const { ball, ...route } = link;
  for (const state of [
    start(route, puzzle(), fresh.kept, fresh.device, fresh.text, ball),
    routed(fresh, link),
    opened(fresh, link, puzzle()),
  ]) {
    assert.deepEqual(linkOf(state), link);
    assert.deepEqual(withTurn(state, SOLVING).run!.balls, [{ ball: SOLVING, of_model: true }]);
  }
});

test("whoever goes back to a ball of their own leaves the last step, and nothing of it plays on", () => {
  const running = goTo(withTurn(imagining, SOLVING), "run");
  for (const leave of [
    again,
    (state: State) => place(state, MISSING, null),
    (state: State) => dropAt(state, MISSING),
  ]) {
    const left = leave(running);
    assert.equal(left.route.step, null);
    assert.ok(!left.run || left.run.round !== null);
  }
  assert.equal(openPanel(running, "play").run, null);
  assert.equal(routed(running, { ...linkOf(running), step: "base" }).run, null);
  assert.equal(openPanel(openPanel(running, "play"), "imagine").run!.balls[0]!.of_model, true);
  // A duel that was shown before makes room.
  const duel = openPanel(playAt(withTurn(fresh, SOLVING), MISSING), "imagine");
  assert.equal(goTo(duel, "run").run!.round, null);
});

test("the walkthrough goes on by itself until its last step has ended; a person's hand stops it", () => {
  const ready = answered(withTurn(imagining, SOLVING), imagining.puzzle.key, { maps: {} as Maps, candidates: [] });
  let touring = toggleTour(ready);
  assert.equal(touring.route.step, "base");
  assert.deepEqual(walkthroughEffect.needs(touring), ["base"]);
  assert.equal(walkthroughEffect.needs({ ...touring, answers: { ...touring.answers, maps: null } }), null);
  for (let count = 0; count < 5; count++) touring = tourOn(touring);
  assert.deepEqual([touring.route.step, touring.touring, walkthroughEffect.needs(touring)], ["run", true, null]);
  const over = tourOn(advance(touring, 1e6));
  assert.deepEqual([over.route.step, over.touring], ["run", false]);
  assert.equal(toggleTour(over).route.step, "base");
  for (const stop of [toggleTour, (state: State) => go(state, 1), (state: State) => place(state, MISSING, null)])
    assert.equal(stop(toggleTour(ready)).touring, false);
});

test("the likeliest forty futures are shown, the likeliest strongest", () => {
  const candidates = Array.from(
    { length: 50 },
    (_, index) => ({ object: Float32Array.of(index, 0), probability: (index + 1) / 50 }) as Candidate,
  );
  const shown = hints(answered(goTo(imagining, "imagined"), imagining.puzzle.key, { candidates }))!;
  assert.deepEqual([shown.length, shown[0]!.object[0]], [40, 49]);
  assert.ok(shown[0]!.opacity > shown.at(-1)!.opacity);
  assert.deepEqual(hints(answered(imagining, imagining.puzzle.key, { candidates })), []);
});

test("another model's answers do not mix with those of the one before", () => {
  const played = withTurn(answered(fresh, fresh.puzzle.key, { practised: true }), SOLVING);
  const { answers, model, kept } = chooseModel(played, "cross");
  assert.deepEqual([answers.turn, answers.practised, model.kind, kept.model], [[], null, "loading", "cross"]);
  assert.equal(chooseModel(played, "within"), played);
});

test("a drop waits for the model's ball, unless that will not come", () => {
  const ready = setModel(fresh, { kind: "ready", name: "within-0", card: {} as never });
  const waiting = dropAt(ready, MISSING);
  assert.deepEqual([waiting.run, waiting.placement.dropped, attempts(waiting)], [null, true, []]);
  const came = answered(withTurn(waiting), waiting.puzzle.key, { turnUpTo: 1 });
  assert.deepEqual([came.run!.round, came.placement.dropped], [1, false]);
  const duel = answered(waiting, waiting.puzzle.key, { turn: withTurn(fresh, SOLVING).answers.turn, turnUpTo: 1 });
  assert.equal(duel.run!.balls.length, 2);
  assert.equal(place(waiting, SOLVING, null).placement.dropped, false);
  const failed = setModel(waiting, { kind: "failed", failure: { code: "crashed", reason: "" } });
  assert.equal(failed.run!.balls.length, 1);
});

test("agreement is intersection over union; a map is described by where it begins and ends", () => {
  assert.equal(overlap(Float32Array.of(1, 0.5, 0), Float32Array.of(1, 0, 0.5)), 0.5);
  assert.equal(overlap(new Float32Array(4), new Float32Array(4)), 1);
  const map = new Float32Array(GRID_SIDE * GRID_SIDE);
  map[0] = 1;
  map[GRID_SIDE * 10 + 20] = 0.6;
  map[GRID_SIDE * 60 + 60] = 0.2;
  assert.deepEqual(extent(map, null), { from: [2, 2], to: [82, 42] });
  assert.deepEqual(extent(map, [82, 42]).to, [2, 2]);
});
