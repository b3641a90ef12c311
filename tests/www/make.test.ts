// Making a puzzle: bodies under a pointer and under keys, their roles, undo, and the puzzle that becomes of them.

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  add,
  cancel,
  drag,
  duplicate,
  empty,
  isSettled,
  making,
  mayBe,
  nudge,
  press,
  redo,
  release,
  remade,
  remove,
  rename,
  resizeTo,
  select,
  selectNext,
  selectedBody,
  setRole,
  turnBy,
  turnTo,
  undo,
} from "../../www/core/change/make.ts";
import { place } from "../../www/core/change/placement.ts";
import { opened, START } from "../../www/core/change/route.ts";
import { bodyAt, distanceTo, knobsOf, roleOf, sizeAt } from "../../www/core/derived/bodies.ts";
import { readSceneText, textOfScene } from "../../www/core/scene-text.ts";
import { makingKey } from "../../www/stage/keys.ts";
import { CUSTOM, MISSING, fresh, playAt, puzzle } from "./player.ts";
import type { Point } from "../../www/core/change/placement.ts";
import type { State } from "../../www/core/state.ts";
import type { CustomBody, CustomScene } from "../../www/pkg/page/pathlight.js";

const REACH = { knob: 4, ball: 4 };
const BAR = 2;
const body = (state: State, index: number) => making(state).scene.bodies[index]!;
const placed = (state: State, index: number) => [body(state, index).x, body(state, index).y];
const dragged = (state: State, from: Point, ...to: Point[]) =>
  release(
    to.reduce((now, point) => drag(now, 1, point), press(state, 1, from, REACH)),
    1,
  );
const everythingFits = () => true;

test("a body that is dragged keeps the offset at which it was grabbed, and its origin stays in the scene", () => {
  const moved = dragged(fresh, [150, 101], [100, 51], [103.4, 61.2]);
  assert.deepEqual(placed(moved, BAR), [113, 60]);
  assert.deepEqual(placed(dragged(fresh, [60, 180], [-90, 400]), 0), [0, 256]);
});

test("the knobs of the selected body resize it within its limits, and turn it", () => {
  const selected = select(fresh, BAR);
  const { size, turn } = knobsOf(body(selected, BAR));
  const long = dragged(selected, size, [size[0] + 10, size[1]]);
  assert.equal((selectedBody(long) as { length: number }).length, 84);
  const turned = dragged(selected, turn!, [100, 100]);
  assert.equal(Math.round((body(turned, BAR).angle / Math.PI) * 180), 90);
  assert.equal((selectedBody(resizeTo(selected, "length", 9000, null)) as { length: number }).length, 512);
  assert.equal(resizeTo(selected, "radius", 20, null), selected);
});

test("a drag is undone in one step, and redone; whoever undoes while dragging lets go", () => {
  const moved = dragged(dragged(fresh, [160, 100], [165, 100], [170, 100]), [170, 100], [180, 110]);
  assert.deepEqual(placed(undo(moved), BAR), [170, 100]);
  assert.deepEqual(placed(undo(undo(moved)), BAR), [160, 100]);
  assert.deepEqual(placed(redo(redo(undo(undo(moved)))), BAR), [180, 110]);
  assert.equal(undo(fresh), fresh);
  const held = undo(drag(press(fresh, 1, [160, 100], REACH), 1, [180, 100]));
  assert.equal(drag(held, 1, [200, 100]), held);
});

test("a second pointer changes nothing, and one that the browser takes away has changed nothing", () => {
  const held = press(fresh, 1, [160, 100], REACH);
  assert.equal(press(held, 2, [60, 180], REACH), held);
  assert.equal(drag(held, 2, [60, 100]), held);
  assert.equal(cancel(drag(held, 1, [200, 100]), 1).make, null);
});

test("a press beside all bodies selects nothing, and the selected body stays grabbed under another", () => {
  assert.equal(selectedBody(press(select(fresh, BAR), 1, [230, 230], REACH)), null);
  const above = dragged(fresh, [60, 180], [160, 100]);
  assert.equal(making(press(select(above, BAR), 1, [160, 100], REACH)).selected, BAR);
});

