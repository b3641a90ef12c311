// The colours of the scene, light and dark, stand out from the paper, and the red ball from all else, also for people
// who lack a kind of cones.

import assert from "node:assert/strict";
import { test } from "node:test";
import { DARK_PALETTE, LIGHT_PALETTE } from "../../www/pkg/constants.js";

/**
 * Red, green and blue light of "#rrggbb", 0..1.
 * @param {string} colour
 */
function linear(colour) {
  return [1, 3, 5]
    .map((at) => parseInt(colour.slice(at, at + 2), 16) / 255)
    .map((channel) => (channel <= 0.04045 ? channel / 12.92 : ((channel + 0.055) / 1.055) ** 2.4));
}

/**
 * Relative luminance of "#rrggbb", after WCAG 2.
 * @param {string} colour
 */
function luminance(colour) {
  const [red, green, blue] = linear(colour);
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

for (const [name, palette] of Object.entries({ light: LIGHT_PALETTE, dark: DARK_PALETTE }))
  test(`every role stands out from the paper, three to one, ${name}`, () => {
    // A black body is seen by its rim, and the ring has one of ink.
    for (const role of /** @type {const} */ (["green", "blue", "purple", "gray", "rim", "red", "ink", "model"])) {
      const [one, other] = [luminance(palette[role]), luminance(palette.paper)].toSorted((a, b) => b - a);
      const contrast = (one + 0.05) / (other + 0.05);
      assert.ok(contrast >= 3, `${role}: ${contrast.toFixed(2)} to 1`);
    }
  });

/**
 * How red, green and blue light is seen without one kind of cones: linear RGB, after Machado, Oliveira and Fernandes
 * (2009), severity 1.
 */
const VISIONS = {
  "all cones": [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  protanopia: [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  deuteranopia: [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
  tritanopia: [
    [1.255528, -0.076749, -0.178779],
    [-0.078411, 0.930809, 0.147602],
    [0.004733, 0.691367, 0.3039],
  ],
};
/** A difference that is seen at a glance, CIE 1976. */
const LEAST_DIFFERENCE = 20;

/**
 * L*, a*, b* of "#rrggbb" as it is seen.
 * @param {string} colour
 * @param {number[][]} vision
 */
function seen(colour, vision) {
  const light = linear(colour);
  const [red, green, blue] = vision.map((row) =>
    Math.min(Math.max(row[0] * light[0] + row[1] * light[1] + row[2] * light[2], 0), 1),
  );
  const root = (/** @type {number} */ value) => (value > 0.008856 ? Math.cbrt(value) : 7.787 * value + 16 / 116);
  const x = root((0.4124 * red + 0.3576 * green + 0.1805 * blue) / 0.9505);
  const y = root(0.2126 * red + 0.7152 * green + 0.0722 * blue);
  const z = root((0.0193 * red + 0.1192 * green + 0.9505 * blue) / 1.0888);
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

for (const [name, palette] of Object.entries({ light: LIGHT_PALETTE, dark: DARK_PALETTE }))
  for (const [vision, matrix] of Object.entries(VISIONS))
    test(`the red ball is told apart from all else, ${name}, ${vision}`, () => {
      const ball = seen(palette.red, matrix);
      for (const role of /** @type {const} */ ([
        "paper",
        "green",
        "blue",
        "purple",
        "gray",
        "black",
        "ring",
        "model",
      ])) {
        const other = seen(palette[role], matrix);
        const difference = Math.hypot(...ball.map((value, axis) => value - other[axis]));
        assert.ok(difference >= LEAST_DIFFERENCE, `${role}: ${difference.toFixed(0)}`);
      }
    });
