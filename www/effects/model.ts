// Questions to the worker, as effects. Each effect lists what its question depends on.

import { sought } from "../core/change/check.ts";
import { isSettled, making } from "../core/change/make.ts";
import { answered, setModel } from "../core/change/model.ts";
import { atLastStep } from "../core/change/walkthrough.ts";
import { attempts, verdict } from "../core/derived/duel.ts";
import { isAlone, shownPanel } from "../core/derived/hidden.ts";
import { isHome } from "../core/derived/home.ts";
import { questioned, wantsGuess } from "../core/derived/placing.ts";
import { WorkerError } from "../model/client.ts";
import { sharedModel } from "../model/shared.ts";
import { problemsOf } from "../simulator.ts";
import type { State } from "../core/state.ts";
import type { Effect, Store } from "../core/store.ts";
import type { ModelFiles } from "../model/shared.ts";

/** Number of futures that fan out. */
const FUTURES = 40;

export function modelEffects(files: ModelFiles): Effect<State>[] {
  const shared = ({ kept }: State) => sharedModel(files, kept.model);
  const clientOf = (store: Store<State>) => shared(store.state).client;
  // Searches need a worker, but no weights. Loading again after a failure starts another worker.
  const ifAlive = ({ model, kept }: State, ...needs: unknown[]) =>
    model.kind === "off" || (model.kind === "failed" && model.failure.code === "crashed")
      ? null
      : [kept.model, model.kind === "failed", ...needs];
  const ifReady = ({ model, kept }: State, ...needs: unknown[]) =>
    model.kind === "ready" ? [kept.model, ...needs] : null;

  const following: Effect<State> = {
    needs: ({ kept }) => [kept.model],
    run: (store, signal) => shared(store.state).follow((model) => store.change(setModel, model), signal),
  };

  const loading: Effect<State> = {
    // Its progress and its end must not restart it.
    needs: ({ model, kept }) => (model.kind === "loading" ? [kept.model] : null),
    run: (store) => void shared(store.state).start(),
  };

  // One ball more than has been played, so that the next drop need not wait.
  const turn: Effect<State> = {
    needs: (state) =>
      (isAlone(state) && !atLastStep(state)) || shownPanel(state) === "make"
        ? null
        : ifReady(state, state.puzzle, attempts(state).length),
    run: (store, signal) => {
      const turnUpTo = attempts(store.state).length + 1;
      return ask(store, async ({ key, source }) => {
        try {
          return { turn: await clientOf(store).call("turn", [source, turnUpTo], signal), turnUpTo };
        } catch (error) {
          // Stop waiting for a ball that will not come.
          if (!signal.aborted) store.change(answered, key, { turnUpTo });
          throw error;
        }
      });
    },
  };

  const candidates: Effect<State> = {
    needs: (state) => (state.route.step === "imagined" ? ifReady(state, state.puzzle) : null),
    run: (store, signal) =>
      ask(store, async ({ source }) => ({ candidates: await clientOf(store).call("candidates", [source], signal) })),
  };

  // Keep the answer even if the ball has moved meanwhile: otherwise no guess would appear until a drag ends.
  const guess: Effect<State> = {
    needs: (state) => {
      const ball = questioned(state);
      return ball && wantsGuess(state) ? ifReady(state, state.puzzle, ...ball) : null;
    },
    run: (store) =>
      ask(store, async ({ source }) => {
        const of = questioned(store.state)!;
        const imagined = await clientOf(store).call("imagineBall", [source, of], null);
        return { guess: imagined && { of, imagined } };
      }),
  };

  // Also for the scene being changed. Like the guess, the answer is kept even if the scene has changed meanwhile.
  const maps: Effect<State> = {
    needs: (state) => {
      const { scene } = making(state);
      return problemsOf(scene).length ? null : ifReady(state, state.puzzle, isSettled(state) ? null : scene);
    },
    run: (store) =>
      ask(store, ({ source }) => {
        const asked = isSettled(store.state) ? source : making(store.state).scene;
        return clientOf(store).call("imagine", [asked], null);
      }),
  };

  const solutions: Effect<State> = {
    needs: (state) => (state.check ? ifAlive(state, state.puzzle, state.check.radius) : null),
    run: (store, signal) =>
      ask(store, async ({ key, source }) => {
        const onUpdate = (found: State["answers"]["solutions"]) => store.change(answered, key, { solutions: found });
        await clientOf(store).call("solutions", [source, store.state.check!.radius], signal, onUpdate);
        return {};
      }),
  };

  const search: Effect<State> = {
    needs: (state) => (state.check?.seeking ? ifAlive(state, state.puzzle) : null),
    run: (store, signal) =>
      ask(store, async ({ key, source }) => {
        await clientOf(store).call("search", [source], signal, (found) => store.change(sought, key, found));
        return {};
      }),
  };

  const luck: Effect<State> = {
    needs: (state) => {
      const told = verdict(state);
      return told?.facts.ending.solved ? ifAlive(state, state.puzzle, told.facts.line.ball) : null;
    },
    run: (store, signal) =>
      ask(store, async ({ source }) => {
        const of = verdict(store.state)!.facts.line.ball!;
        return { luck: { of, found: await clientOf(store).call("luck", [source, of], signal) } };
      }),
  };

  // The futures of the first puzzle are recorded, so that they need not wait for the weights.
  const futures: Effect<State> = {
    needs: (state) =>
      isHome(state) && state.recorded?.scene.task !== state.puzzle.source ? ifReady(state, state.puzzle) : null,
    run: (store, signal) =>
      ask(store, async ({ source }) => ({ futures: await clientOf(store).call("futures", [source, FUTURES], signal) })),
  };

  return [following, loading, turn, futures, candidates, guess, maps, luck, solutions, search];
}

/** Stores an answer about the open puzzle. Crashes are already reported elsewhere. */
async function ask(
  store: Store<State>,
  question: (puzzle: State["puzzle"]) => Promise<Partial<State["answers"]>>,
): Promise<void> {
  const { puzzle } = store.state;
  try {
    store.change(answered, puzzle.key, await question(puzzle));
  } catch (error) {
    if (error instanceof WorkerError && error.failure.code !== "broken") return;
    throw error;
  }
}
