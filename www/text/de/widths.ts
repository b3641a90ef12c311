// Distances in widths of a ball.

import { formatsOf } from "../formats.ts";
import { widthsIn } from "../widths.ts";

const { number } = formatsOf("de");

export const balls = widthsIn({
  hair: "ein Haar",
  quarter: "eine Viertelkugel",
  half: "eine halbe Kugel",
  one: "eine Kugelbreite",
  more: (count) => `${number(count)} Kugeln`,
});
