// The part of the package that needs no weights: tasks and scenes, the simulator, solutions, verification, figures, and
// drawing. `Pathlight` of index.ts extends it.

import * as wasm from "../pkg/worker/pathlight.js";
import { cleanUp, failure } from "./errors.ts";

/** The last painted scene. Its rollouts are kept for the next frames. */
let painted: { task: wasm.Puzzle; open: wasm.OpenPuzzle } | null = null;

/**
 * The benchmark and its simulator. A task is named by its id; a custom scene, an object, can be passed instead of any
 * id.
 */
export class Benchmark {
  /** Returns the 25 templates, each with the ids of its 100 tasks. */
  templates(): wasm.Template[] {
    return wasm.templates();
  }

  /** Returns the tasks of one of PHYRE's folds; `number` is 0 to 9. */
  fold(setup: wasm.Setup, number: number): wasm.Fold {
    return wasm.fold(setup, number);
  }

  /** Returns how hard a task of the benchmark is: the share of uniform valid balls that solve it. */
  difficulty(task: string): wasm.Difficulty {
    return wasm.difficulty(String(task));
  }

  /**
   * Returns the share of uniform valid balls that solve each task, 0..1, for all tasks in order, template by template.
   */
  solveRates(): Float64Array {
    return wasm.solveRates();
  }

  /** Describes a puzzle: its id if it is a task, its name and digest if it is a custom scene, and its scene. */
  about(task: wasm.Puzzle): wasm.About {
    const open = new wasm.OpenPuzzle(task);
    try {
      return open.about();
    } finally {
      cleanUp(() => open.free());
    }
  }

  /** Returns the scene of a task. */
  scene(task: wasm.Puzzle): wasm.Scene {
    return this.about(task).scene;
  }

  /** Returns a task as a custom scene, which can be changed and played. */
  customScene(task: wasm.Puzzle): wasm.CustomScene {
    return wasm.customScene(task);
  }

  /**
   * Returns reasons why a value cannot be played as a custom scene; an empty list if it can. The list is not
   * exhaustive: it has one problem per body, and overlaps only if nothing else is wrong. Takes a fraction of a
   * millisecond and never throws.
   */
  sceneProblems(scene: unknown): wasm.SceneProblem[] {
    return wasm.sceneProblems(scene);
  }

  /** Returns the SHA-256 of a custom scene without its name, in hexadecimal: equal for scenes that play alike. */
  sceneDigest(scene: wasm.CustomScene): string {
    return wasm.sceneDigest(scene);
  }

  /** Returns the limits of custom scenes. */
  sceneLimits(): wasm.SceneLimits {
    return wasm.sceneLimits();
  }

  /**
   * Returns the input image of the four nets, `[5, 64, 64]`: the channels green object, blue goal, purple goal, gray
   * and black, each of zeros and ones, row 0 at the bottom.
   */
  raster(task: wasm.Puzzle): Float32Array {
    return wasm.raster(task);
  }

  /** Returns why a ball is invalid in a task, as a phrase; undefined if it is valid. */
  whyInvalid(task: wasm.Puzzle, ball: wasm.Ball): string | undefined {
    return wasm.whyInvalid(task, ball);
  }

  /**
   * Simulates a task with a ball or without one. An invalid ball is not an error: its rollout has the status `invalid`.
   */
  simulate(task: wasm.Puzzle, ball: wasm.Ball | null = null): wasm.Rollout {
    return wasm.simulate(task, ball);
  }

  /**
   * Maps where a ball of a given radius, 2 to 32 px, solves a task. Each value taken from the generator tries one of
   * the 64 x 64 cells; the value is the fraction of cells tried so far. `outcomes` returns a copy of the current map,
   * also after the last value: for each cell 0 untried, 1 invalid, 2 not solved, 3 solved.
   */
  *solveMap(
    task: wasm.Puzzle,
    radius: number,
  ): Generator<{ progress: number; outcomes: () => Uint8Array }, void, void> {
    const map = new wasm.SolveMap(task, radius);
    for (const outcomes of stepping(map, () => map.outcomes()))
      yield { progress: map.progress(), outcomes: () => outcomes().slice() };
  }

