// Hidden parts: those that a lesson hides and, in a challenge, everything that would give the answer away.

import { panelsOf } from "../change/route.ts";
import { playerSolvedAt } from "./duel.ts";
import type { Hideable, Panel } from "../change/route.ts";
import type { State } from "../state.ts";

export function isHidden(state: State, part: Hideable): boolean {
  const { challenge, hide } = state.route;
  if (hide.includes(part)) return true;
  if ((part === "guess" || part === "imagine") && isHidden(state, "model")) return true;
  // A challenged player plays alone until they have solved the puzzle.
  return challenge !== null && part !== "play" && part !== "puzzles" && playerSolvedAt(state) === null;
}

/** Whether there is a way to other puzzles. */
export function canGoOn(state: State): boolean {
  return !isHidden(state, "puzzles") || state.route.lesson.length > 1;
}

/** Whether the open puzzle is the last one of a lesson. */
export function endsLesson({ route: { lesson }, puzzle }: State): boolean {
  return lesson.length > 0 && lesson.at(-1) === puzzle.about.id;
}

/** The panels that are shown, at least one. */
export function shownPanels(state: State): Panel[] {
  const shown = panelsOf(state.text).filter((panel) => !isHidden(state, panel));
  return shown.length > 0 ? shown : ["play"];
}

/** The panel that is open. */
export function shownPanel(state: State): Panel {
  const shown = shownPanels(state);
  return shown.find((panel) => panel === state.route.panel) ?? shown[0]!;
}

/** Whether the player plays without the model. */
export function isAlone(state: State): boolean {
  return state.kept.alone || state.route.hide.includes("model") || state.route.challenge !== null;
}
