// Actions that need more than a change of the state: another puzzle has to be opened.

import { endIntro } from "./core/change/home.ts";
import { making } from "./core/change/make.ts";
import { linkTo, openPanel, opened, routed } from "./core/change/route.ts";
import { again, drop, togglePlaying } from "./core/change/run.ts";
import { letRun } from "./core/change/sketch.ts";
import { setNotice } from "./core/change/settings.ts";
import { nextStep } from "./core/derived/duel.ts";
import { canGoOn } from "./core/derived/hidden.ts";
import { isHome } from "./core/derived/home.ts";
import { FIRST_TASK, neighbour, nextTask } from "./core/derived/next.ts";
import { namedProblem } from "./core/derived/bodies.ts";
import { readSceneText, textOfScene } from "./core/scene-text.ts";
import { SETUPS } from "./model/shared.ts";
import { benchmark, openPuzzle, problemsOf } from "./simulator.ts";
import type { BadScene } from "./core/change/settings.ts";
import type { Kept } from "./core/change/kept.ts";
import type { Link } from "./core/change/route.ts";
import type { Puzzle } from "./core/puzzle.ts";
import type { State } from "./core/state.ts";
import type { Store } from "./core/store.ts";
import type { CustomScene } from "./pkg/page/pathlight.js";

export function follow(store: Store<State>, link: Link): void {
  if (link.scene !== null) return void followScene(store, link, link.scene);
  const { route, puzzle } = store.state;
  if (link.task === null && isHome(store.state)) return;
  const task = link.task ?? homeTask(store.state.kept);
  if (link.task !== null && task === route.task) return store.change(routed, link);
  // The puzzle in the picture on the home page is open already.
  const named = task === puzzle.about.id ? puzzle : existing(task);
  if (named) store.change(opened, link, named);
  else store.change(setNotice, { kind: "no_task", task });
}

/** Opens a task; null if there is none of this number. */
export function existing(task: string): Puzzle | null {
  try {
    return openPuzzle(task);
  } catch {
    return null;
  }
}

async function followScene(store: Store<State>, link: Link, text: string): Promise<void> {
  const { route } = store.state;
  if (text === route.scene) return store.change(routed, { ...link, task: null });
  const puzzle = await puzzleOf(text);
  // The person has moved on meanwhile.
  if (store.state.route !== route) return;
  if ("problem" in puzzle) store.change(setNotice, { kind: "bad_scene", ...puzzle });
  else store.change(opened, { ...link, task: null }, puzzle);
}

/** Reads the puzzle of a link's text, or why it is not playable. */
export async function puzzleOf(text: string): Promise<Puzzle | BadScene> {
  const value = await readSceneText(text).catch(() => null);
  const scene = value as CustomScene;
  if (value === null || typeof value !== "object") return { problem: null };
  const [problem] = problemsOf(scene);
  return problem ? { problem: namedProblem(scene, problem) } : openPuzzle(scene);
}

/** Opens a playable custom puzzle. */
export async function openScene(store: Store<State>, scene: CustomScene): Promise<void> {
  const text = await textOfScene(scene);
  follow(store, linkTo(store.state, { scene: text }));
}

/** Handles the large button. */
export function takeNextStep(store: Store<State>): void {
  switch (nextStep(store.state)) {
    case "try":
      if (problemsOf(making(store.state).scene).length === 0) store.change(openPanel, "play");
      return;
    case "start":
      return store.change(endIntro);
    case "drop":
      return store.change(drop);
    case "run":
      return store.change(letRun);
    case "pause":
    case "play":
      return store.change(togglePlaying);
    case "again":
    case "back":
    case "make":
      return store.change(again);
    case "next":
      return goNext(store);
  }
}

/** Opens a puzzle that is new to person and model. */
function goNext(store: Store<State>): void {
  if (store.state.route.lesson.length) return goBy(store, 1);
  goTo(store, suggested(store.state));
}

/** The puzzle some places further in the lesson, or else in the list of all puzzles. */
export function puzzleBy({ route: { lesson }, puzzle }: State, places: number): string | undefined {
  return neighbour(lesson.length ? lesson : benchmark().tasks, puzzle.about.id, places, lesson.length === 0);
}

export function goBy(store: Store<State>, places: number): void {
  const task = puzzleBy(store.state, places);
  if (task && canGoOn(store.state)) goTo(store, task);
}

export function goTo(store: Store<State>, task: string): void {
  follow(store, linkTo(store.state, { task }));
}

function suggested({ puzzle, kept }: State): string {
  return nextTask(benchmark(kept.model), puzzle.about.id, (task) => task in kept.attempts);
}

/** The puzzle in the picture on the home page: new to person and model. */
export function homeTask({ attempts, model }: Kept): string {
  const isFirst = model === SETUPS[0] && !(FIRST_TASK in attempts);
  return isFirst ? FIRST_TASK : nextTask(benchmark(model), null, (task) => task in attempts);
}
