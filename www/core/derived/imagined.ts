// What the model imagines, as displayed: maps over the scene, candidates, and its favourite compared with the outcome.

import { meanDistance } from "./duel.ts";
import { isHidden, shownPanel } from "./hidden.ts";
import { guess } from "./placing.ts";
import { ended, rollouts } from "./run.ts";
import { STEP_LAYERS, atLastStep } from "../change/walkthrough.ts";
import { CELL_SIZE, GRID_SIDE } from "../../pkg/constants.ts";
import type { MapName, RolloutFacts, View } from "../../pkg/page/pathlight.js";
import type { Point } from "../change/placement.ts";
import type { State } from "../state.ts";

/** How many of the likeliest balls show their imagined path; more would cover each other. */
const MOST_HINTS = 40;
/** Opacities of the least and the most likely of them. */
const [FAINTEST, STRONGEST] = [0.15, 0.6];

/** The maps shown over the scene; none during a prediction, which they would spoil. */
export function shownLayers(state: State): readonly MapName[] {
  const { step, layers } = state.route;
  const panel = shownPanel(state);
  if (panel === "predict") return ended(state) && state.run!.balls[0]!.ball === null ? ["base"] : [];
  return panel === "imagine" && step ? STEP_LAYERS[step] : layers;
}

/** The paths that the model imagines for one ball, if they are shown. */
export function shownGuess(state: State): ReturnType<typeof guess> {
  const panel = shownPanel(state);
  if (panel === "imagine" && !atLastStep(state)) return null;
  if (panel === "predict") return ended(state) ? guess(state) : null;
  return (state.kept.guess || panel !== "play") && !isHidden(state, "guess") ? guess(state) : null;
}

/** The imagined paths of the likeliest balls that the model considers, in the step that shows them. */
export function hints(state: State): View["hints"] {
  const { candidates } = state.answers;
  if (state.route.step !== "imagined" || shownPanel(state) !== "imagine" || !candidates) return [];
  const shown = candidates.toSorted((one, other) => other.probability - one.probability).slice(0, MOST_HINTS);
  const most = shown[0]?.probability ?? 1;
  return shown.map(({ object, probability }) => ({
    object,
    opacity: FAINTEST + (STRONGEST - FAINTEST) * (probability / most),
  }));
}

/** Outcome of the model's favourite ball, and the mean error of its guess, px. */
export interface Favourite {
  readonly facts: RolloutFacts;
  readonly chance: number;
  readonly off: number;
}

/** Null until the last step of the walkthrough has ended. */
export function favourite(state: State): Favourite | null {
  const [facts] = rollouts(state);
  const imagined = guess(state)?.imagined;
  if (!atLastStep(state) || !ended(state) || !facts?.paths || !imagined) return null;
  const off = meanDistance(imagined.object, facts.paths.object);
  return { facts, chance: imagined.probability, off };
}

/** How well two masks or maps agree, 0..1: intersection over union, cell by cell. */
export function overlap(one: Float32Array, other: Float32Array): number {
  let [both, either] = [0, 0];
  for (let cell = 0; cell < one.length; cell++) {
    both += Math.min(one[cell]!, other[cell]!);
    either += Math.max(one[cell]!, other[cell]!);
  }
  return either > 0 ? both / either : 1;
}

/** The strongest place of a map, px; and the farthest from there, or from a start, that is half as strong or more. */
export function extent(map: Float32Array, start: Point | null): { from: Point; to: Point } {
  const peak = map.indexOf(map.reduce((most, value) => Math.max(most, value)));
  const from = start ?? placeOf(peak);
  const far = (cell: number) => Math.hypot(placeOf(cell)[0] - from[0], placeOf(cell)[1] - from[1]);
  let farthest = peak;
  for (let cell = 0; cell < map.length; cell++)
    if (map[cell]! >= map[peak]! / 2 && far(cell) > far(farthest)) farthest = cell;
  return { from, to: placeOf(farthest) };
}

function placeOf(cell: number): Point {
  return [((cell % GRID_SIDE) + 0.5) * CELL_SIZE, (Math.floor(cell / GRID_SIDE) + 0.5) * CELL_SIZE];
}
