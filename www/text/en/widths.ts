// Distances in widths of a ball.

import { formatsOf } from "../formats.ts";
import { widthsIn } from "../widths.ts";

const { number } = formatsOf("en-GB");

export const balls = widthsIn({
  hair: "a hair",
  quarter: "a quarter of a ball",
  half: "half a ball",
  one: "a ball’s width",
  more: (count) => `${number(count)} balls`,
});
