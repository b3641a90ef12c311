// The programming interface: load the wasm and weights, then ask for scenes, rollouts, images, maps, proposals and
// figures. Scripts in Node, other pages and the page's own worker all use it. Needs no document, except where a method
// draws.
//
// A task is named by its id, like "00007:008"; a custom scene, which is an object, takes the place of any task. Lengths
// are in px: a scene is 256 x 256, y up. The file is over 300 lines long for its JSDoc.

import * as wasm from "../pkg/pathlight.js";
import { failure } from "./failure.js";
import { addressOf, compileWasm, readFile } from "./files.js";
import { readModelList } from "./model-files.js";
import { readWeights } from "./weights.js";

/** @typedef {import("../pkg/pathlight.js").About} About */
/** @typedef {import("../pkg/pathlight.js").AttemptLine} AttemptLine */
/** @typedef {import("../pkg/pathlight.js").Ball} Ball */
/** @typedef {import("../pkg/pathlight.js").Body} Body */
/** @typedef {import("../pkg/pathlight.js").Candidate} Candidate */
/** @typedef {import("../pkg/pathlight.js").Difficulty} Difficulty */
/** @typedef {import("../pkg/pathlight.js").Ending} Ending */
/** @typedef {import("../pkg/pathlight.js").Fold} Fold */
/** @typedef {import("../pkg/pathlight.js").FoundSolutions} FoundSolutions */
/** @typedef {import("../pkg/pathlight.js").GridMap} GridMap */
/** @typedef {import("../pkg/pathlight.js").ImaginedBall} ImaginedBall */
/** @typedef {import("../pkg/pathlight.js").Luck} Luck */
/** @typedef {import("../pkg/pathlight.js").Maps} Maps */
/** @typedef {import("../pkg/pathlight.js").Memory} Memory */
/** @typedef {import("../pkg/pathlight.js").ModelCard} ModelCard */
/** @typedef {import("../pkg/pathlight.js").CustomScene} CustomScene */
/** @typedef {import("../pkg/pathlight.js").Puzzle} Puzzle */
/** @typedef {import("../pkg/pathlight.js").Proposal} Proposal */
/** @typedef {import("../pkg/pathlight.js").Reminder} Reminder */
/** @typedef {import("../pkg/pathlight.js").RememberedPuzzle} RememberedPuzzle */
/** @typedef {import("../pkg/pathlight.js").Rollout} Rollout */
/** @typedef {import("../pkg/pathlight.js").Scene} Scene */
/** @typedef {import("../pkg/pathlight.js").SceneLimits} SceneLimits */
/** @typedef {import("../pkg/pathlight.js").SceneProblem} SceneProblem */
/** @typedef {import("../pkg/pathlight.js").Setup} Setup */
/** @typedef {import("../pkg/pathlight.js").MapName} MapName */
/** @typedef {import("../pkg/pathlight.js").Template} Template */
/** @typedef {import("../pkg/pathlight.js").TriedProposal} TriedProposal */
/** @typedef {import("../pkg/pathlight.js").Verification} Verification */
/** @typedef {import("./failure.js").ErrorCode} ErrorCode */
/** @typedef {import("./files.js").OnProgress} OnProgress */
/** @typedef {Error & { code: ErrorCode }} CodedError */

/**
 * What to load.
 * @typedef {object} LoadOptions
 * @property {WebAssembly.Module | BufferSource | URL | string} [wasm] the wasm of this version, its bytes or its
 *   address; by default the file that Pathlight comes with. A module or page has one instance: later calls use that of
 *   the first
 * @property {string} [model] the name of one of the models that Pathlight comes with; by default the first
 * @property {BufferSource | URL | string | null} [weights] other weights, or their address; null loads none
 * @property {OnProgress} [onProgress] called with the fraction of the weights that has arrived
 */

