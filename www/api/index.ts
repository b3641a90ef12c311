// The package: load the wasm and weights, then ask for scenes, rollouts, images, maps, proposals and figures, in Node
// and in browsers. Needs no document, except where a method draws.
//
// A task is named by its id, like "00007:008"; a custom scene, which is an object, takes the place of any task. Lengths
// are in px: a scene is 256 x 256, y up. What needs no weights is in benchmark.ts.

import * as wasm from "../pkg/worker/pathlight.js";
import { Benchmark } from "./benchmark.ts";
import { cleanUp, failure } from "./errors.ts";
import { MODELS, compileWasm, readModel, readWeights } from "./files.ts";
import type { Base, OnProgress } from "./files.ts";

export type { CodedError, ErrorCode } from "./errors.ts";
export type { Base, OnProgress } from "./files.ts";
export type * from "../pkg/worker/pathlight.js";

/** What to load. */
export interface LoadOptions {
  /**
   * The address of the folder that holds `pkg/` and `assets/`; by default that of the package. A bundle needs it where
   * it has no address of its own, as in a blob.
   */
  base?: URL | string;
  /**
   * The wasm of this version, its bytes or its address; by default the file that Pathlight comes with. A module or page
   * has one instance: later calls use that of the first.
   */
  wasm?: WebAssembly.Module | BufferSource | URL | string;
  /** The name of one of the models that Pathlight comes with; by default the first. */
  model?: string;
  /** Other weights, or their address; null loads none. */
  weights?: BufferSource | URL | string | null;
  /** Called with the fraction of the weights that has arrived. */
  onProgress?: OnProgress;
}

/**
 * Loads the wasm, and the weights of a model.
 *
 * Rejects with an Error with a `code`: `no_wasm` or `no_weights` if a file cannot be read or compiled, `no_model` if
 * there is no model of this name, `bad_weights` if the weights are damaged or belong to other nets.
 */
export async function load(options: LoadOptions = {}): Promise<Pathlight> {
  if (options === null || typeof options !== "object")
    throw failure("bad_data", 'The options of load are an object: load({ model: "cross-0" }).');
  const { base = null, wasm: source, model, weights, onProgress } = options;
  const module = await compileWasm(source, base);
  await wasm
    .default({ module_or_path: module })
    .catch(({ message }: Error) => Promise.reject(failure("no_wasm", `${message}. Give the wasm of this version.`)));
  const pathlight = new Pathlight(base);
  if (weights === undefined) await pathlight.loadModel(model, onProgress);
  else if (weights !== null) await pathlight.loadWeights(weights, onProgress);
  return pathlight;
}

/**
 * What `load` returns. Methods throw an Error with a `code`: `bad_task` if there is no such task, `bad_scene` if a
 * custom scene may not be played, `bad_data` for other arguments that do not have the agreed form.
 */
export class Pathlight extends Benchmark {
  #base: Base;
  #model: wasm.Model | null = null;
  /** Counts the calls that load or free weights: of two loads that overlap, only the later one takes effect. */
  #asked = 0;

  /** Only `load` makes one. */
  constructor(base: Base) {
    super();
    this.#base = base;
  }

  /**
   * Loads the weights of a model that Pathlight comes with, by default the first, in place of those there are. Returns
   * its name, the names of all models and the SHA-256 of its weights. If others are asked for meanwhile, those stay.
   */
  async loadModel(
    name?: string | null,
    onProgress?: OnProgress,
  ): Promise<{ name: string; names: string[]; sha256: string }> {
    const asked = ++this.#asked;
    const names = MODELS.map((one) => one.name);
    const entry = MODELS[name ? names.indexOf(name) : 0];
    if (!entry) throw failure("no_model", `There is no model “${name}” here. There is: ${names.join(", ")}.`);
    this.#use(await readModel(entry, this.#base, onProgress), asked, entry.sha256);
    return { name: entry.name, names, sha256: entry.sha256 };
  }

