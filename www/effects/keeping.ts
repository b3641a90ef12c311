// What the browser keeps: one document in its storage, shared by all tabs. What cannot be read of it is left out.

import { NOTHING_KEPT, mergeKept, merged } from "../core/change/kept.ts";
import { setNotice } from "../core/change/settings.ts";
import { LANGUAGES } from "../text/language.ts";
import { ATTEMPT_LIMIT } from "../pkg/constants.ts";
import type { Kept, KeptPuzzle } from "../core/change/kept.ts";
import type { State } from "../core/state.ts";
import type { Effect, Store } from "../core/store.ts";
import type { AttemptLine } from "../pkg/page/pathlight.js";

const KEY = "pathlight";

/** Reads the kept document. A browser may refuse access to its storage. */
export function readKept(): Kept {
  try {
    return keptFrom(JSON.parse(localStorage.getItem(KEY) ?? "null"));
  } catch {
    return NOTHING_KEPT;
  }
}

/** Takes what it understands of a document of this version. */
export function keptFrom(document: any): Kept {
  if (document?.version !== NOTHING_KEPT.version) return NOTHING_KEPT;
  const { attempts, puzzles, forgotten, guess, alone, live, model, language, theme } = document;
  const lists = Object.entries(attempts ?? {}).map(([key, lines]) => [key, linesFrom(lines)] as const);
  return {
    version: NOTHING_KEPT.version,
    attempts: Object.fromEntries(lists.filter(([, lines]) => lines.length > 0)),
    puzzles: Object.fromEntries(Object.entries(puzzles ?? {}).filter(isKeptPuzzle)),
    forgotten: Number.isFinite(forgotten) ? forgotten : 0,
    guess: guess !== false,
    alone: alone === true,
    live: live !== false,
    model: model === "cross" ? "cross" : "within",
    language: LANGUAGES.includes(language) ? language : null,
    theme: theme === "light" || theme === "dark" ? theme : null,
  };
}

/** Whether its scene may be played is asked where it is shown. */
function isKeptPuzzle(entry: [key: string, puzzle: any]): entry is [string, KeptPuzzle] {
  const [, puzzle] = entry;
  return Number.isFinite(puzzle?.changed) && (puzzle.scene === null || Array.isArray(puzzle.scene?.bodies));
}

export function linesFrom(lines: any): AttemptLine[] {
  const isLine = ({ ball, simulator, status, steps, digest }: any) =>
    Array.isArray(ball) &&
    ball.length === 3 &&
    [...ball, simulator, steps].every(Number.isFinite) &&
    (status === "solved" || status === "not_solved") &&
    typeof digest === "string";
  return Array.isArray(lines) ? lines.filter((line) => line && isLine(line)).slice(0, ATTEMPT_LIMIT) : [];
}

/** Keeps what has changed since the start, together with what other tabs have kept meanwhile. */
export function keepingEffect(): Effect<State> {
  let stored: Kept | null = null;
  return {
    needs: ({ kept }) => [kept],
    run(store) {
      const { kept } = store.state;
      // What the page began with is stored already, and what could not be read of it stays until something is new.
      if (stored !== null && kept !== stored) write(store, kept);
      stored = kept;
    },
  };
}

function write(store: Store<State>, kept: Kept): void {
  try {
    const { attempts, puzzles, forgotten } = merged(readKept(), kept);
    localStorage.setItem(KEY, JSON.stringify({ ...kept, attempts, puzzles, forgotten }));
    askToStay();
  } catch (error) {
    console.warn(error);
    store.change(setNotice, { kind: "storage_full" });
  }
}

/** Browsers may delete what a page keeps, Safari after a week without a visit; some stay off it when they are asked. */
function askToStay(): void {
  // Firefox would ask the person, and deletes nothing unless the disk is full.
  const isFirefox = globalThis.CSS?.supports("-moz-appearance: none");
  if (!isFirefox) globalThis.navigator?.storage?.persist?.().catch(() => {});
}

/** Follows what other tabs keep. */
export function listenToOtherTabs(store: Store<State>, signal: AbortSignal): void {
  const onStorage = ({ key }: StorageEvent) => key === KEY && store.change(mergeKept, readKept());
  addEventListener("storage", onStorage, { signal });
}
