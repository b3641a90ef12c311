// The page's side of the worker: each call is a promise, and takes an AbortSignal as its token. Once the signal is
// aborted the promise rejects with its reason and no update of the call arrives any more, however late the worker
// answers. A worker that crashes rejects every open call with a sentence, and can be started again.

import { createWorker, whyNoWorker } from "./start-worker.js";

/** @typedef {import("./messages.js").Calls} Calls */
/** @typedef {import("./messages.js").Failure} Failure */
/** @typedef {import("./messages.js").Played} Played */
/** @typedef {import("./messages.js").Update} Update */

/** A fixed seed, so that the model's turn on a puzzle is the same each time. */
const SEED = 0;

export class WorkerClient extends EventTarget {
  /**
   * Of the weights; solve maps need only a worker.
   * @type {"off" | "loading" | "ready" | "failed"}
   */
  status = "off";
  /**
   * While loading: the fraction of the weights that has arrived, 0..1, or null if unknown.
   * @type {number | null}
   */
  progress = null;
  /**
   * After a failure: what went wrong.
   * @type {Failure | null}
   */
  failure = null;
  /**
   * The name that it was last started with; null for the first model, and before the start.
   * @type {string | null}
   */
  requestedName = null;
  /**
   * Once ready.
   * @type {import("./messages.js").LoadedModel | null}
   */
  loaded = null;
  #module;
  /** @type {Worker | null} */
  #worker = null;
  /**
   * @type {Map<number, { resolve: (value: any) => void, reject: (reason: any) => void, onUpdate: (update: Update) =>
   *   void }>}
   */
  #pending = new Map();
  #nextId = 1;

  /**
   * Fires "change" when its status or its progress changes.
   * @param {WebAssembly.Module} module shared by page and worker
   */
  constructor(module) {
    super();
    this.#module = module;
  }

  /** Is there a worker that can be called? */
  get alive() {
    return this.#worker !== null;
  }

  /**
   * Starts a new worker in place of the present one, and loads weights: those of a name, or the first. Never rejects;
   * see `status`.
   * @param {string | null} name
   */
  async start(name) {
    this.#terminate("The model was started again.");
    this.requestedName = name;
    this.#set({ status: "loading" });
    /** @type {Worker | null} */
    let worker = null;
    try {
      worker = this.#worker = this.#listened(createWorker());
      await this.#call("start", { module: this.#module });
      const loaded = await this.#call("load", { name }, undefined, ({ progress }) =>
        this.#set({ status: "loading", progress }),
      );
      this.#set({ status: "ready", loaded });
    } catch (error) {
      const { code = "broken", message } = /** @type {Error & { code?: string }} */ (error);
      // Not after another start or a crash, which have set the status themselves.
      if (worker === this.#worker) this.#set({ status: "failed", failure: { code, message } });
    }
  }

