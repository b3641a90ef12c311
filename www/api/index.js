// The programming interface: load the wasm and weights, then ask for scenes, rollouts, images, maps, proposals and
// figures. Scripts in Node, other pages and the page's own worker all use it. Needs no document, except where a method
// draws.
//
// A task is named by its id, like "00007:008"; a custom scene, which is an object, takes the place of any task. Lengths
// are in px: a scene is 256 x 256, y up. What needs no weights is in benchmark.js.

import * as wasm from "../pkg/pathlight.js";
import { Benchmark } from "./benchmark.js";
import { cleanUp } from "./clean-up.js";
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
export async function load(options = {}) {
  if (options === null || typeof options !== "object")
    throw failure("bad_data", 'The options of load are an object: load({ model: "cross-0" }).');
  const { wasm: source, model, weights, onProgress } = options;
  const module = await compileWasm(source);
  await wasm
    .default({ module_or_path: module })
    .catch(({ message }) => Promise.reject(failure("no_wasm", `${message}. Give the wasm file of this version.`)));
  const pathlight = new Pathlight();
  if (weights === undefined) await pathlight.loadModel(model, onProgress);
  else if (weights !== null) await pathlight.loadWeights(weights, onProgress);
  return pathlight;
}

/**
 * What `load` returns. Methods throw an Error with a `code`: `bad_task` if there is no such task, `bad_scene` if a
 * custom scene may not be played, `bad_data` for other arguments that do not have the agreed form.
 */
export class Pathlight extends Benchmark {
  /** @type {wasm.Model | null} */
  #model = null;
  /** Counts the calls that load or free weights: of two loads that overlap, only the later one takes effect. */
  #asked = 0;

  /**
   * Loads the weights of a model that Pathlight comes with, in place of those there are. Returns its name, the
   * names of all models and the SHA-256 of its weights, if the list has it. If others are asked for meanwhile, those
   * stay.
   * @param {string | null} [name] by default the first
   * @param {OnProgress} [onProgress]
   */
  async loadModel(name, onProgress) {
    const asked = ++this.#asked;
    const list = await readModelList();
    const names = list.map((one) => one.name);
    const entry = list[name ? names.indexOf(name) : 0];
    if (!entry) throw failure("no_model", `There is no model “${name}” here. There is: ${names.join(", ")}.`);
    this.#use(await readWeights(entry, onProgress), asked, entry.sha256);
    return { name: entry.name, names, sha256: entry.sha256 };
  }

  /**
   * Loads weights that `pathlight-lab train` has written, in place of those there are.
   * @param {BufferSource | URL | string} weights their bytes or their address; in Node also a path
   * @param {OnProgress} [onProgress]
   */
  async loadWeights(weights, onProgress) {
    const asked = ++this.#asked;
    if (weights instanceof ArrayBuffer) return this.#use(new Uint8Array(weights), asked);
    if (ArrayBuffer.isView(weights))
      return this.#use(new Uint8Array(weights.buffer, weights.byteOffset, weights.byteLength), asked);
    const address = addressOf(weights);
    const bytes = await readFile(
      address,
      (reason) => failure("no_weights", `The weights could not be loaded: ${reason} for ${address}.`),
      onProgress,
    );
    this.#use(bytes, asked);
  }

  /**
   * @param {Uint8Array} bytes
   * @param {number} asked
   * @param {string} [sha256] theirs, if it is known
   */
  #use(bytes, asked, sha256) {
    const fresh = new wasm.Model(bytes, sha256);
    if (asked !== this.#asked) return fresh.free();
    this.#model?.free();
    this.#model = fresh;
  }

  get #loaded() {
    if (!this.#model) throw failure("no_weights", "No model is loaded: call loadModel or loadWeights first.");
    return this.#model;
  }

  /** Frees the memory of the weights, also of those that are being loaded. What needs no weights goes on working. */
  free() {
    this.#asked++;
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
   * Whether nets of the model were trained on this task or its settings were chosen on it; never for a custom scene.
   * @param {Puzzle} task
   * @returns {boolean}
   */
  hasSeen(task) {
    return this.#loaded.hasSeen(task);
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
   * @param {{ seed?: number, count?: number }} [options] `seed`: a whole number from 0 to 2^32 - 1, without effect if
   *   the weights have a dynamics net; `count`: 1 to 1,000, by default the 100 attempts that count
   * @returns {Proposal[]}
   */
  propose(task, { seed = 0, count } = {}) {
    return this.#loaded.propose(task, seed, count);
  }

  /**
   * The model's turn: tries the balls that it proposes, one each time the next value is asked for, until one solves the
   * task or all 100 have been tried. Errors are thrown when the first is asked for.
   *
   * With a memory, the model uses what attempts at earlier puzzles taught, and remembers these. An attempt then names
   * the puzzle that it was reminded of. It throws `bad_memory` for the memory of other weights, and `bad_weights` if
   * the weights have no dynamics net.
   * @param {Puzzle} task
   * @param {{ seed?: number, memory?: Memory | null }} [options] `seed`: as that of `propose`
   * @returns {Generator<TriedProposal, void, void>}
   */
  *turn(task, { seed = 0, memory = null } = {}) {
    if (memory !== null && !(memory instanceof wasm.Memory))
      throw failure("bad_memory", "The memory of a turn is what memory() returns.");
    const turn = memory ? this.#loaded.turnWith(task, memory) : this.#loaded.turn(task, seed);
    try {
      for (let attempt = turn.attempt(); attempt; attempt = turn.attempt()) yield attempt;
    } finally {
      cleanUp(() => turn.free());
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
    if (json !== undefined && json !== null && typeof json !== "string")
      throw failure("bad_memory", "A memory is read from the text that toJson returned.");
    return this.#loaded.memory(json);
  }
}
