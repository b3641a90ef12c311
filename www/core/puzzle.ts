// An open puzzle as seen by the core: pure functions of balls. `simulator.ts` implements it with wasm, tests with a few
// lines.

import type {
  About,
  Ball,
  CustomScene,
  InvalidBall,
  PathMasks,
  Puzzle as Source,
  RolloutFacts,
  Scene,
} from "../pkg/page/pathlight.js";

export interface Puzzle {
  /** The id of a task, or a custom scene: the form in which the worker takes it. */
  readonly source: Source;
  /** Key under which attempts are kept: the id of the task, or the digest of the custom scene. */
  readonly key: string;
  readonly about: About;
  readonly scene: Scene;
  /** The scene in the form in which it can be changed. */
  readonly custom: CustomScene;
  whyInvalid(ball: Ball): InvalidBall | null;
  /** The nearest valid ball of the same radius, unless it is far away. */
  nearestPlace(ball: Ball): Ball | null;
  /** The rollout of a ball; null for the scene without a ball. */
  rollout(ball: Ball | null): RolloutFacts;
  /** The paths of that rollout as masks. */
  pathMasks(ball: Ball | null): PathMasks;
  /** A path of the green object, x, y, x, y, … in px, as a mask. */
  sketchMask(path: Float64Array): Float32Array;
}

export function sameBall(one: Ball | null, other: Ball | null): boolean {
  return one === other || Boolean(one && other && one.every((value, index) => value === other[index]));
}
