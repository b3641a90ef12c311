// Keeps one document in the browser's storage, shared by all tabs. Unreadable parts are left out.

import { NOTHING_KEPT, mergeKept, merged } from "../core/change/kept.ts";
import { setNotice } from "../core/change/settings.ts";
import { SETUPS } from "../model/shared.ts";
import { languageOf } from "../text/languages.ts";
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

/** Reads the valid parts of a document of this version. */
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
    model: SETUPS.find((setup) => setup === model) ?? SETUPS[0]!,
    language: languageOf(String(language)),
    theme: theme === "light" || theme === "dark" ? theme : null,
  };
}

/** Does not check whether the scene is playable; that happens where it is shown. */
function isKeptPuzzle(entry: [key: string, puzzle: any]): entry is [string, KeptPuzzle] {
  const [, puzzle] = entry;
  return Number.isFinite(puzzle?.changed) && (puzzle.scene === null || Array.isArray(puzzle.scene?.bodies));
}

function linesFrom(lines: any): AttemptLine[] {
  const isLine = ({ ball, simulator, status, steps, digest }: any) =>
    Array.isArray(ball) &&
    ball.length === 3 &&
    [...ball, simulator, steps].every(Number.isFinite) &&
    (status === "solved" || status === "not_solved") &&
    typeof digest === "string";
  return Array.isArray(lines) ? lines.filter((line) => line && isLine(line)).slice(0, ATTEMPT_LIMIT) : [];
}

/** Stores changes since the start, merged with what other tabs have stored meanwhile. */
export function keepingEffect(): Effect<State> {
  let stored: Kept | null = null;
  return {
    needs: ({ kept }) => [kept],
    run(store) {
      const { kept } = store.state;
      // The initial document is already stored. Unreadable parts of it stay until something changes.
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

/** Browsers may delete stored data, Safari after a week without a visit; some refrain if asked. */
function askToStay(): void {
  // Firefox would ask the person, and deletes nothing unless the disk is full.
  const isFirefox = globalThis.CSS?.supports("-moz-appearance: none");
  if (!isFirefox) globalThis.navigator?.storage?.persist?.().catch(() => {});
}

/** Follows changes that other tabs store, also those that a page in the back/forward cache has missed. */
export function listenToOtherTabs(store: Store<State>, signal: AbortSignal): void {
  const merge = () => store.change(mergeKept, readKept());
  addEventListener("storage", ({ key }) => key === KEY && merge(), { signal });
  addEventListener("pageshow", ({ persisted }) => persisted && merge(), { signal });
}
