// An open puzzle as the core sees it: pure questions about balls. `simulator.ts` answers them by wasm, a test by a few
// lines of its own.

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
  /** The id of a task, or a custom scene: what the worker is asked about. */
  readonly source: Source;
  /** By which attempts are kept: the id of the task, or the digest of the custom scene. */
  readonly key: string;
  readonly about: About;
  readonly scene: Scene;
  /** The scene in the form in which it can be changed. */
  readonly custom: CustomScene;
  whyInvalid(ball: Ball): InvalidBall | null;
  /** The nearest ball of the same radius that may be placed, if one is not far away. */
  nearestPlace(ball: Ball): Ball | null;
  /** What a ball leads to; null: the scene alone. */
  rollout(ball: Ball | null): RolloutFacts;
  /** The real paths of that as masks. */
  pathMasks(ball: Ball | null): PathMasks;
  /** A path of the green object, x, y, x, y, … in px, as a mask. */
  sketchMask(path: Float64Array): Float32Array;
}

export function sameBall(one: Ball | null, other: Ball | null): boolean {
  return one === other || Boolean(one && other && one.every((value, index) => value === other[index]));
}
