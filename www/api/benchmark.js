// What needs no weights: tasks and scenes, the simulator, solutions, verification, the figures, and drawing. The class
// `Pathlight` of index.js inherits it.

import * as wasm from "../pkg/pathlight.js";
import { cleanUp } from "./clean-up.js";
import { failure } from "./failure.js";

/** @typedef {import("../pkg/pathlight.js").About} About */
/** @typedef {import("../pkg/pathlight.js").AttemptLine} AttemptLine */
/** @typedef {import("../pkg/pathlight.js").Ball} Ball */
/** @typedef {import("../pkg/pathlight.js").Difficulty} Difficulty */
/** @typedef {import("../pkg/pathlight.js").Fold} Fold */
/** @typedef {import("../pkg/pathlight.js").FoundSolutions} FoundSolutions */
/** @typedef {import("../pkg/pathlight.js").GridMap} GridMap */
/** @typedef {import("../pkg/pathlight.js").Luck} Luck */
/** @typedef {import("../pkg/pathlight.js").Maps} Maps */
/** @typedef {import("../pkg/pathlight.js").CustomScene} CustomScene */
/** @typedef {import("../pkg/pathlight.js").Puzzle} Puzzle */
/** @typedef {import("../pkg/pathlight.js").Rollout} Rollout */
/** @typedef {import("../pkg/pathlight.js").Scene} Scene */
/** @typedef {import("../pkg/pathlight.js").SceneLimits} SceneLimits */
/** @typedef {import("../pkg/pathlight.js").SceneProblem} SceneProblem */
/** @typedef {import("../pkg/pathlight.js").Setup} Setup */
/** @typedef {import("../pkg/pathlight.js").MapName} MapName */
/** @typedef {import("../pkg/pathlight.js").Template} Template */
/** @typedef {import("../pkg/pathlight.js").Verification} Verification */

/**
 * The benchmark and its simulator. A task is named by its id; a custom scene, which is an object, takes the place of
 * any task.
 */
export class Benchmark {
  /**
   * Returns the 25 templates, each with the ids of its 100 tasks.
   * @returns {Template[]}
   */
  templates() {
    return wasm.templates();
  }

  /**
   * Returns the tasks of one of PHYRE's folds.
   * @param {Setup} setup
   * @param {number} number 0 to 9
   * @returns {Fold}
   */
  fold(setup, number) {
    return wasm.fold(setup, number);
  }

  /**
   * Returns how hard a task of the benchmark is: the share of uniform valid balls that solve it.
   * @param {string} task
   * @returns {Difficulty}
   */
  difficulty(task) {
    return wasm.difficulty(String(task));
  }

  /**
   * Returns the share of uniform valid balls that solve each task, 0..1: of the first template's tasks in turn, then of
   * the next template's.
   * @returns {Float64Array}
   */
  solveRates() {
    return wasm.solveRates();
  }

  /**
   * Returns what a puzzle is: its id as a task (null for a custom scene), its name as a custom scene (null for a task,
   * or if it has none) and a description of its scene.
   * @param {Puzzle} task
   * @returns {About}
   */
  about(task) {
    const game = new wasm.Game(task);
    try {
      return game.about();
    } finally {
      cleanUp(() => game.free());
    }
  }

  /**
   * Returns the scene of a task.
   * @param {Puzzle} task
   * @returns {Scene}
   */
  scene(task) {
    return wasm.scene(task);
  }

  /**
   * Returns a task in the form of custom scenes, in which it can be changed and played.
   * @param {Puzzle} task
   * @returns {CustomScene}
   */
  customScene(task) {
    return wasm.customScene(task);
  }

  /**
   * Returns reasons why a value cannot be played as a custom scene; an empty list if it can. Not all at once: one for
   * each body, and overlaps only when nothing else is wrong. Takes a fraction of a millisecond, and never throws.
   * @param {unknown} scene
   * @returns {SceneProblem[]}
   */
  sceneProblems(scene) {
    return wasm.sceneProblems(scene);
  }

  /**
   * Returns the SHA-256 of a custom scene without its name, in hexadecimal: equal for scenes that play alike.
   * @param {CustomScene} scene
   * @returns {string}
   */
  sceneDigest(scene) {
    return wasm.sceneDigest(scene);
  }

  /**
   * Returns the limits of custom scenes.
   * @returns {SceneLimits}
   */
  sceneLimits() {
    return wasm.sceneLimits();
  }

  /**
   * Returns the image that the four nets see: the channels green object, blue goal, purple goal, gray and black, each
   * of 64 x 64 zeros and ones, row 0 at the bottom.
   * @param {Puzzle} task
   * @returns {Float32Array} `[5, 64, 64]`
   */
  raster(task) {
    return wasm.raster(task);
  }

