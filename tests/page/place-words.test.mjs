// Places in words of the scene: no two bodies of a scene have one name, and a place is told by the body beside it.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { afterEach, test } from "node:test";
import { bodyNames, mapWords, placeWords } from "../../www/model/place-words.js";
import { text, useLanguage } from "../../www/text/text.js";
import { initSync, scene, templates } from "../../www/pkg/pathlight.js";

initSync({ module: await readFile(new URL("../../www/pkg/pathlight_bg.wasm", import.meta.url)) });

const FUNNEL = scene("00007:008");
/** The bodies of a scene, each as the place that it takes. */
const namesIn = (of) => bodyNames(of).map((body) => text.places.beside("on", false, body));

afterEach(() => useLanguage("en"));

test("no two bodies of a task have the same name, in no language", async () => {
  const tasks = templates().flatMap((template) => [template.tasks[0], template.tasks[8]]);
  for (const language of /** @type {const} */ (["en", "de"])) {
    await useLanguage(language);
    for (const task of tasks) {
      const names = namesIn(scene(task));
      assert.equal(new Set(names).size, names.length, `${task}: ${names}`);
    }
  }
});

test("a place is told by the body beside it, or by the part of the scene", () => {
  const names = namesIn(FUNNEL);
  for (const name of ["left slope", "right slope", "green ball"])
    assert.ok(names.includes(`on the ${name}`), `${names}`);
  const [ball] = FUNNEL.bodies.filter(({ role }) => role === "green");
  assert.equal(placeWords([ball.x, ball.y], FUNNEL), "on the green ball");
  const [left] = FUNNEL.bodies.filter((_, index) => names[index] === "on the left slope");
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

test("a place is told in German", async () => {
  await useLanguage("de");
  const [left] = FUNNEL.bodies.filter((_, index) => namesIn(FUNNEL)[index] === "auf der linken Schräge");
  assert.equal(placeWords([left.x, left.y + 9], FUNNEL), "knapp über der linken Schräge");
  assert.equal(placeWords([128, 90], FUNNEL), "in der Mitte");
  assert.equal(placeWords([20, 100], FUNNEL), "links auf halber Höhe");
  assert.equal(text.places.map("oben links", "in der Mitte"), "vor allem oben links, aber auch in der Mitte");
  /** @type {import("../../www/text/en/places.js").Named} */
  const bar = { kind: "upright", role: "gray", among: { axis: "x", place: 1, count: 5 } };
  assert.equal(text.places.beside("right", true, bar), "knapp rechts neben dem 2. grauen senkrechten Balken von links");
});
