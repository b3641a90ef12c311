import { check } from "./check.ts";
import { make } from "./make.ts";
import { about } from "./about.ts";
import { home } from "./home.ts";
import { page } from "./page.ts";
import { play } from "./play.ts";
import { puzzle } from "./puzzle.ts";
import { share } from "./share.ts";
import type { Text } from "../text.ts";

export const de: Text = { language: "de", about, check, home, make, page, play, puzzle, share };
