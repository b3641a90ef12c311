// Numbers look as the browser's own formats would write them, which are too slow for the first picture.

import assert from "node:assert/strict";
import { test } from "node:test";
import { format as german } from "../../www/text/de/format.js";
import { format as english } from "../../www/text/en/format.js";

const VALUES = [
  0, 0.04, 0.05, 0.25, 0.35, 1.005, 1.45, 2.5, 9.95, 12, 99.95, 999.5, 1000, 1234.5, 20_000, 1_234_567.89,
];
const SMALL = [1e-7, 3e-10];

for (const [language, { number, percent }] of Object.entries({ "en-GB": english, de: german }))
  for (const decimals of [0, 1, 2])
    test(`numbers and shares, ${language}, ${decimals} decimals`, () => {
      const digits = { minimumFractionDigits: decimals, maximumFractionDigits: decimals };
      const numbers = new Intl.NumberFormat(language, digits);
      const shares = new Intl.NumberFormat(language, { ...digits, style: "percent" });
      for (const value of [...VALUES, ...SMALL]) {
        assert.equal(number(value, decimals), numbers.format(value));
        assert.equal(percent(value, decimals), shares.format(value));
        if (value >= 1) assert.equal(number(-value, decimals), numbers.format(-value));
      }
    });
