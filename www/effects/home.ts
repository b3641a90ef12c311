// Loads the recording for the home page.

import { setRecorded } from "../core/change/home.ts";
import { answered } from "../core/change/model.ts";
import { isHome } from "../core/derived/home.ts";
import type { State } from "../core/state.ts";
import type { Effect } from "../core/store.ts";
import type { Recorded } from "../core/change/home.ts";

/** The page works without the recording, so a failure is not reported; the next visit tries again. */
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
