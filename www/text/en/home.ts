// The home page.

import { formatsOf } from "../formats.ts";
import { balls } from "./widths.ts";
import type { Difficulty, Progress, Standing } from "../../core/derived/home.ts";

const { counted, number, percent } = formatsOf("en-GB");

const LEVELS: Record<Difficulty, string> = { easy: "easy", medium: "medium", hard: "hard" };

export const home = {
  title: "Watch a tiny AI imagine what happens. Then beat it.",
  about:
    "Place one red ball so that the green object touches its striped goal for 3 seconds. The AI is a small model that runs in your browser and has never seen this puzzle either.",
  play: "Play the animation",
  pause: "Pause the animation",

  waiting: "You can play already: click or tap in the picture.",
  imagine: (futures: number) => `It imagines ${futures} futures …`,
  pick: (chance: number) => `… and picks one: ${percent(chance)} sure.`,
  real: "Now its ball really drops.",
  result: (solved: boolean, off: number, radius: number) =>
    `${solved ? "Solved" : "Missed"}: its guess was ${balls(off, radius)} off. Your turn: click or tap in the picture.`,

  day: "Puzzle of the day",
  unsolved: "The model never solved this",
  canYou: (facts: string) => `Can you? ${facts}`,
  make: "Make your own",
  makeHint: "Drag things around, play it, send it to a friend",
  facts: (puzzle: string, difficulty: Difficulty) => `${puzzle}, ${LEVELS[difficulty]}`,
  howHard: (difficulty: Difficulty, rate: number) =>
    `${difficulty.charAt(0).toUpperCase()}${LEVELS[difficulty].slice(1)}: ` +
    (rate > 0.002 ? `1 ball in ${Math.round(1 / rate)} solves it.` : "fewer than 1 ball in 500 solve it."),

  kinds: (count: number) => `${count} kinds, each with a puzzle that is new to the model`,
  number: "Or by number:",
  /** "Puzzle 3 of 20 · 1 solved, 1 missed" */
  standing: (next: number, of: number, played: Standing["played"]) => {
    const solved = played.filter((one) => one.solved).length;
    const missed = played.length - solved;
    const found = [solved && `${solved} solved`, missed && `${missed} missed`].filter(Boolean).join(", ");
    return `Puzzle ${next} of ${of} · ${found}`;
  },
  results: "How good is the model? All results",
  learns: "Watch it learn",

  progress: "Your progress",
  soFar: ({ tried, solved, attempts }: Progress) =>
    `So far you have tried ${counted(tried, "puzzle", "puzzles")} and solved ${number(solved)}, with ${counted(attempts, "ball", "balls")}`,
  keeps:
    "Everything stays on this device, in this browser. Safari forgets it after seven days without a visit; a file keeps it.",
  save: "Save to a file",
  open: "Open a file",
  forget: "Forget everything",
  keep: "Keep it",
  forgetHint: "This browser then knows none of your balls and solutions any more. That cannot be undone.",
};