  /**
   * Returns why a ball is invalid in a task, as a phrase; undefined if it is valid.
   * @param {Puzzle} task
   * @param {Ball} ball
   * @returns {string | undefined}
   */
  whyInvalid(task, ball) {
    return wasm.whyInvalid(task, ball);
  }

  /**
   * Simulates a task with a ball, or without one. An invalid ball is no error: the status of its rollout is
   * `invalid`.
   * @param {Puzzle} task
   * @param {Ball | null} [ball]
   * @returns {Rollout}
   */
  simulate(task, ball = null) {
    return wasm.simulate(task, ball);
  }

  /**
   * Maps where a ball of a radius solves a task. Tries one of the 64 x 64 cells each time the next value is asked for;
   * a value is the fraction of the cells that has been tried, and `outcomes`, which returns a copy of the map at the
   * time of the call, also after the last value: for each cell 0 untried, 1 invalid, 2 not solved, 3 solved.
   * @param {Puzzle} task
   * @param {number} radius 2 to 32 px
   * @returns {Generator<{ progress: number, outcomes: () => Uint8Array }, void, void>}
   */
  *solveMap(task, radius) {
    const map = new wasm.SolveMap(task, radius);
    /** @type {Uint8Array | null} */
    let final = null;
    const outcomes = () => final?.slice() ?? map.outcomes();
    try {
      for (let more = true; more;) {
        more = map.advance();
        yield { progress: map.progress(), outcomes };
      }
    } finally {
      cleanUp(() => {
        final = map.outcomes();
        map.free();
      });
    }
  }

  /**
   * Searches the whole action space for solutions. Tries one valid ball each time the next value is asked for; `found`
   * returns what is known at the time of the call, also after the last value.
   * @param {Puzzle} task
   * @returns {Generator<{ found: () => FoundSolutions }, void, void>}
   */
  *solutionSearch(task) {
    const search = new wasm.SolutionSearch(task);
    /** @type {FoundSolutions | null} */
    let final = null;
    const found = () => final ?? search.found();
    try {
      for (let more = true; more;) {
        more = search.advance();
        yield { found };
      }
    } finally {
      cleanUp(() => {
        final = search.found();
        search.free();
      });
    }
  }

  /**
   * Returns how many of the 27 balls within a pixel in x, y and radius may be placed, and how many of these solve. Few
   * solve if the ball does so by luck.
   * @param {Puzzle} task
   * @param {Ball} ball
   * @returns {Luck}
   */
  luck(task, ball) {
    return wasm.luck(task, ball);
  }

  /**
   * Simulates a scene, with a ball if one is given, and returns the line that `pathlight verify` and `verifyAttempt`
   * check.
   * @param {Puzzle} task
   * @param {Ball | null} [ball]
   * @returns {AttemptLine}
   */
  attemptLine(task, ball = null) {
    return wasm.attemptLine(task, ball);
  }

  /**
   * Simulates the attempt of a line again, and returns whether it is the same to the bit. Never throws.
   * @param {unknown} line
   * @returns {Verification}
   */
  verifyAttempt(line) {
    return wasm.verifyAttempt(line);
  }

  /**
   * Returns PHYRE's auccess of an agent, 0..100.
   * @param {(number | null)[]} firstSolved for each task the number, from 1, of the first attempt that solved it; null
   *   if none did
   * @returns {number}
   */
  auccess(firstSolved) {
    return wasm.auccess(firstSolved);
  }

  /**
   * Returns the soft IoU of two maps of 64 x 64 values in 0..1: from 0 (nothing in common) to 1 (equal).
   * @param {GridMap} one
   * @param {GridMap} other
   * @returns {number}
   */
  softIou(one, other) {
    return wasm.softIou(valuesOf(one), valuesOf(other));
  }

  /**
   * Draws the scene of a task so that it fills a square canvas. In a browser only, as all methods that draw.
   * @param {CanvasRenderingContext2D} context
   * @param {Puzzle} task
   * @param {{ dark?: boolean }} [options]
   */
  paintScene(context, task, { dark = false } = {}) {
    wasm.paintThumbnail(context, task, dark);
  }

  /**
   * Draws a map into a canvas of 64 x 64 pixels, which the page scales up. The colours run from 0, which is
   * transparent, to `max`.
   * @param {CanvasRenderingContext2D} context
   * @param {MapName} mapName
   * @param {GridMap} map
   * @param {{ max?: number, dark?: boolean }} [options]
   */
  paintMap(context, mapName, map, { max = 1, dark = false } = {}) {
    wasm.paintMap(context, /** @type {MapName} */ (String(mapName)), valuesOf(map), max, dark);
  }
}

/**
 * Returns the values of a map. Other things would be read as memory of the wasm.
 * @param {GridMap} map
 */
function valuesOf(map) {
  if (Array.isArray(map) || (ArrayBuffer.isView(map) && !(map instanceof DataView))) return map;
  throw failure("bad_map", "A map is an array of 64 x 64 numbers.");
}
