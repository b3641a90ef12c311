// The bodies of a scene under a pointer: their outlines are those that the simulator knows, and dragging a knob to
// where it is changes nothing.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { initSync, scene as sceneOf } from "../../www/pkg/pathlight.js";
import { SIZES, bodyAt, directionTo, distanceTo, extentOf, knobsOf, sizeTo } from "../../www/editor/body-geometry.js";

initSync({ module: await readFile(new URL("../../www/pkg/pathlight_bg.wasm", import.meta.url)) });

/** @typedef {import("../../www/pkg/pathlight.js").CustomBody} CustomBody */

const PLACE = { x: 120, y: 100, angle: 0.5, dynamic: false };
/** @type {CustomBody[]} */
const BODIES = [
  { shape: "ball", radius: 20, ...PLACE },
  { shape: "bar", length: 60, thickness: 8, ...PLACE },
  { shape: "jar", height: 50, ...PLACE },
  { shape: "standing_sticks", length: 70, ...PLACE },
];

/** The corners of a body's shapes in the scene, px. */
function corners(body) {
  const ball = { shape: "ball", radius: 5, x: 20, y: 230, angle: 0, dynamic: true };
  const { bodies } = sceneOf(/** @type {any} */ ({ version: 1, body1: 0, body2: 1, bodies: [ball, body] }));
  const { x, y, angle, parts } = bodies[1];
  const [sin, cos] = [Math.sin(angle), Math.cos(angle)];
  const polygons = parts.flatMap((part) => ("polygon" in part ? part.polygon : []));
  return polygons.map(([u, v]) => /** @type {[number, number]} */ ([x + u * cos - v * sin, y + u * sin + v * cos]));
}

test("the corners of a body lie on the outline that a pointer meets, and within its extent", () => {
  for (const body of BODIES.slice(1)) {
    const found = corners(body);
    assert.ok(found.length >= 4);
    for (const corner of found) {
      // The corners of a stick stick out of the capsule that a pointer meets; those of a wall's foot lie in the jar.
      assert.ok(distanceTo(body, corner) < 0.8, `${body.shape}: ${distanceTo(body, corner)}`);
      assert.ok(Math.hypot(corner[0] - body.x, corner[1] - body.y) < extentOf(body) + 0.1, body.shape);
    }
    assert.ok(Math.max(...found.map((corner) => distanceTo(body, corner))) > -0.1, body.shape);
  }
});

test("a knob that is dragged to its own place changes neither size nor angle", () => {
  for (const body of BODIES) {
    const { size, turn } = knobsOf(body, 256);
    const [first] = SIZES[body.shape];
    assert.ok(Math.abs(sizeTo(body, size) - body[first]) < 1e-9, body.shape);
    assert.equal(turn === null, body.shape === "ball");
    if (!turn) continue;
    const turned = { ...body, angle: body.angle + 0.3 };
    const difference = directionTo(body, knobsOf(turned, 256).turn ?? [0, 0]) - directionTo(body, turn);
    assert.ok(Math.abs(difference - (0.3 * 180) / Math.PI) < 1e-9, body.shape);
  }
});

test("knobs stay in the scene", () => {
  for (const body of BODIES)
    for (const [x, y] of [
      [1, 1],
      [255, 128],
      [128, 255],
    ]) {
      const { size, turn } = knobsOf({ ...body, x, y }, 256);
      for (const place of [size, turn ?? size]) assert.ok(place.every((value) => value >= 5 && value <= 251));
    }
});

test("of several bodies a pointer grabs the one that it is in, and of those the smallest", () => {
  const [ball, , jar] = BODIES;
  const small = { ...ball, radius: 3, y: 120, x: 112 };
  assert.equal(bodyAt([jar, small], [112, 120], 4), 1);
  assert.equal(bodyAt([jar, small], [112 + 6, 120 - 6], 4), 0);
  assert.equal(bodyAt([ball], [120 + 23, 100], 4), 0, "within reach");
  assert.equal(bodyAt([ball], [120 + 25, 100], 4), null);
});
