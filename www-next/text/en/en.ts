import { page } from "./page.ts";
import { play } from "./play.ts";
import { puzzle } from "./puzzle.ts";

export const en = { language: "en", page, play, puzzle };
