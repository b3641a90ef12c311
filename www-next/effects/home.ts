// What has been recorded for the home page, and progress as a file.

import { addAttempts } from "../core/change/kept.ts";
import { setRecorded } from "../core/change/home.ts";
import { answered } from "../core/change/model.ts";
import { setNotice } from "../core/change/settings.ts";
import { isHome, progress } from "../core/derived/home.ts";
import { linesFrom } from "./keeping.ts";
import { keyOf } from "../simulator.ts";
import type { State } from "../core/state.ts";
import type { Effect, Store } from "../core/store.ts";
import type { Recorded } from "../core/change/home.ts";
import type { AttemptLine } from "../pkg/page/pathlight.js";

/** The page stands without the recording, so nobody is told if it cannot be read; the next visit tries again. */
export function recordedEffect(url: string): Effect<State> {
  return {
    needs: (state) => (isHome(state) ? [state.puzzle] : null),
    async run(store) {
      const { puzzle } = store.state;
      const recorded = store.state.recorded ?? (await read(url));
      if (!recorded) return;
      store.change(setRecorded, recorded);
      if (recorded.scene.task === puzzle.source) store.change(answered, puzzle.key, { futures: recorded.scene });
    },
  };
}

async function read(url: string): Promise<Recorded | null> {
  try {
    const response = await fetch(url);
    return response.ok ? await response.json() : null;
  } catch {
    return null;
  }
}

/** Saves all attempts, one a line, as the other tools write them. */
export function saveProgress({ state }: Store<State>): void {
  const lines = Object.values(state.kept.attempts).flat();
  download(new File([lines.map((line) => `${JSON.stringify(line)}\n`).join("")], "pathlight-progress.jsonl"));
}

/** How long attempts are simulated again before the page may move, ms. */
const SLICE = 20;

/** Adds the attempts of a file; those that the simulator does not confirm are counted and left out. */
export async function openProgress(store: Store<State>, file: File): Promise<void> {
  const attempts: Record<string, AttemptLine[]> = {};
  let unread = 0;
  let end = performance.now() + SLICE;
  // Files of other systems may begin with a mark of the order of their bytes.
  const texts = (await file.text()).replace(/^\uFEFF/, "").split("\n");
  for (const text of texts.filter((line) => line.trim())) {
    const read = lineFrom(text);
    if (read) (attempts[read.key] ??= []).push(read.line);
    else unread += 1;
    if (performance.now() < end) continue;
    await new Promise((resolve) => setTimeout(resolve));
    end = performance.now() + SLICE;
  }
  if (Object.keys(attempts).length === 0) return store.change(setNotice, { kind: "file_unread", name: file.name });
  const before = progress(store.state).attempts;
  store.change(addAttempts, attempts);
  const added = progress(store.state).attempts - before;
  store.change(setNotice, { kind: "file_read", attempts: added, unread });
}

function lineFrom(text: string): { line: AttemptLine; key: string } | null {
  try {
    const [line] = linesFrom([JSON.parse(text)]);
    const key = line ? keyOf(line) : null;
    return line && key ? { line, key } : null;
  } catch {
    return null;
  }
}

export function download(file: File): void {
  const url = URL.createObjectURL(file);
  Object.assign(document.createElement("a"), { href: url, download: file.name }).click();
  // Once the browser has taken it.
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}
