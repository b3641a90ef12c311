// What a person asks for that needs more than a change of the state: another puzzle has to be opened.

import { opened, routed } from "./core/change/route.ts";
import { again, drop, togglePlaying } from "./core/change/run.ts";
import { setNotice } from "./core/change/settings.ts";
import { nextStep } from "./core/derived/duel.ts";
import { neighbour, nextTask } from "./core/derived/next.ts";
import { benchmark, openPuzzle } from "./simulator.ts";
import type { Link } from "./core/change/route.ts";
import type { State } from "./core/state.ts";
import type { Store } from "./core/store.ts";

export function follow(store: Store<State>, link: Link): void {
  const task = link.task ?? store.state.puzzle.about.id ?? suggested(store.state);
  if (task === store.state.puzzle.about.id) return store.change(routed, { ...link, task });
  try {
    store.change(opened, { ...link, task }, openPuzzle(task));
  } catch {
    store.change(setNotice, { kind: "no_task", task });
  }
}

/** The large button. */
export function takeNextStep(store: Store<State>): void {
  switch (nextStep(store.state)) {
    case "drop":
      return store.change(drop);
    case "pause":
    case "play":
      return store.change(togglePlaying);
    case "again":
      return store.change(again);
    case "next":
      return goNext(store);
  }
}

/** A puzzle that is new to person and model. */
export function goNext(store: Store<State>): void {
  goTo(store, suggested(store.state));
}

/** The puzzle some places further in the list of all. */
export function goBy(store: Store<State>, places: number): void {
  goTo(store, neighbour(benchmark(), store.state.puzzle.about.id, places));
}

export function goTo(store: Store<State>, task: string): void {
  follow(store, { ...store.state.route, task, ball: null });
}

function suggested({ puzzle, kept }: State): string {
  return nextTask(benchmark(), puzzle.about.id, (task) => task in kept.attempts);
}
