// The page's side of the worker: each call is a promise, and takes an AbortSignal as its token. Once the signal is
// aborted the promise rejects with its reason and no update of the call arrives any more, however late the worker
// answers. A worker that crashes rejects every open call with a sentence, and can be started again. The calls are
// declared in worker.js.

import { text } from "../text/text.js";
import { createWorker, whyNoWorker } from "./start-worker.js";

/** @typedef {import("./worker.js").Calls} Calls */
/** @typedef {import("./worker.js").Failure} Failure */
/**
 * What a call sends before its answer, and its answer.
 * @template {keyof Calls} Name
 * @typedef {ReturnType<Calls[Name]> extends Generator<infer Update, infer Value> ? { update: Update, value: Value }
 *   : { update: never, value: ReturnType<Calls[Name]> }} Answer
 */

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
   * @type {import("./worker.js").LoadedModel | null}
   */
  loaded = null;
  #module;
  /** @type {Worker | null} */
  #worker = null;
  /**
   * @type {Map<number, { resolve: (value: any) => void, reject: (reason: any) => void, onUpdate: (update: any) =>
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
    this.#terminate(text.model.worker.startedAgain);
    this.requestedName = name;
    this.#set({ status: "loading" });
    /** @type {Worker | null} */
    let worker = null;
    try {
      worker = this.#worker = this.#listened(createWorker());
      const onProgress = (/** @type {number | null} */ progress) => this.#set({ status: "loading", progress });
      const loaded = await this.#request("load", [this.#module, name], undefined, onProgress);
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
   * Calls the worker.
   * @template {keyof Calls} Name
   * @param {Name} name
   * @param {Parameters<Calls[Name]>} args
   * @param {AbortSignal} signal
   * @param {(update: Answer<Name>["update"]) => void} [onUpdate]
   * @returns {Promise<Answer<Name>["value"]>}
   */
  call(name, args, signal, onUpdate) {
    return this.#request(name, args, signal, onUpdate);
  }

  /**
   * @param {string} call
   * @param {unknown[]} args
   * @param {AbortSignal} [signal]
   * @param {(update: any) => void} [onUpdate]
   * @returns {Promise<any>}
   */
  #request(call, args, signal, onUpdate = () => {}) {
    const worker = this.#worker;
    if (signal?.aborted) return Promise.reject(signal.reason);
    if (!worker) return Promise.reject(new Error(this.failure?.message ?? text.model.worker.notStarted));
    const id = this.#nextId++;
    worker.postMessage({ id, call, args });
    let onAbort = () => {};
    const answer = new Promise((resolve, reject) => {
      this.#pending.set(id, { resolve, reject, onUpdate });
      onAbort = () => {
        if (!this.#pending.delete(id)) return;
        worker.postMessage({ cancel: id });
        reject(signal?.reason);
      };
    });
    signal?.addEventListener("abort", onAbort);
    // One signal may serve many calls in turn.
    return answer.finally(() => signal?.removeEventListener("abort", onAbort));
  }

  /**
   * @param {{ id: number, value?: unknown, error?: Failure, update?: unknown }} response
   */
  #onMessage({ id, value, error, update }) {
    if (error?.code === "crashed") return this.#onCrash(error.message);
    const call = this.#pending.get(id);
    if (!call) return;
    if (update !== undefined) return call.onUpdate(update);
    this.#pending.delete(id);
    if (!error) return call.resolve(value);
    const { code, message } = error;
    call.reject(Object.assign(new Error(text.model.worker.failed(code, message)), { code }));
  }

  /** @param {string | undefined} reason none if not even its code could be loaded */
  #onCrash(reason) {
    const message = reason === undefined ? whyNoWorker() : text.model.worker.stopped(reason);
    this.#terminate(message);
    this.#set({ status: "failed", failure: { code: "crashed", message } });
  }

  /** Ends the worker and forgets the model. */
  stop() {
    this.#terminate(text.model.worker.other);
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
