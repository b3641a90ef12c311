// Plays puzzles off the main thread, with a memory and without. The page sends { task, memory }. The worker answers
// with any number of { arrived }, the loaded fraction of the weights, then with a Game or { failure }.

import { load } from "pathlight";
import type { Pathlight, TriedProposal } from "pathlight";

/** The model of fold 0 of the cross setup, which has seen 20 of the 25 kinds. */
const MODEL = "cross-0";

export interface Game {
  readonly task: string;
  readonly learned: TriedProposal[];
  readonly fresh: TriedProposal[];
  /** The memory after the game, as JSON. */
  readonly memory: string;
}

export interface Answer {
  readonly arrived?: number | null;
  readonly failure?: string;
  readonly game?: Game;
}

let loading: Promise<Pathlight> | null = null;
const answer = (answer: Answer) => postMessage(answer);

addEventListener("message", async ({ data: { task, memory: json } }: MessageEvent) => {
  try {
    loading ??= load({ model: MODEL, onProgress: (arrived) => answer({ arrived }) });
    const pathlight = await loading;
    const memory = pathlight.memory(json);
    const learned = [...pathlight.turn(task, { memory })];
    answer({ game: { task, learned, fresh: [...pathlight.turn(task)], memory: memory.toJson() } });
    memory.free();
  } catch (error) {
    loading = null;
    answer({ failure: (error as Error).message });
  }
});
