// The state of a puzzle as the text of a link: what is written is read again, and what makes no sense is named.

import assert from "node:assert/strict";
import { test } from "node:test";
import { hrefOf, pageViewHref, pageViewOf, showsHome } from "../../www/state/links.js";
import { INITIAL_STATE, formatFragment, parseFragment } from "../../www/state/url-state.js";
import { viewOf, withoutPresentation } from "../../www/state/view.js";

/** @type {import("../../www/state/url-state.js").State} */
const FULL = {
  ...INITIAL_STATE,
  task: "00007:008",
  model: "cross-0",
  panel: "compare",
  step: "run",
  view: "presentation",
  proposal: 7,
  layers: ["target", "success"],
  opacity: 0.5,
  forecast: true,
  ball: [128, 200, 12],
  challenge: 3,
  hide: ["story", "map"],
};

test("the initial state has an empty link", () => {
  assert.equal(formatFragment({ ...INITIAL_STATE }), "");
  assert.deepEqual(parseFragment(""), { state: { ...INITIAL_STATE }, problem: null });
});

test("every part of a state comes back from its link", () => {
  assert.deepEqual(parseFragment(`#${formatFragment(FULL)}`), { state: FULL, problem: null });
  const scene = { ...INITIAL_STATE, scene: "q1YqS8wpTlWyUjLQUQJyMnOUrKIV" };
  assert.deepEqual(parseFragment(formatFragment(scene)).state, scene);
});

test("a scene takes the place of a task", () => {
  assert.equal(parseFragment("task=00007:008&scene=abc").state.task, null);
});

test("a puzzle takes the place of a view of the page, but can be presented", () => {
  for (const puzzle of ["task=00007:008", "scene=abc"]) {
    for (const view of ["results", "learns"]) assert.equal(parseFragment(`${puzzle}&view=${view}`).state.view, null);
    assert.equal(parseFragment(`${puzzle}&view=presentation`).state.view, "presentation");
  }
});

test("the panel Make is known by its old name too", () => {
  const state = { ...INITIAL_STATE, task: "00007:008", panel: "make", hide: ["map", "make"] };
  assert.deepEqual(parseFragment("task=00007:008&panel=bend&hide=map,bend"), { state, problem: null });
});

test("what cannot be read is named, and the rest holds", () => {
  for (const part of [
    "task=7:8",
    "panel=nowhere",
    "ball=1,2",
    "ball=256,0,12",
    "ball=100,100,1",
    "ball=100,100,33",
    "proposal=0",
    "proposal=101",
    "opacity=2",
    "layers=base,nothing",
    "forecast=maybe",
    "__proto__=x",
    "colour=red",
  ]) {
    const { state, problem } = parseFragment(`model=cross-0&${part}`);
    assert.deepEqual(state, { ...INITIAL_STATE, model: "cross-0" }, part);
    assert.ok(problem?.includes(`“${part}”`), `${part}: ${problem}`);
  }
  assert.match(parseFragment("a=1&b=2&c=3&d=4").problem ?? "", /“a=1”, “b=2”, “c=3” and more/);
  assert.match(parseFragment("%E0%A4%A=x").problem ?? "", /%E0%A4%A/);
});

test("old names in a link are read", () => {
  assert.deepEqual(parseFragment("stage=chosen&view=stage"), {
    state: { ...INITIAL_STATE, step: "run", view: "presentation" },
    problem: null,
  });
  for (const [old, step] of Object.entries({
    judge: "placement",
    success: "placement",
    candidates: "imagined",
    chosen: "run",
    real: "run",
    base: "base",
  }))
    assert.equal(parseFragment(`step=${old}`).state.step, step);
  assert.deepEqual(parseFragment("layers=target,judge").state.layers, ["target", "success"], "it is still a map");
  assert.match(parseFragment("stage=nowhere").problem ?? "", /“stage=nowhere”/);
});

test("a link to another puzzle keeps the model and what is hidden", () => {
  assert.equal(hrefOf(FULL, "00001:002"), "#task=00001:002&model=cross-0&hide=story,map");
  assert.equal(hrefOf({ ...FULL, hide: ["puzzles"] }, "00001:002"), null);
});

test("a hidden panel is not shown, and no map lies over the scene in Predict", () => {
  assert.equal(viewOf({ ...FULL, view: null, panel: "map" }).panel, "play");
  assert.deepEqual(viewOf({ ...FULL, view: null, step: null, panel: "predict" }).layers, []);
  assert.deepEqual(viewOf({ ...FULL, view: null, step: null, panel: "imagine" }).layers, ["target", "success"]);
});

test("Imagine lays two maps over the scene unless the link says otherwise, and a step its own", () => {
  const layers = (link) => viewOf(parseFragment(`task=00007:008&${link}`).state).layers;
  assert.deepEqual(layers("panel=imagine"), ["target", "action"]);
  assert.deepEqual(layers("panel=imagine&layers="), []);
  assert.deepEqual(layers("panel=imagine&layers=base,target,action"), ["base", "target", "action"]);
  assert.deepEqual(layers("panel=imagine&step=placement"), ["placement", "success"]);
  assert.deepEqual(layers("panel=play"), []);
  assert.deepEqual(layers("layers=target"), ["target"]);
});

test("the model’s guess is shown to those who like it, but neither in a challenge nor where the link says no", () => {
  const guess = (link, likes) => viewOf(parseFragment(`task=00007:008&${link}`).state, likes).forecast;
  assert.equal(guess("", true), true);
  assert.equal(guess("", false), false);
  assert.equal(guess("challenge=3", true), false);
  assert.equal(guess("challenge=3&forecast=on", false), true);
  assert.equal(guess("forecast=off", true), false);
  for (const link of ["panel=imagine", "panel=predict", "hide=forecast", "hide=imagine", "view=presentation"])
    assert.equal(guess(link, true), false, link);
});

test("the presentation is left for the panel of its story", () => {
  assert.deepEqual(withoutPresentation({ step: "action" }), { view: null, panel: "imagine" });
  assert.deepEqual(withoutPresentation({ step: null }), { view: null });
});

test("a view of the page stands in place of the grid, unless a puzzle is shown or the link hides it", () => {
  for (const view of /** @type {const} */ (["results", "learns"])) {
    const href = pageViewHref(view, { ...FULL, hide: ["tools"] }) ?? "";
    const { state, problem } = parseFragment(href);
    assert.equal(problem, null);
    assert.deepEqual(
      [pageViewOf(state), state.model, state.hide, showsHome(state)],
      [view, "cross-0", ["tools"], false],
    );
    assert.equal(pageViewOf({ ...state, task: "00007:008" }), null);
    for (const hidden of /** @type {const} */ (["imagine", "compare", "puzzles"])) {
      /** @type {typeof state} */
      const hiding = { ...state, hide: [hidden] };
      assert.deepEqual([pageViewOf(hiding), pageViewHref(view, hiding)], [null, null]);
    }
  }
  assert.equal(pageViewOf({ ...INITIAL_STATE, view: "presentation" }), null);
});
