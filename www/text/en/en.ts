import { check } from "./check.ts";
import { data } from "./data.ts";
import { imagine } from "./imagine.ts";
import { make } from "./make.ts";
import { about } from "./about.ts";
import { home } from "./home.ts";
import { model } from "./model.ts";
import { page } from "./page.ts";
import { play } from "./play.ts";
import { predict } from "./predict.ts";
import { puzzle } from "./puzzle.ts";
import { share } from "./share.ts";

export const en = {
  language: "en",
  about,
  check,
  data,
  home,
  imagine,
  make,
  model,
  page,
  play,
  predict,
  puzzle,
  share,
};
