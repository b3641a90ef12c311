import { check } from "./check.ts";
import { make } from "./make.ts";
import { about } from "./about.ts";
import { home } from "./home.ts";
import { page } from "./page.ts";
import { play } from "./play.ts";
import { puzzle } from "./puzzle.ts";
import { share } from "./share.ts";

export const en = { language: "en", about, check, home, make, page, play, puzzle, share };
