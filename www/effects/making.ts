// Turns the scene being made into the puzzle once a gesture has ended. Puzzle files hold the JSON of one puzzle or an
// array.

import { remade } from "../core/change/make.ts";
import { namedProblem } from "../core/derived/bodies.ts";
import { textOfScene } from "../core/scene-text.ts";
import { openPuzzle, problemsOf } from "../simulator.ts";
import { download, nameOf } from "./files.ts";
import type { BadScene } from "../core/change/settings.ts";
import type { Puzzle } from "../core/puzzle.ts";
import type { State } from "../core/state.ts";
import type { Effect } from "../core/store.ts";
import type { CustomScene } from "../pkg/page/pathlight.js";

export const makingEffect: Effect<State> = {
  needs: ({ make }) => (make && !make.drag ? [make.scene] : null),
  async run(store, signal) {
    const { make, puzzle } = store.state;
    if (!make || make.scene === puzzle.custom || problemsOf(make.scene).length) return;
    const next = make.scene === make.origin.custom ? make.origin : openPuzzle(make.scene);
    const { id } = next.about;
    const named = id === null ? { scene: await textOfScene(next.custom) } : { task: id };
    if (!signal.aborted) store.change(remade, next, named);
  },
};

/** Maximum size of a file, bytes: more would freeze the page. */
const MOST = 8e6;

export function savePuzzle(puzzle: Puzzle): void {
  const type = "application/json";
  download(new File([JSON.stringify(puzzle.custom, null, 1)], `pathlight-${nameOf(puzzle)}.json`, { type }));
}

/** Reads the puzzles of a file; returns the first problem if one is not playable. */
export async function readPuzzles(file: File): Promise<readonly CustomScene[] | BadScene> {
  const value =
    file.size > MOST
      ? null
      : await file
          .text()
          .then(JSON.parse)
          .catch(() => null);
  const scenes: CustomScene[] = Array.isArray(value) ? value : [value];
  for (const scene of scenes) {
    if (!scene || typeof scene !== "object") return { problem: null };
    const [problem] = problemsOf(scene);
    if (problem) return { problem: namedProblem(scene, problem) };
  }
  return scenes.length ? scenes : { problem: null };
}