/**
 * Loads the wasm, and the weights of a model.
 *
 * Rejects with an Error with a `code`: `no_wasm` or `no_weights` if a file cannot be read or compiled, `no_model` if
 * there is no model of this name, `bad_weights` if the weights are damaged or belong to other nets.
 * @param {LoadOptions} [options]
 */
export async function load({ wasm: source, model, weights, onProgress } = {}) {
  await wasm.default({ module_or_path: await compileWasm(source) });
  const pathlight = new Pathlight();
  if (weights === undefined) await pathlight.loadModel(model, onProgress);
  else if (weights !== null) await pathlight.loadWeights(weights, onProgress);
  return pathlight;
}

/**
 * What `load` returns. Methods throw an Error with a `code`: `bad_task` if there is no such task, `bad_scene` if an own
 * scene may not be played, `bad_data` for other arguments that do not have the agreed form.
 */
export class Pathlight {
  /** @type {wasm.Model | null} */
  #model = null;

  /**
   * Loads the weights of a model that Pathlight comes with, in place of those there are. Returns its name and the names
   * of all models.
   * @param {string | null} [name] by default the first
   * @param {OnProgress} [onProgress]
   */
  async loadModel(name, onProgress) {
    const list = await readModelList();
    const names = list.map((one) => one.name);
    const entry = list[name ? names.indexOf(name) : 0];
    if (!entry) throw failure("no_model", `There is no model “${name}” here. There is: ${names.join(", ")}.`);
    this.#use(await readWeights(entry, onProgress), entry.sha256);
    return { name: entry.name, names };
  }

