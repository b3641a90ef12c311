// What a person asks for that needs more than a change of the state: another puzzle has to be opened.

import { making } from "./core/change/make.ts";
import { openPanel, opened, routed } from "./core/change/route.ts";
import { again, drop, togglePlaying } from "./core/change/run.ts";
import { setNotice } from "./core/change/settings.ts";
import { nextStep } from "./core/derived/duel.ts";
import { neighbour, nextTask } from "./core/derived/next.ts";
import { namedProblem } from "./core/derived/bodies.ts";
import { readSceneText, textOfScene } from "./core/scene-link.ts";
import { benchmark, openPuzzle, problemsOf } from "./simulator.ts";
import type { BadScene } from "./core/change/settings.ts";
import type { Link } from "./core/change/route.ts";
import type { Puzzle } from "./core/puzzle.ts";
import type { State } from "./core/state.ts";
import type { Store } from "./core/store.ts";
import type { CustomScene } from "./pkg/page/pathlight.js";

export function follow(store: Store<State>, link: Link): void {
  if (link.scene !== null) return void followScene(store, link, link.scene);
  const task = link.task ?? store.state.puzzle.about.id ?? suggested(store.state);
  if (task === store.state.puzzle.about.id) return store.change(routed, { ...link, task });
  try {
    store.change(opened, { ...link, task }, openPuzzle(task));
  } catch {
    store.change(setNotice, { kind: "no_task", task });
  }
}

async function followScene(store: Store<State>, link: Link, text: string): Promise<void> {
  const { route } = store.state;
  if (text === route.scene) return store.change(routed, { ...link, task: null });
  const puzzle = await puzzleOf(text);
  // The person has gone on meanwhile.
  if (store.state.route !== route) return;
  if ("problem" in puzzle) store.change(setNotice, { kind: "bad_scene", ...puzzle });
  else store.change(opened, { ...link, task: null }, puzzle);
}

/** The puzzle of a link's text, or why there is none. */
export async function puzzleOf(text: string): Promise<Puzzle | BadScene> {
  const value = await readSceneText(text).catch(() => null);
  const scene = value as CustomScene;
  if (value === null || typeof value !== "object") return { problem: null };
  const [problem] = problemsOf(scene);
  return problem ? { problem: namedProblem(scene, problem) } : openPuzzle(scene);
}

/** Opens a custom puzzle that may be played. */
export async function openScene(store: Store<State>, scene: CustomScene): Promise<void> {
  follow(store, { ...store.state.route, task: null, scene: await textOfScene(scene), ball: null });
}

/** The large button. */
export function takeNextStep(store: Store<State>): void {
  switch (nextStep(store.state)) {
    case "try":
      if (problemsOf(making(store.state).scene).length === 0) store.change(openPanel, "play");
      return;
    case "drop":
      return store.change(drop);
    case "pause":
    case "play":
      return store.change(togglePlaying);
    case "again":
    case "make":
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
  follow(store, { ...store.state.route, task, scene: null, ball: null });
}

function suggested({ puzzle, kept }: State): string {
  return nextTask(benchmark(), puzzle.about.id, (task) => task in kept.attempts);
}
