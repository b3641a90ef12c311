// Files that a person saves and opens.

import { attemptCount, openAttempts } from "../core/change/kept.ts";
import { setNotice } from "../core/change/settings.ts";
import { attemptsTable, attemptsText, parsedLines } from "../core/derived/files.ts";
import { MAPS, SCENE_SIZE } from "../pkg/constants.ts";
import { mapTile, readAttempt } from "../simulator.ts";
import type { Puzzle } from "../core/puzzle.ts";
import type { State } from "../core/state.ts";
import type { Store } from "../core/store.ts";
import type { AttemptLine } from "../pkg/page/pathlight.js";

/** Time for reading attempts before the page may respond to the person, ms. */
const SLICE = 30;
/** Maximum size of a file of attempts, bytes: more than one person can produce. */
const LARGEST = 2e7;
/** Height of the captions under a picture, px. */
const CAPTION = 28;

export function saveAttempts({ kept }: State): void {
  download(new File([attemptsText(kept.attempts)], "pathlight-attempts.jsonl", { type: "application/jsonl" }));
}

export function saveTable(state: State): void {
  download(new File([attemptsTable(state)], `pathlight-${nameOf(state.puzzle)}.csv`, { type: "text/csv" }));
}

/** Saves the maps over the scene side by side, with captions. */
export function saveMaps(store: Store<State>): void {
  const { puzzle, answers, text } = store.state;
  const names = MAPS.filter((name) => answers.maps?.[name]);
  const canvas = document.createElement("canvas");
  canvas.width = names.length * SCENE_SIZE;
  canvas.height = SCENE_SIZE + CAPTION;
  const context = canvas.getContext("2d")!;
  context.fillStyle = "#fff";
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.fillStyle = "#000";
  context.font = "16px sans-serif";
  context.textAlign = "center";
  names.forEach((name, index) => {
    const left = index * SCENE_SIZE;
    context.drawImage(mapTile(puzzle, name, answers.maps![name]!, false), left, 0);
    context.fillText(text.imagine.paper[name], left + SCENE_SIZE / 2, SCENE_SIZE + 20);
  });
  const file = `pathlight-${nameOf(puzzle)}.png`;
  canvas.toBlob((blob) => (blob ? download(new File([blob], file)) : store.change(setNotice, { kind: "no_picture" })));
}

export async function openFile(store: Store<State>, file: File): Promise<void> {
  const text = file.size > LARGEST ? "" : await file.text();
  const { attempts, unread } = await attemptsOf([...parsedLines(text)], (share) =>
    store.change(setNotice, { kind: "opening", share: Math.floor(10 * share) / 10 }),
  );
  const found = attemptCount(attempts);
  if (found === 0) return store.change(setNotice, { kind: "no_attempts", file: file.name });
  const before = attemptCount(store.state.kept.attempts);
  store.change(openAttempts, attempts);
  const added = attemptCount(store.state.kept.attempts) - before;
  store.change(setNotice, { kind: "opened", added, found, unread });
}

/** Reads attempts by puzzle. Each is simulated again, so that only true attempts are kept. */
export async function attemptsOf(values: readonly unknown[], onProgress: (share: number) => void = () => {}) {
  const attempts: Record<string, AttemptLine[]> = {};
  let unread = 0;
  let rest = performance.now() + SLICE;
  for (const [index, value] of values.entries()) {
    const read = typeof value === "object" && value !== null ? readAttempt(value) : null;
    if (read) (attempts[read.key] ??= []).push(read.line);
    else unread += 1;
    if (performance.now() < rest) continue;
    onProgress(index / values.length);
    await new Promise((resolve) => setTimeout(resolve));
    rest = performance.now() + SLICE;
  }
  return { attempts, unread };
}

/** The number or the name of a puzzle, as part of the name of a file. */
export function nameOf({ about: { id, name } }: Puzzle): string {
  const words = (id ?? name ?? "").toLowerCase().match(/[\p{L}\p{N}]+/gu);
  return words?.join("-") ?? "puzzle";
}

export function download(file: File): void {
  const url = URL.createObjectURL(file);
  Object.assign(document.createElement("a"), { href: url, download: file.name }).click();
  // Wait until the browser has fetched it.
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}
