// Links: what people have from before opens what it named, or its closest successor; lessons and challenges hide.

import assert from "node:assert/strict";
import { test } from "node:test";
import { START, linkTo, routed } from "../../www/core/change/route.ts";
import { openDialog, toggleHidden, usePreset } from "../../www/core/change/dialog.ts";
import { nextStep } from "../../www/core/derived/duel.ts";
import { isAlone, isHidden, shownPanels } from "../../www/core/derived/hidden.ts";
import { result } from "../../www/core/derived/sharing.ts";
import { pageOf, readAddress, writeAddress } from "../../www/effects/address.ts";
import { SOLVING, fresh, playAt, withTurn } from "./player.ts";
import type { Link } from "../../www/core/change/route.ts";

const OLD: [hash: string, now: Partial<Link>][] = [
  ["", {}],
  ["task=00007:008", { task: "00007:008" }],
  ["task=00007:008&panel=compare", { task: "00007:008", panel: "play" }],
  ["task=00007:008&panel=imagine", { task: "00007:008", panel: "imagine" }],
  ["task=00007:008&panel=map&layers=placement", { task: "00007:008", panel: "imagine", layers: ["placement"] }],
  ["task=00007:008&layers=base,judge&opacity=0.5", { task: "00007:008", layers: ["base", "success"] }],
  ["task=00007:008&model=cross-0&proposal=3&ball=40,200,12", { task: "00007:008", ball: [40, 200, 12] }],
  ["task=00007:008&view=presentation", { task: "00007:008", view: "presentation" }],
  ["task=00007:008&view=predict", { task: "00007:008", panel: "predict" }],
  ["task=00007:008&panel=imagine&stage=real", { task: "00007:008", panel: "imagine", step: "run" }],
  ["task=00007:008&view=stage", { task: "00007:008", view: "presentation" }],
  [
    "task=00007:008&view=presentation&step=base",
    { task: "00007:008", view: "presentation", panel: "imagine", step: "base" },
  ],
  [
    "task=00007:008&hide=puzzles,imagine,compare,predict,map,make",
    { task: "00007:008", hide: ["puzzles", "model", "imagine", "predict", "make"] },
  ],
  ["task=00007:008&challenge=3", { task: "00007:008", challenge: 3 }],
  ["task=00007:008&forecast=off", { task: "00007:008", hide: ["guess"] }],
  ["task=00007:008&forecast=on", { task: "00007:008" }],
  [
    "task=00007:008&hide=puzzles,tools,compare&forecast=off",
    { task: "00007:008", hide: ["puzzles", "guess", "model"] },
  ],
  ["task=00007:008&hide=tools,story,hint,fields,watch,attempts,transport,speed,save", { task: "00007:008" }],
];

test("every part of an old link is understood", () => {
  for (const [hash, now] of OLD) {
    const { link, unread } = readAddress(`#${hash}`, fresh.text);
    assert.deepEqual(unread, [], hash);
    assert.deepEqual(link, { ...START, ...now }, hash);
    assert.deepEqual(readAddress(writeAddress(link), fresh.text).link, link, hash);
  }
});

test("results and the model that learns have pages of their own now, unless a puzzle is named too", () => {
  assert.equal(pageOf("#view=results&model=cross-0"), "results.html");
  assert.equal(pageOf("#view=learns"), "learns.html");
  assert.equal(pageOf("#task=00007:008&view=results"), null);
  assert.equal(pageOf("#view=constructor"), null);
});

test("a lesson names several puzzles; a challenge the ball that solved", () => {
  const link: Link = { ...START, task: "00007:008", lesson: ["00007:008", "00001:002"], hide: ["guess"] };
  assert.equal(writeAddress(link), "#task=00007:008&lesson=00007:008,00001:002&hide=guess");
  assert.deepEqual(readAddress(writeAddress(link), fresh.text).link, link);
  for (const part of ["challenge=0", "challenge=101", "challenge=1e1", "lesson=7:8", "hide=nose2"])
    assert.equal(writeAddress(readAddress(`#${part}`, fresh.text).link), "#", part);
});

test("in a challenge the person plays alone, and nothing gives the answer away until they have solved it", () => {
  const challenged = routed(fresh, { ...START, task: "00000:000", challenge: 2 });
  assert.ok(isAlone(challenged));
  assert.ok(isHidden(challenged, "guess") && isHidden(challenged, "model"));
  assert.deepEqual(shownPanels(challenged), ["play"]);
  const solved = playAt(challenged, SOLVING);
  assert.equal(isHidden(solved, "guess"), false);
  assert.deepEqual(result(solved), { solvedAt: 1, modelAt: null, modelBalls: 0, isWon: false, marks: "🟢" });
});

test("a panel that is hidden does nothing, though the link names it", () => {
  const known = withTurn(fresh, SOLVING);
  const imagined = routed(known, { ...START, task: "00000:000", challenge: 2, panel: "imagine", step: "run" });
  assert.deepEqual([imagined.run, nextStep(imagined)], [null, "drop"]);
  const predicted = routed(known, { ...START, task: "00000:000", hide: ["predict"], panel: "predict" });
  assert.equal(nextStep(predicted), "drop");
});

test("the last puzzle of a lesson offers none after it", () => {
  const solvedIn = (...lesson: string[]) => nextStep(playAt({ ...fresh, route: { ...fresh.route, lesson } }, SOLVING));
  assert.deepEqual([solvedIn("00000:000", "00001:002"), solvedIn("00001:002", "00000:000")], ["next", "again"]);
});

test("the walkthrough goes on to another puzzle, but not to its last step, which would play a ball", () => {
  const at = (step: Link["step"]) => linkTo({ ...fresh, route: { ...fresh.route, step } }, { task: "00001:002" }).step;
  assert.deepEqual([at("action"), at("run")], ["action", null]);
});

test("a lesson begins with a preset, and each part can be chosen", () => {
  const dialog = openDialog(fresh, "lesson");
  assert.equal(dialog.lesson.tasks, "00000:000");
  const play = usePreset(dialog, "play").lesson;
  assert.ok(play.hide.includes("puzzles") && !play.hide.includes("play"));
  const own = toggleHidden(usePreset(dialog, "predict"), "puzzles").lesson;
  assert.equal(own.preset, null);
  assert.ok(own.hide.includes("guess") && !own.hide.includes("puzzles"));
});
