// The colours of the scene, light and dark, stand out from the paper.

import assert from "node:assert/strict";
import { test } from "node:test";
import { DARK_PALETTE, LIGHT_PALETTE } from "../../www/pkg/constants.js";

/**
 * Relative luminance of "#rrggbb", after WCAG 2.
 * @param {string} colour
 */
function luminance(colour) {
  const [red, green, blue] = [1, 3, 5]
    .map((at) => parseInt(colour.slice(at, at + 2), 16) / 255)
    .map((channel) => (channel <= 0.04045 ? channel / 12.92 : ((channel + 0.055) / 1.055) ** 2.4));
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

for (const [name, palette] of Object.entries({ light: LIGHT_PALETTE, dark: DARK_PALETTE }))
  test(`every role stands out from the paper, three to one, ${name}`, () => {
    // A black body is seen by its rim, and the ring has one of ink.
    for (const role of /** @type {const} */ (["green", "blue", "purple", "gray", "rim", "red", "ink"])) {
      const [one, other] = [luminance(palette[role]), luminance(palette.paper)].toSorted((a, b) => b - a);
      const contrast = (one + 0.05) / (other + 0.05);
      assert.ok(contrast >= 3, `${role}: ${contrast.toFixed(2)} to 1`);
    }
  });