  /**
   * Searches the whole action space for solutions. Each value taken from the generator tries one valid ball. `found`
   * returns the current results, also after the last value.
   */
  *solutionSearch(task: wasm.Puzzle): Generator<{ found: () => wasm.FoundSolutions }, void, void> {
    const search = new wasm.SolutionSearch(task);
    for (const found of stepping(search, () => search.found())) yield { found };
  }

  /**
   * Returns how many of the 27 balls within a pixel in x, y and radius are valid, and how many of these solve. If few
   * solve, the ball solves by luck.
   */
  luck(task: wasm.Puzzle, ball: wasm.Ball): wasm.Luck {
    return wasm.luck(task, ball);
  }

  /**
   * Simulates a scene, with a ball if one is given, and returns a line that `pathlight verify` and `verifyAttempt` can
   * check.
   */
  attemptLine(task: wasm.Puzzle, ball: wasm.Ball | null = null): wasm.AttemptLine {
    return wasm.attemptLine(task, ball);
  }

  /** Repeats the simulation of an attempt, and returns whether it is the same to the bit. Never throws. */
  verifyAttempt(line: unknown): wasm.Verification {
    return wasm.verifyAttempt(line);
  }

  /**
   * Returns PHYRE's auccess of an agent, 0..100. `firstSolved` holds for each task the number, from 1, of the first
   * attempt that solved it, or null if none did.
   */
  auccess(firstSolved: (number | null)[]): number {
    return wasm.auccess(firstSolved);
  }

  /** Returns the soft IoU of two maps of 64 x 64 values in 0..1: from 0 (nothing in common) to 1 (equal). */
  softIou(one: wasm.GridMap, other: wasm.GridMap): number {
    return wasm.softIou(valuesOf(one), valuesOf(other));
  }

  /**
   * Draws the scene of a task on a square canvas, which it fills. With a valid ball, draws the given step of its
   * rollout (fractions interpolate between steps) and the paths up to there, over `marks`: balls that are only marked.
   * Like all methods that draw, it works only in a browser.
   */
  paintScene(
    context: CanvasRenderingContext2D,
    task: wasm.Puzzle,
    options: { dark?: boolean; ball?: wasm.Ball | null; step?: number; marks?: wasm.Ball[] } = {},
  ): void {
    const { dark = false, ball = null, step = 0, marks = [] } = options;
    if (!ball) return wasm.paintThumbnail(context, task, dark);
    if (painted?.task !== task) {
      const open = new wasm.OpenPuzzle(task);
      painted?.open.free();
      painted = { task, open };
    }
    const still = { ball: null, valid: true, knob: 0, whole: false, opacity: 1 };
    const view = { ...still, step, dark, marks };
    painted.open.paint(context, [{ ball, of_model: false }], view, []);
  }

  /**
   * Draws a map on a canvas of 64 x 64 pixels, to be scaled up by the page. The colours run from 0, which is
   * transparent, to `max`.
   */
  paintMap(
    context: CanvasRenderingContext2D,
    mapName: wasm.MapName,
    map: wasm.GridMap,
    { max = 1, dark = false }: { max?: number; dark?: boolean } = {},
  ): void {
    wasm.paintMap(context, String(mapName) as wasm.MapName, valuesOf(map), max, dark);
  }
}

/** Anything but an array would be read as memory of the wasm. */
function valuesOf(map: wasm.GridMap): wasm.GridMap {
  if (Array.isArray(map) || (ArrayBuffer.isView(map) && !(map instanceof DataView))) return map;
  throw failure("bad_map", "A map is an array of 64 x 64 numbers.");
}

/** Advances a search by one step per value. The value reads the current results, also after the end. */
function* stepping<Known>(search: { advance(): boolean; free(): void }, known: () => Known): Generator<() => Known> {
  let final: Known | null = null;
  try {
    for (let more = true; more;) {
      more = search.advance();
      yield () => final ?? known();
    }
  } finally {
    cleanUp(() => {
      final = known();
      search.free();
    });
  }
}
