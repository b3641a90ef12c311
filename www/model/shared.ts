// One worker for all puzzles of a page that use the same files and model: each worker holds the weights and a wasm
// instance, and a lesson may show many puzzles.

import { MODEL_OFF } from "../core/change/model.ts";
import { ModelClient, WorkerError } from "./client.ts";
import models from "../../assets/model.json";
import type { Setup } from "../pkg/page/pathlight.js";
import type { Model } from "../core/change/model.ts";

/** Addresses of the files that the worker loads. */
export interface ModelFiles {
  readonly worker: string;
  readonly wasm: string;
  /** Addresses of weights by file name. */
  readonly weights: Readonly<Record<string, string>>;
}

type Listener = (model: Model) => void;

export class SharedModel {
  readonly client: ModelClient;
  #files: ModelFiles;
  #setup: Setup;
  #model: Model = MODEL_OFF;
  #listeners = new Set<Listener>();

  constructor(files: ModelFiles, setup: Setup, create = () => startWorker(files.worker)) {
    this.#files = files;
    this.#setup = setup;
    this.client = new ModelClient(create, files.worker, (failure) => this.#tell({ kind: "failed", failure }));
  }

  /** Reports the state of the model until the signal is aborted. Without listeners the worker ends. */
  async follow(listener: Listener, signal: AbortSignal): Promise<void> {
    this.#listeners.add(listener);
    if (this.#model.kind !== "off") listener(this.#model);
    await new Promise((resolve) => signal.addEventListener("abort", resolve));
    this.#listeners.delete(listener);
    if (this.#listeners.size > 0) return;
    this.#model = MODEL_OFF;
    this.client.stop({ code: "broken", reason: "Nobody uses the worker any more." });
  }

  /** Loads the weights, unless they are loaded or loading. */
  async start(): Promise<void> {
    if (this.#model.kind === "loading" || this.#model.kind === "ready") return;
    this.client.start();
    const { name, file, size, sha256 } = models.models[SETUPS.indexOf(this.#setup)]!;
    const weights = { url: this.#files.weights[file]!, size, sha256 };
    const onUpdate = (arrived: number) => this.#tell({ kind: "loading", arrived });
    const loaded = this.client.call("load", [this.#files.wasm, weights], null, onUpdate);
    // Whoever hears of it may ask at once: of the new worker, and after it was told to load.
    this.#tell({ kind: "loading", arrived: 0 });
    try {
      this.#tell({ kind: "ready", name, card: await loaded });
    } catch (error) {
      // A crash has already been reported, and a worker that was ended has no listeners.
      if (this.#kind() === "loading") this.#tell({ kind: "failed", failure: (error as WorkerError).failure });
    }
  }

  /** Read anew, because it may change during a call, which the compiler does not see. */
  #kind(): Model["kind"] {
    return this.#model.kind;
  }

  #tell(model: Model): void {
    this.#model = model;
    for (const listener of this.#listeners) listener(model);
  }
}

/** Browsers start no worker from a script of another origin, but a script of the page's own may import it. */
function startWorker(url: string): Worker {
  if (new URL(url).origin === location.origin) return new Worker(url, { type: "module" });
  const script = URL.createObjectURL(new Blob([`import ${JSON.stringify(url)};`], { type: "text/javascript" }));
  const worker = new Worker(script, { type: "module" });
  worker.addEventListener("message", () => URL.revokeObjectURL(script), { once: true });
  return worker;
}

const shared = new Map<string, SharedModel>();

/**
 * The setups that a model is here for, the default first: the page has both, the packages one. A model is named after
 * its setup and the fold that it was trained on: "within-0".
 */
export const SETUPS = models.models.map(({ name }) => name.split("-")[0] as Setup);

export function sharedModel(files: ModelFiles, setup: Setup): SharedModel {
  const key = JSON.stringify([setup, files]);
  const model = shared.get(key) ?? new SharedModel(files, setup);
  shared.set(key, model);
  return model;
}
