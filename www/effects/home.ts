// Loads the recording for the home page, and begins its show.

import { setRecorded } from "../core/change/home.ts";
import { answered } from "../core/change/model.ts";
import { isHome } from "../core/derived/home.ts";
import type { State } from "../core/state.ts";
import type { Effect } from "../core/store.ts";
import type { Recorded } from "../core/change/home.ts";

/** Maximum time for which the show waits for the model to load, ms: on few cores the two would hold each other up. */
const PATIENCE = 2000;

export function homeEffects(url: string): Effect<State>[] {
  // The page works without the recording, so a failure is not reported; the next visit tries again.
  const recording: Effect<State> = {
    needs: (state) => (isHome(state) && !state.recorded ? [state.puzzle] : null),
    async run(store) {
      const recorded = await read(url);
      if (recorded) store.change(setRecorded, recorded);
    },
  };

  const show: Effect<State> = {
    needs: (state) =>
      isHome(state) && state.recorded?.scene.task === state.puzzle.source ? [state.puzzle, isDecided(state)] : null,
    async run(store, signal) {
      const { puzzle, recorded } = store.state;
      if (!isDecided(store.state))
        await new Promise((resolve) => {
          setTimeout(resolve, PATIENCE);
          signal.addEventListener("abort", resolve);
        });
      if (!signal.aborted) store.change(answered, puzzle.key, { futures: recorded!.scene });
    },
  };

  return [recording, show];
}

/** Whether it is known if there is a model. */
function isDecided({ model }: State): boolean {
  return model.kind === "ready" || model.kind === "failed";
}

async function read(url: string): Promise<Recorded | null> {
  try {
    const response = await fetch(url);
    return response.ok ? await response.json() : null;
  } catch {
    return null;
  }
}
