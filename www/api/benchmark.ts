// What needs no weights: tasks and scenes, the simulator, solutions, verification, the figures, and drawing.
// `Pathlight` of index.ts inherits it.

import * as wasm from "../pkg/worker/pathlight.js";
import { cleanUp, failure } from "./errors.ts";

/** The scene that was painted last: its rollouts are kept for the next frames. */
let painted: { task: wasm.Puzzle; open: wasm.OpenPuzzle } | null = null;

/**
 * The benchmark and its simulator. A task is named by its id; a custom scene, an object, takes the place of any task.
 */
export class Benchmark {
  /** Returns the 25 templates, each with the ids of its 100 tasks. */
  templates(): wasm.Template[] {
    return wasm.templates();
  }

  /** Returns the tasks of one of PHYRE's folds; `number`: 0 to 9. */
  fold(setup: wasm.Setup, number: number): wasm.Fold {
    return wasm.fold(setup, number);
  }

  /** Returns how hard a task of the benchmark is: the share of uniform valid balls that solve it. */
  difficulty(task: string): wasm.Difficulty {
    return wasm.difficulty(String(task));
  }

  /**
   * Returns the share of uniform valid balls that solve each task, 0..1: of the first template's tasks in turn, then of
   * the next template's.
   */
  solveRates(): Float64Array {
    return wasm.solveRates();
  }

  /** Returns what a puzzle is: its id as a task, its name and digest as a custom scene, and its scene. */
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

  /** Returns a task in the form of custom scenes, in which it can be changed and played. */
  customScene(task: wasm.Puzzle): wasm.CustomScene {
    return wasm.customScene(task);
  }

  /**
   * Returns reasons why a value cannot be played as a custom scene; an empty list if it can. Not all at once: one for
   * each body, and overlaps only when nothing else is wrong. Takes a fraction of a millisecond, and never throws.
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
   * Returns the image that the four nets see, `[5, 64, 64]`: the channels green object, blue goal, purple goal, gray
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
   * Simulates a task with a ball, or without one. An invalid ball is no error: its rollout has the status `invalid`.
   */
  simulate(task: wasm.Puzzle, ball: wasm.Ball | null = null): wasm.Rollout {
    return wasm.simulate(task, ball);
  }

  /**
   * Maps where a ball of a radius, 2 to 32 px, solves a task. Tries one of the 64 x 64 cells each time the next value
   * is asked for; a value is the fraction of the cells that has been tried, and `outcomes`, which returns a copy of the
   * map at the time of the call, also after the last value: for each cell 0 untried, 1 invalid, 2 not solved, 3 solved.
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
   * Searches the whole action space for solutions. Tries one valid ball each time the next value is asked for; `found`
   * returns what is known at the time of the call, also after the last value.
   */
  *solutionSearch(task: wasm.Puzzle): Generator<{ found: () => wasm.FoundSolutions }, void, void> {
    const search = new wasm.SolutionSearch(task);
    for (const found of stepping(search, () => search.found())) yield { found };
  }

  /**
   * Returns how many of the 27 balls within a pixel in x, y and radius may be placed, and how many of these solve. Few
   * solve if the ball does so by luck.
   */
  luck(task: wasm.Puzzle, ball: wasm.Ball): wasm.Luck {
    return wasm.luck(task, ball);
  }

  /**
   * Simulates a scene, with a ball if one is given, and returns the line that `pathlight verify` and `verifyAttempt`
   * check.
   */
  attemptLine(task: wasm.Puzzle, ball: wasm.Ball | null = null): wasm.AttemptLine {
    return wasm.attemptLine(task, ball);
  }

  /** Simulates the attempt of a line again, and returns whether it is the same to the bit. Never throws. */
  verifyAttempt(line: unknown): wasm.Verification {
    return wasm.verifyAttempt(line);
  }

  /**
   * Returns PHYRE's auccess of an agent, 0..100. `firstSolved`: for each task the number, from 1, of the first attempt
   * that solved it; null if none did.
   */
  auccess(firstSolved: (number | null)[]): number {
    return wasm.auccess(firstSolved);
  }

  /** Returns the soft IoU of two maps of 64 x 64 values in 0..1: from 0 (nothing in common) to 1 (equal). */
  softIou(one: wasm.GridMap, other: wasm.GridMap): number {
    return wasm.softIou(valuesOf(one), valuesOf(other));
  }

  /**
   * Draws the scene of a task so that it fills a square canvas; with a valid ball, at a step of what that leads to (a
   * fraction lies between two steps), with the paths up to there, over `marks`, balls that are only marked. In a
   * browser only, as all methods that draw.
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
   * Draws a map into a canvas of 64 x 64 pixels, which the page scales up. The colours run from 0, which is
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

/** Other things than arrays would be read as memory of the wasm. */
function valuesOf(map: wasm.GridMap): wasm.GridMap {
  if (Array.isArray(map) || (ArrayBuffer.isView(map) && !(map instanceof DataView))) return map;
  throw failure("bad_map", "A map is an array of 64 x 64 numbers.");
}

/**
 * Advances a search by a step for each value, which reads what is known: at the time of the call, and after the end.
 */
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