  /**
   * Loads weights that `pathlight-lab train` has written, in place of those there are.
   * @param {BufferSource | URL | string} weights their bytes or their address; in Node also a path
   * @param {OnProgress} [onProgress]
   */
  async loadWeights(weights, onProgress) {
    if (weights instanceof ArrayBuffer) return this.#use(new Uint8Array(weights));
    if (ArrayBuffer.isView(weights))
      return this.#use(new Uint8Array(weights.buffer, weights.byteOffset, weights.byteLength));
    const address = addressOf(weights);
    this.#use(
      await readFile(
        address,
        (reason) => failure("no_weights", `The weights could not be loaded: ${reason} for ${address}.`),
        onProgress,
      ),
    );
  }

  /**
   * @param {Uint8Array} bytes
   * @param {string} [sha256] theirs, if it is known
   */
  #use(bytes, sha256) {
    const fresh = new wasm.Model(bytes, sha256);
    this.free();
    this.#model = fresh;
  }

  get #loaded() {
    if (!this.#model) throw failure("no_weights", "No model is loaded: call loadModel or loadWeights first.");
    return this.#model;
  }

  /** Frees the memory of the weights. What needs no weights goes on working. */
  free() {
    this.#model?.free();
    this.#model = null;
  }

  /**
   * How the weights were trained; null if none are loaded.
   * @returns {ModelCard | null}
   */
  get card() {
    return this.#model?.card() ?? null;
  }

  /**
   * Whether the model was trained on this task or its settings were chosen on it; never for a custom scene.
   * @param {Puzzle} task
   * @returns {boolean}
   */
  hasSeen(task) {
    return this.#loaded.hasSeen(task);
  }

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
   * Returns a task in words: its name, its goal and a description of its scene.
   * @param {Puzzle} task
   * @returns {About}
   */
  about(task) {
    const game = new wasm.Game(task);
    try {
      return game.about();
    } finally {
      game.free();
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
   * Returns all reasons why a value is no custom scene that may be played; none if it may. Takes a fraction of a
   * millisecond, and throws for no value.
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
   * Simulates a task with a ball, or alone without one. An invalid ball is no error: the status of its rollout is
   * `invalid`.
   * @param {Puzzle} task
   * @param {Ball | null} [ball]
   * @returns {Rollout}
   */
  simulate(task, ball = null) {
    return wasm.simulate(task, ball);
  }

  /**
   * Returns the maps that the nets imagine, each of 64 x 64 values in 0..1, row 0 at the bottom. It throws
   * `no_weights` if none are loaded, as all methods that need the model do.
   * @param {Puzzle} task
   * @returns {Maps}
   */
  imagine(task) {
    return this.#loaded.imagine(task);
  }

  /**
   * Returns what the model imagines for one ball: the paths of the green object and of the ball, how far off they are
   * expected to be, and the probability that the ball solves the task; null if the weights have no dynamics net.
   * Further balls of the same task cost little. Throws `invalid_ball` if the ball may not be placed.
   * @param {Puzzle} task
   * @param {Ball} ball
   * @returns {ImaginedBall | null}
   */
  imagineBall(task, ball) {
    return this.#loaded.imagineBall(task, ball) ?? null;
  }

  /**
   * Returns the balls that the model considers before it chooses, some hundred, each with the path that it imagines for
   * the green object and the probability that the ball solves the task; null if the weights have no dynamics net.
   * @param {Puzzle} task
   * @returns {Candidate[] | null}
   */
  candidates(task) {
    return this.#loaded.candidates(task) ?? null;
  }

  /**
   * Returns the balls that the model would try, in order. All are valid; fewer than `count` if the scene has no room.
   * A longer list begins with the balls of a shorter one.
   * @param {Puzzle} task
   * @param {{ seed?: number, count?: number }} [options] `seed`: a whole number from 0 to 2^32 - 1; `count`: 1 to
   *   1,000, by default the 100 attempts that count
   * @returns {Proposal[]}
   */
  propose(task, { seed = 0, count } = {}) {
    return this.#loaded.propose(task, seed, count);
  }

  /**
   * The model's turn: tries the balls that it proposes, one each time the next value is asked for, until one solves the
   * task or all 100 have been tried.
   *
   * With a memory, the model uses what attempts at earlier puzzles taught, and remembers these. An attempt then names
   * the puzzle that it was reminded of. It throws `bad_memory` for the memory of other weights, and `bad_weights` if
   * the weights have no dynamics net.
   * @param {Puzzle} task
   * @param {{ seed?: number, memory?: Memory | null }} [options] `seed`: as that of `propose`; without effect with a
   *   memory
   * @returns {Generator<TriedProposal, void, void>}
   */
  *turn(task, { seed = 0, memory = null } = {}) {
    const turn = memory ? this.#loaded.turnWith(task, memory) : this.#loaded.turn(task, seed);
    try {
      for (let attempt = turn.attempt(); attempt; attempt = turn.attempt()) yield attempt;
    } finally {
      turn.free();
    }
  }

  /**
   * Returns a memory of attempts for the model that is loaded: an empty one, or the one that `toJson` of a memory, or
   * `pathlight agent --memory`, wrote. Throws `bad_memory` if that is damaged, of another version, or learned with
   * other weights. Free it when it is no longer needed.
   * @param {string} [json]
   * @returns {Memory}
   */
  memory(json) {
    return this.#loaded.memory(json);
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
      final = map.outcomes();
      map.free();
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
      final = search.found();
      search.free();
    }
  }

  /**
   * Returns whether a ball solves by luck: of the 27 balls within a pixel in x, y and radius, how many solve.
   * @param {Puzzle} task
   * @param {Ball} ball
   * @returns {Luck}
   */
  luck(task, ball) {
    return wasm.luck(task, ball);
  }

  /**
   * Simulates a ball, or the scene alone without one, and returns the line that `pathlight verify` and `verifyAttempt`
   * check.
   * @param {Puzzle} task
   * @param {Ball | null} [ball]
   * @returns {AttemptLine}
   */
  attemptLine(task, ball = null) {
    return wasm.attemptLine(task, ball);
  }

  /**
   * Simulates the attempt of a line again, and returns whether it is the same to the bit. Throws for no value.
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
    return wasm.softIou(one, other);
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
    wasm.paintMap(context, mapName, map, max, dark);
  }
}
