// Advances the walkthrough automatically, once the content of a step has loaded and been shown for a while.

import { tourOn } from "../core/change/walkthrough.ts";
import { ended } from "../core/derived/run.ts";
import type { State } from "../core/state.ts";
import type { Effect } from "../core/store.ts";

/** Time to read a sentence and look, ms. */
const LOOK = 4500;

export const walkthroughEffect: Effect<State> = {
  needs: (state) => (state.touring && isShown(state) ? [state.route.step] : null),
  run: (store, signal) =>
    new Promise((resolve) => {
      const timer = setTimeout(() => resolve(store.change(tourOn)), LOOK);
      signal.addEventListener("abort", () => resolve(clearTimeout(timer)), { once: true });
    }),
};

function isShown(state: State): boolean {
  const { step } = state.route;
  if (step === "run") return ended(state);
  return step === "imagined" ? state.answers.candidates !== null : state.answers.maps !== null;
}
