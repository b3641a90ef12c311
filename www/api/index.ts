// The package: loads the wasm and weights, and provides scenes, rollouts, images, maps, proposals and figures, in Node
// and in browsers. Only methods that draw need a document.
//
// A task is named by its id, like "00007:008"; a custom scene, which is an object, can be passed instead of any id.
// Lengths are in px: a scene is 256 x 256, y up. Methods that need no weights are in benchmark.ts.

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
   * The address of the folder that holds `pkg/` and `assets/`; by default that of the package. Required in a bundle
   * that has no address itself, as in a blob.
   */
  base?: URL | string;
  /**
   * The wasm of this version, its bytes or its address; by default the file that comes with Pathlight. A module or page
   * has one instance: later calls use the instance of the first.
   */
  wasm?: WebAssembly.Module | BufferSource | URL | string;
  /** The name of a model that comes with Pathlight; by default the first. */
  model?: string;
  /** Other weights, or their address; null loads none. */
  weights?: BufferSource | URL | string | null;
  /** Called with the fraction of the weights that has been loaded. */
  onProgress?: OnProgress;
}

/**
 * Loads the wasm and the weights of a model.
 *
 * Rejects with an Error that has a `code`: `no_wasm` or `no_weights` if a file cannot be read or compiled, `no_model`
 * if there is no model of this name, `bad_weights` if the weights are damaged or belong to other nets.
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
 * The result of `load`. Methods throw an Error that has a `code`: `bad_task` if there is no such task, `bad_scene` if a
 * custom scene is not playable, `bad_data` for other malformed arguments.
 */
export class Pathlight extends Benchmark {
  #base: Base;
  #model: wasm.Model | null = null;
  /** Counts the calls that load or free weights. Of two overlapping loads, only the later one takes effect. */
  #asked = 0;

  /** Use `load` to create one. */
  constructor(base: Base) {
    super();
    this.#base = base;
  }

  /**
   * Loads the weights of a model that comes with Pathlight, by default the first, and replaces the current ones.
   * Returns the name of the model, the names of all models and the SHA-256 of its weights. If another load starts
   * meanwhile, that one wins.
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
   * Loads weights written by `pathlight-lab train`, and replaces the current ones. `weights` are their bytes or their
   * address; in Node, also a path.
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

  /** Frees the memory of the weights, also of those that are being loaded. Methods that need no weights still work. */
  free(): void {
    this.#asked++;
    this.#model?.free();
    this.#model = null;
  }

  /** Describes how the weights were trained; null if none are loaded. */
  get card(): wasm.ModelCard | null {
    return this.#model?.card() ?? null;
  }

  /**
   * Returns whether nets of the model were trained on this task or its settings were chosen on it; false for a custom
   * scene.
   */
  hasSeen(task: wasm.Puzzle): boolean {
    return this.#loaded.hasSeen(task);
  }

  /**
   * Returns the maps that the nets imagine, each of 64 x 64 values in 0..1, row 0 at the bottom. Like all methods that
   * need the model, it throws `no_weights` if none is loaded.
   */
  imagine(task: wasm.Puzzle): wasm.Maps {
    return this.#loaded.imagine(task);
  }

  /**
   * Returns the model's forecast for one ball: the paths of the green object and of the ball, their expected errors,
   * and the probability that the ball solves the task; null if the weights have no dynamics net. Further balls of the
   * same task cost little. Throws `invalid_ball` if the ball is invalid.
   */
  imagineBall(task: wasm.Puzzle, ball: wasm.Ball): wasm.ImaginedBall | null {
    return this.#loaded.imagineBall(task, ball) ?? null;
  }

  /**
   * Returns the balls that the model considers before it chooses, a few hundred, each with the imagined path of the
   * green object and the probability that the ball solves the task; null if the weights have no dynamics net.
   */
  candidates(task: wasm.Puzzle): wasm.Candidate[] | null {
    return this.#loaded.candidates(task) ?? null;
  }

  /**
   * Returns the balls that the model would try, in order. All are valid; there are fewer than `count` if the scene has
   * no room. A longer list begins with the balls of a shorter one. `seed` is a whole number from 0 to 2^32 - 1, without
   * effect if the weights have a dynamics net; `count` is 1 to 1,000, by default the 100 attempts that count.
   */
  propose(task: wasm.Puzzle, { seed = 0, count }: { seed?: number; count?: number } = {}): wasm.Proposal[] {
    return this.#loaded.propose(task, seed, count);
  }

  /**
   * The model's turn: tries the balls that it proposes, one per value taken from the generator, until one solves the
   * task or all 100 have been tried. Throws errors when the first value is taken.
   *
   * With a memory, the model uses what it learned from attempts at earlier puzzles, and remembers these attempts too.
   * An attempt then names the puzzle that the model recalled. Throws `bad_memory` for the memory of other weights, and
   * `bad_weights` if the weights have no dynamics net.
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
   * Returns a memory of attempts for the loaded model: an empty one, or one from the text of a memory's `toJson` or of
   * `pathlight agent --memory`. Throws `bad_memory` if the text is damaged, of another version, or learned with other
   * weights. Free the memory when it is no longer needed.
   */
  memory(json?: string | null): wasm.Memory {
    if (json !== undefined && json !== null && typeof json !== "string")
      throw failure("bad_memory", "A memory is read from the text that toJson returned.");
    return this.#loaded.memory(json);
  }
}