  /** @param {Worker} worker */
  #listened(worker) {
    worker.addEventListener("message", ({ data }) => worker === this.#worker && this.#onMessage(data));
    worker.addEventListener("error", (event) => {
      event.preventDefault();
      if (worker === this.#worker) this.#onCrash(event.message);
    });
    return worker;
  }

  /**
   * @param {Played} played
   * @param {AbortSignal} signal
   */
  imagine(played, signal) {
    return this.#call("imagine", { played }, signal);
  }

  /**
   * What the model imagines for a ball; null if its weights have no dynamics net.
   * @param {Played} played
   * @param {import("./messages.js").Ball} ball
   * @param {AbortSignal} signal
   */
  imagineBall(played, ball, signal) {
    return this.#call("imagineBall", { played, ball }, signal);
  }

  /**
   * The balls that the model considers, and the first that it tries; null if its weights have no dynamics net.
   * @param {Played} played
   * @param {AbortSignal} signal
   */
  consider(played, signal) {
    return this.#call("consider", { played, seed: SEED }, signal);
  }

  /**
   * Plays the model's turn: tries its balls in order until one solves it.
   * @param {Played} played
   * @param {AbortSignal} signal
   * @param {(attempt: import("./messages.js").Attempt) => void} onAttempt
   */
  turn(played, signal, onAttempt) {
    return this.#call("turn", { played, seed: SEED }, signal, ({ attempt }) => attempt && onAttempt(attempt));
  }

  /**
   * The balls of that turn, each with what becomes of it.
   * @param {Played} played
   * @param {AbortSignal} signal
   */
  propose(played, signal) {
    return this.#call("propose", { played, seed: SEED }, signal);
  }

  /**
   * Runs the scene without a ball. Needs a worker, but no weights.
   * @param {Played} played
   * @param {AbortSignal} signal
   */
  watch(played, signal) {
    return this.#call("watch", { played }, signal);
  }

  /**
   * Searches for solutions. Needs a worker, but no weights.
   * @param {Played} played
   * @param {AbortSignal} signal
   * @param {(found: import("./messages.js").FoundSolutions) => void} onFound
   */
  search(played, signal, onFound) {
    return this.#call("search", { played }, signal, ({ found }) => found && onFound(found));
  }

  /**
   * How many of the balls beside a ball solve. Needs a worker, but no weights.
   * @param {Played} played
   * @param {import("./messages.js").Ball} ball
   * @param {AbortSignal} signal
   */
  luck(played, ball, signal) {
    return this.#call("luck", { played, ball }, signal);
  }

  /**
   * Simulates balls and returns a line for each, with its digest. Needs a worker, but no weights.
   * @param {Played} played
   * @param {import("./messages.js").Ball[]} balls
   * @param {AbortSignal} signal
   */
  attemptLines(played, balls, signal) {
    return this.#call("attemptLines", { played, balls }, signal);
  }

  /**
   * Simulates the attempts of lines again. Needs a worker, but no weights.
   * @param {unknown[]} lines
   * @param {AbortSignal} signal
   */
  verify(lines, signal) {
    return this.#call("verify", { lines }, signal);
  }

  /**
   * Maps where a ball of a radius (px) solves. Needs a worker, but no weights.
   * @param {Played} played
   * @param {number} radius
   * @param {AbortSignal} signal
   * @param {(map: import("./messages.js").SolveMapUpdate) => void} onMap
   */
  solve(played, radius, signal, onMap) {
    return this.#call("solve", { played, radius }, signal, ({ map }) => map && onMap(map));
  }

  /**
   * @template {keyof Calls} Name
   * @param {Name} call
   * @param {Calls[Name]["args"]} args
   * @param {AbortSignal} [signal]
   * @param {(update: Update) => void} [onUpdate]
   * @returns {Promise<Calls[Name]["value"]>}
   */
  #call(call, args, signal, onUpdate = () => {}) {
    const worker = this.#worker;
    if (signal?.aborted) return Promise.reject(signal.reason);
    if (!worker) return Promise.reject(new Error(this.failure?.message ?? "The model has not been started."));
    const id = this.#nextId++;
    worker.postMessage({ id, call, args });
    return new Promise((resolve, reject) => {
      this.#pending.set(id, { resolve, reject, onUpdate });
      signal?.addEventListener("abort", () => {
        if (!this.#pending.delete(id)) return;
        worker.postMessage({ cancel: id });
        reject(signal.reason);
      });
    });
  }

  /** @param {import("./messages.js").Response} response */
  #onMessage({ id, value, error, update }) {
    if (error?.code === "crashed") return this.#onCrash(error.message);
    const call = this.#pending.get(id);
    if (!call) return;
    if (update) return call.onUpdate(update);
    this.#pending.delete(id);
    if (error) call.reject(Object.assign(new Error(error.message), { code: error.code }));
    else call.resolve(value);
  }

  /** @param {string | undefined} reason none if not even its code could be loaded */
  #onCrash(reason) {
    const message =
      reason === undefined ? whyNoWorker() : `The model’s worker has stopped${reason ? ` (${reason})` : ""}.`;
    this.#terminate(message);
    this.#set({ status: "failed", failure: { code: "crashed", message } });
  }

  /** Ends the worker and forgets the model. */
  stop() {
    this.#terminate("Another model was started.");
    this.requestedName = null;
    this.#set({ status: "off" });
  }

  /** @param {string} reason */
  #terminate(reason) {
    this.#worker?.terminate();
    this.#worker = null;
    const calls = [...this.#pending.values()];
    this.#pending.clear();
    for (const { reject } of calls) reject(new Error(reason));
  }

  /** @param {Partial<Pick<WorkerClient, "status" | "progress" | "failure" | "loaded">>} values */
  #set({ status = "off", progress = null, failure = null, loaded = null }) {
    Object.assign(this, { status, progress, failure, loaded });
    this.dispatchEvent(new Event("change"));
  }
}