test("whoever changes the scene leaves what is played", () => {
  assert.equal(press(playAt(fresh, MISSING), 1, [160, 100], REACH).run, null);
});

test("there is always one green object and one goal: they change places", () => {
  const bar = setRole(select(fresh, BAR), "green");
  const roles = (state: State) => making(state).scene.bodies.map((_, index) => roleOf(making(state).scene, index));
  assert.deepEqual(roles(fresh), ["green", "purple", "gray"]);
  assert.deepEqual(roles(bar), ["gray", "purple", "green"]);
  assert.deepEqual(roles(setRole(select(fresh, 0), "blue")), ["blue", "green", "gray"]);
  assert.deepEqual(roles(setRole(select(fresh, 1), "green")), ["blue", "green", "gray"]);
  assert.deepEqual(roles(setRole(select(fresh, BAR), "black")), ["green", "purple", "black"]);
  assert.ok(!mayBe(select(fresh, 0), "gray"));
});

test("a new body and a copy go where there is room, and are selected", () => {
  const isFree = ({ bodies }: CustomScene, index: number) =>
    bodies.every(
      (other, at) => at === index || Math.hypot(other.x - bodies[index]!.x, other.y - bodies[index]!.y) > 30,
    );
  const one = add(fresh, "ball", isFree);
  const two = add(one, "ball", isFree);
  assert.deepEqual(
    [placed(one, 3), placed(two, 4)],
    [
      [128, 180],
      [152, 204],
    ],
  );
  assert.equal(making(two).selected, 4);
  assert.deepEqual(placed(duplicate(select(fresh, BAR), everythingFits), 3), [176, 116]);
  const full = Array.from({ length: 70 }).reduce<State>((state) => add(state, "ball", everythingFits), fresh);
  assert.equal(making(full).scene.bodies.length, 64);
});

test("a body that is removed takes nothing else with it; object and goal cannot be removed", () => {
  const extra = setRole(select(add(fresh, "jar", everythingFits), 3), "green");
  const less = remove(select(extra, BAR));
  const { scene, selected } = making(less);
  assert.deepEqual([scene.bodies.length, scene.bodies[scene.body1]!.shape, selected], [3, "jar", null]);
  assert.equal(making(remove(select(fresh, 0))).scene.bodies.length, 3);
});

test("a changed puzzle is named after the one that it was; an empty scene has no name, and undo leads back", () => {
  const moved = nudge(select(fresh, BAR), 1, 0, 0, "key 1");
  assert.equal(making(moved).scene.name, "Two Drops, changed");
  assert.equal(making(rename(moved, "  Mine ")).scene.name, "Mine");
  assert.deepEqual([making(empty(moved)).scene.name, making(empty(moved)).scene.bodies.length], [undefined, 3]);
  assert.deepEqual(making(undo(empty(moved))).scene, making(moved).scene);
});

test("keys move, resize and turn by one or further; a held key is one gesture", () => {
  const held = nudge(nudge(select(fresh, BAR), 10, 0, 0, "key 1"), 10, 0, 0, "key 1");
  assert.deepEqual(placed(held, BAR), [180, 100]);
  assert.deepEqual(placed(undo(held), BAR), [160, 100]);
  assert.equal((selectedBody(nudge(held, 0, 0, -1, "key 2")) as { length: number }).length, 63);
  assert.equal(Math.round((selectedBody(turnBy(held, -15, "key 3"))!.angle / Math.PI) * 180), 345);
  assert.equal(nudge(fresh, 1, 0, 0, "key 1"), fresh);
  const last = selectNext(fresh, -1);
  assert.deepEqual([making(last).selected, making(selectNext(last, 1)).selected], [2, 0]);
  const facts = { key: "<", code: "Comma", ctrlKey: false, metaKey: false, altKey: false, shiftKey: true };
  assert.deepEqual(makingKey(facts), { kind: "turn", degrees: 15 });
  assert.deepEqual(makingKey({ ...facts, key: "т", code: "KeyN", shiftKey: false }), { kind: "select", by: 1 });
  assert.equal(makingKey({ ...facts, key: "d", code: "KeyD", ctrlKey: true }), null);
});

