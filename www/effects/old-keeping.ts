// What people have in their browser from before: attempts as JSON lines, an entry for each task and one for all custom
// scenes, and a list of custom puzzles. It is taken over once; then the old entries go.

import { keepPuzzles, openAttempts } from "../core/change/kept.ts";
import { parsedLines } from "../core/derived/files.ts";
import { digestOf } from "../simulator.ts";
import { attemptsOf } from "./files.ts";
import { readKept } from "./keeping.ts";
import type { State } from "../core/state.ts";
import type { Store } from "../core/store.ts";
import type { CustomScene } from "../pkg/page/pathlight.js";

const ATTEMPTS = "pathlight.attempts.";
const PUZZLES = "pathlight.own-puzzles";

export async function takeOver(store: Store<State>): Promise<void> {
  try {
    const keys = Object.keys(localStorage).filter((key) => key.startsWith(ATTEMPTS) || key === PUZZLES);
    if (keys.length === 0) return;
    const puzzles = oldPuzzles(localStorage.getItem(PUZZLES));
    const lines = keys.filter((key) => key !== PUZZLES).flatMap((key) => oldLines(localStorage.getItem(key), puzzles));
    const { attempts } = await attemptsOf(lines);
    store.change(keepPuzzles, puzzles, 0);
    store.change(openAttempts, attempts);
    // By then it has been kept.
    await new Promise((resolve) => setTimeout(resolve));
    const kept = readKept();
    const isKept = Object.keys(attempts).every((key) => kept.attempts[key]);
    // Where there is no room for both, what is old stays.
    if (isKept) for (const key of keys) localStorage.removeItem(key);
  } catch (error) {
    // A browser that forbids its storage has nothing to take over.
    console.warn(error);
  }
}

function oldPuzzles(text: string | null): Record<string, CustomScene> {
  const scenes: CustomScene[] = JSON.parse(text ?? "[]");
  const entries = scenes.map((scene) => [digestOf(scene), scene] as const);
  return Object.fromEntries(entries.filter(([digest]) => digest !== null));
}

/** The person's own attempts. Those at a custom scene named it by its digest. */
function oldLines(text: string | null, puzzles: Record<string, CustomScene>): unknown[] {
  const own = [...parsedLines(text ?? "")].filter((line: any) => line?.by === undefined || line.by === "player");
  return own.map((line: any) => (typeof line?.scene === "string" ? { ...line, scene: puzzles[line.scene] } : line));
}