  /**
   * Loads weights that `pathlight-lab train` has written, in place of those there are: their bytes or their address; in
   * Node also a path.
   */
  async loadWeights(weights: BufferSource | URL | string, onProgress?: OnProgress): Promise<void> {
    const asked = ++this.#asked;
    if (weights instanceof ArrayBuffer) return this.#use(new Uint8Array(weights), asked);
    if (ArrayBuffer.isView(weights))
      return this.#use(new Uint8Array(weights.buffer, weights.byteOffset, weights.byteLength), asked);
    this.#use(await readWeights(weights, onProgress), asked);
  }

  #use(bytes: Uint8Array, asked: number, sha256?: string): void {
    const fresh = new wasm.Model(bytes, sha256);
    if (asked !== this.#asked) return fresh.free();
    this.#model?.free();
    this.#model = fresh;
  }

  get #loaded(): wasm.Model {
    if (!this.#model) throw failure("no_weights", "No model is loaded: call loadModel or loadWeights first.");
    return this.#model;
  }

  /** Frees the memory of the weights, also of those that are being loaded. What needs no weights goes on working. */
  free(): void {
    this.#asked++;
    this.#model?.free();
    this.#model = null;
  }

  /** How the weights were trained; null if none are loaded. */
  get card(): wasm.ModelCard | null {
    return this.#model?.card() ?? null;
  }

  /**
   * Returns whether nets of the model were trained on this task or its settings were chosen on it; never for a custom
   * scene.
   */
  hasSeen(task: wasm.Puzzle): boolean {
    return this.#loaded.hasSeen(task);
  }

  /**
   * Returns the maps that the nets imagine, each of 64 x 64 values in 0..1, row 0 at the bottom. It throws
   * `no_weights` if none are loaded, as all methods that need the model do.
   */
  imagine(task: wasm.Puzzle): wasm.Maps {
    return this.#loaded.imagine(task);
  }

  /**
   * Returns what the model imagines for one ball: the paths of the green object and of the ball, how far off they are
   * expected to be, and the probability that the ball solves the task; null if the weights have no dynamics net.
   * Further balls of the same task cost little. Throws `invalid_ball` if the ball may not be placed.
   */
  imagineBall(task: wasm.Puzzle, ball: wasm.Ball): wasm.ImaginedBall | null {
    return this.#loaded.imagineBall(task, ball) ?? null;
  }

  /**
   * Returns the balls that the model considers before it chooses, some hundred, each with the path that it imagines for
   * the green object and the probability that the ball solves the task; null if the weights have no dynamics net.
   */
  candidates(task: wasm.Puzzle): wasm.Candidate[] | null {
    return this.#loaded.candidates(task) ?? null;
  }

  /**
   * Returns the balls that the model would try, in order. All are valid; fewer than `count` if the scene has no room.
   * A longer list begins with the balls of a shorter one. `seed`: a whole number from 0 to 2^32 - 1, without effect if
   * the weights have a dynamics net; `count`: 1 to 1,000, by default the 100 attempts that count.
   */
  propose(task: wasm.Puzzle, { seed = 0, count }: { seed?: number; count?: number } = {}): wasm.Proposal[] {
    return this.#loaded.propose(task, seed, count);
  }

  /**
   * The model's turn: tries the balls that it proposes, one each time the next value is asked for, until one solves the
   * task or all 100 have been tried. Errors are thrown when the first is asked for.
   *
   * With a memory, the model uses what attempts at earlier puzzles taught, and remembers these. An attempt then names
   * the puzzle that it was reminded of. It throws `bad_memory` for the memory of other weights, and `bad_weights` if
   * the weights have no dynamics net.
   */
  *turn(
    task: wasm.Puzzle,
    { seed = 0, memory = null }: { seed?: number; memory?: wasm.Memory | null } = {},
  ): Generator<wasm.TriedProposal, void, void> {
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
   */
  memory(json?: string | null): wasm.Memory {
    if (json !== undefined && json !== null && typeof json !== "string")
      throw failure("bad_memory", "A memory is read from the text that toJson returned.");
    return this.#loaded.memory(json);
  }
}
