import { check } from "./check.ts";
import { make } from "./make.ts";
import { page } from "./page.ts";
import { play } from "./play.ts";
import { puzzle } from "./puzzle.ts";

export const en = { language: "en", check, make, page, play, puzzle };
