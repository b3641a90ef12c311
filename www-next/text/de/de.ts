import { check } from "./check.ts";
import { make } from "./make.ts";
import { page } from "./page.ts";
import { play } from "./play.ts";
import { puzzle } from "./puzzle.ts";
import type { Text } from "../text.ts";

export const de: Text = { language: "de", check, make, page, play, puzzle };
