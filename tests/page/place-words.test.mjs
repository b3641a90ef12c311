// Places in words of the scene: no two bodies of a scene have one name, and a place is told by the body beside it.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { bodyNames, mapWords, placeWords } from "../../www/model/place-words.js";
import { initSync, scene, templates } from "../../www/pkg/pathlight.js";

initSync({ module: await readFile(new URL("../../www/pkg/pathlight_bg.wasm", import.meta.url)) });

const FUNNEL = scene("00007:008");

test("no two bodies of a task have the same name", () => {
  for (const { tasks } of templates()) {
    for (const task of [tasks[0], tasks[8]]) {
      const names = bodyNames(scene(task));
      assert.equal(new Set(names).size, names.length, `${task}: ${names}`);
    }
  }
});

test("a place is told by the body beside it, or by the part of the scene", () => {
  const names = bodyNames(FUNNEL);
  assert.ok(names.includes("left slope") && names.includes("right slope") && names.includes("green ball"), `${names}`);
  const [ball] = FUNNEL.bodies.filter(({ role }) => role === "green");
  assert.equal(placeWords([ball.x, ball.y], FUNNEL), "on the green ball");
  const [left] = FUNNEL.bodies.filter((_, index) => names[index] === "left slope");
  assert.equal(placeWords([left.x, left.y + 9], FUNNEL), "just above the left slope");
  assert.equal(placeWords([left.x, left.y - 24], FUNNEL), "below the left slope");
  assert.equal(placeWords([128, 90], FUNNEL), "in the middle");
  assert.equal(placeWords([20, 100], FUNNEL), "half way up on the left");
});

test("a map is told by its peak, and by another place where it is strong", () => {
  const map = new Float32Array(64 * 64);
  const at = (x, y) => Math.floor(y / 4) * 64 + Math.floor(x / 4);
  map[at(128, 90)] = 0.5;
  assert.equal(mapWords(map, FUNNEL), "most sure in the middle");
  map[at(20, 100)] = 0.4;
  assert.equal(mapWords(map, FUNNEL), "most sure in the middle, also sure half way up on the left");
  map[at(20, 100)] = 0.2;
  assert.equal(mapWords(map, FUNNEL), "most sure in the middle");
});