test("the changed scene becomes the puzzle, with attempts of its own, and the ball stays", () => {
  const challenged = { ...fresh, route: { ...fresh.route, challenge: 2 } };
  const changed = nudge(select(place(challenged, MISSING, null), BAR), 5, 0, 0, "key 1");
  assert.ok(isSettled(fresh) && !isSettled(changed));
  const next = remade(changed, { ...puzzle(), key: "digest", custom: making(changed).scene }, { scene: "text" });
  assert.ok(isSettled(next));
  const { task, scene, challenge } = next.route;
  assert.deepEqual([task, scene, challenge, next.placement.ball], [null, "text", null, MISSING]);
  // Undo leads back to the task, unnamed, as the puzzle that it was.
  const back = making(undo(next));
  assert.ok(back.scene === back.origin.custom && back.origin === fresh.puzzle);
  assert.equal(opened(next, { ...START, task: "00001:000" }, puzzle("00001:000")).make, null);
});

test("a pointer meets each shape where it is drawn, and what lies in a jar before the jar", () => {
  const jar: CustomBody = { shape: "jar", height: 60, x: 100, y: 50, angle: 0, dynamic: true };
  const inside: CustomBody = { shape: "ball", radius: 8, x: 100, y: 62, angle: 0, dynamic: true };
  const sticks: CustomBody = { shape: "standing_sticks", length: 60, x: 50, y: 50, angle: 0, dynamic: true };
  assert.equal(bodyAt([jar, inside], [100, 62], 4), 1);
  assert.equal(bodyAt([jar, inside], [100, 90], 4), 0);
  assert.equal(bodyAt([jar, inside], [200, 200], 4), null);
  assert.ok(distanceTo(jar, [100, 120]) > 9 && distanceTo(jar, [100, 40]) > 8);
  assert.ok(distanceTo(sticks, [50, 50]) < 0 && distanceTo(sticks, [62, 50]) > 5);
});

test("a knob is where dragging begins: it leaves the size as it is, and lies in the scene", () => {
  for (const [at, angle] of [
    [128, 0],
    [128, 2.3],
    [3, 1],
    [253, 4],
  ] as const) {
    const bodies: CustomBody[] = [
      { shape: "ball", radius: 12, x: at, y: at, angle, dynamic: true },
      { shape: "bar", length: 60, thickness: 5, x: at, y: at, angle, dynamic: true },
      { shape: "jar", height: 50, x: at, y: at, angle, dynamic: true },
      { shape: "standing_sticks", length: 40, x: at, y: at, angle, dynamic: true },
    ];
    for (const one of bodies) {
      const { size, turn } = knobsOf(one);
      for (const knob of [size, turn ?? size]) assert.ok(knob.every((value) => value >= 5 && value <= 251));
      if (at === 128) assert.ok(Math.abs(sizeAt(one, size) - Number(Object.values(one)[1])) < 1e-6, one.shape);
    }
  }
});

test("a link's text holds the whole scene; one that is damaged is refused", async () => {
  const text = await textOfScene({ ...CUSTOM, name: "Größe" });
  assert.match(text, /^[\w-]+$/);
  assert.deepEqual(await readSceneText(text), { ...CUSTOM, name: "Größe" });
  await assert.rejects(readSceneText(text.slice(0, -9)));
  await assert.rejects(readSceneText("%"));
});

test("angles are exact to hundredths of a degree, and go round", () => {
  const turned = turnTo(select(fresh, BAR), -90.25, null);
  assert.equal(selectedBody(turned)!.angle, Math.round((269.75 / 180) * Math.PI * 1e4) / 1e4);
});
