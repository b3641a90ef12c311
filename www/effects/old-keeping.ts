// Imports data that earlier versions stored in the browser: attempts as JSON lines, one entry per task and one for all
// custom scenes, a list of custom puzzles, and whether the model's guess is shown. It is imported once. The old entries
// are then deleted, including attempts at deleted custom scenes, which can no longer be played.

import { choose, keepPuzzles, openAttempts } from "../core/change/kept.ts";
import { parsedLines } from "../core/derived/files.ts";
import { digestOf } from "../simulator.ts";
import { attemptsOf } from "./files.ts";
import { readKept } from "./keeping.ts";
import type { State } from "../core/state.ts";
import type { Store } from "../core/store.ts";
import type { CustomScene } from "../pkg/page/pathlight.js";

const ATTEMPTS = "pathlight.attempts.";
const PUZZLES = "pathlight.own-puzzles";
const GUESS = "pathlight.guess";

export async function takeOver(store: Store<State>): Promise<void> {
  try {
    const ofAttempts = Object.keys(localStorage).filter((key) => key.startsWith(ATTEMPTS));
    const keys = [...ofAttempts, PUZZLES, GUESS];
    if (keys.every((key) => localStorage.getItem(key) === null)) return;
    const puzzles = oldPuzzles(localStorage.getItem(PUZZLES));
    const lines = ofAttempts.flatMap((key) => oldLines(localStorage.getItem(key), puzzles));
    const { attempts } = await attemptsOf(lines);
    if (localStorage.getItem(GUESS) === "off") store.change(choose, { guess: false });
    store.change(keepPuzzles, puzzles, 0);
    store.change(openAttempts, attempts);
    // By then the new document has been stored.
    await new Promise((resolve) => setTimeout(resolve));
    const kept = readKept();
    const isKept = Object.keys(attempts).every((key) => kept.attempts[key]);
    // If there is no room for both, keep the old data.
    if (isKept) for (const key of keys) localStorage.removeItem(key);
  } catch (error) {
    // A browser without storage has nothing to import.
    console.warn(error);
  }
}

function oldPuzzles(text: string | null): Record<string, CustomScene> {
  const list = parsed(text);
  const entries = (Array.isArray(list) ? list : []).map((scene) => [digestOf(scene), scene] as const);
  return Object.fromEntries(entries.filter(([digest]) => digest !== null));
}

/** Damaged data is skipped, so that it does not block the rest. */
function parsed(text: string | null): unknown {
  try {
    return JSON.parse(text ?? "null");
  } catch {
    return null;
  }
}

/** The person's own attempts. Attempts at a custom scene named it by its digest. */
function oldLines(text: string | null, puzzles: Record<string, CustomScene>): unknown[] {
  const own = [...parsedLines(text ?? "")].filter((line: any) => line?.by === undefined || line.by === "player");
  return own.map((line: any) => (typeof line?.scene === "string" ? { ...line, scene: puzzles[line.scene] } : line));
}
