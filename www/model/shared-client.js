// The model of one puzzle. Puzzles of a page that ask for the same model share its worker: each worker holds the
// weights and an instance of the wasm, and a lesson may show many puzzles. Has the calls and the events of a
// WorkerClient, and follows the one that it uses at present. Whoever takes a model sees it "loading" first, even if it
// has been loaded for another puzzle, and so forgets what came from the model before.

import { text } from "../text/text.js";
import { WorkerClient } from "./worker-client.js";

/**
 * The workers that are in use, and by how many puzzles.
 * @type {Map<WorkerClient, number>}
 */
const userCounts = new Map();

export class SharedClient extends EventTarget {
  /**
   * The name that was last asked for; null for the first model, and while there is none.
   * @type {string | null}
   */
  requestedName = null;
  #module;
  /** @type {WorkerClient | null} */
  #client = null;
  /** Has a worker just been taken that may be ready? */
  #taking = false;
  #onChange = () => this.dispatchEvent(new Event("change"));

  /**
   * Fires "change" when its status or its progress changes.
   * @param {WebAssembly.Module} module shared by all puzzles and workers
   */
  constructor(module) {
    super();
    this.#module = module;
  }

  /** See WorkerClient. */
  get status() {
    return this.#taking ? "loading" : (this.#client?.status ?? "off");
  }

  /** See WorkerClient. */
  get progress() {
    return this.#client?.progress ?? null;
  }

  /** See WorkerClient. */
  get failure() {
    return this.#client?.failure ?? null;
  }

  /** See WorkerClient. */
  get loaded() {
    return this.#taking ? null : (this.#client?.loaded ?? null);
  }

  /** Is there a worker that can be called? */
  get alive() {
    return this.#client?.alive ?? false;
  }

  /**
   * Takes the model of a name, or the first: the worker of another puzzle, if that is not broken, else a new one.
   * @param {string | null} name
   */
  start(name) {
    const client = this.#client !== null && this.requestedName === name ? this.#client : this.#take(name);
    if (client.status === "off" || client.status === "failed") {
      client.start(name);
      return;
    }
    this.#taking = true;
    this.#onChange();
    queueMicrotask(() => {
      this.#taking = false;
      this.#onChange();
    });
  }

  /**
   * Takes a model like `start`. Resolves once it is loaded; rejects with a sentence if it cannot be or is left, and
   * with the signal's reason once that is aborted.
   * @param {string | null} name
   * @param {AbortSignal} signal
   * @returns {Promise<void>}
   */
  ready(name, signal) {
    this.start(name);
    const ended = new AbortController();
    const { promise, resolve, reject } = Promise.withResolvers();
    const look = () => {
      if (this.status === "ready") resolve(undefined);
      else if (this.status !== "loading") reject(new Error(this.failure?.message ?? text.model.worker.stopped("")));
    };
    this.addEventListener("change", look, { signal: ended.signal });
    signal.addEventListener("abort", () => reject(signal.reason), { signal: ended.signal });
    look();
    return promise.finally(() => ended.abort());
  }

  /** Leaves the worker; the last puzzle that leaves it ends it. */
  stop() {
    this.#leave();
    this.#onChange();
  }

  /**
   * See WorkerClient.
   * @type {WorkerClient["call"]}
   */
  call(name, args, signal, onUpdate) {
    if (!this.#client) return Promise.reject(new Error(text.model.worker.notStarted));
    return this.#client.call(name, args, signal, onUpdate);
  }

  /** @param {string | null} name */
  #take(name) {
    const client = [...userCounts.keys()].find((one) => serves(one, name)) ?? new WorkerClient(this.#module);
    userCounts.set(client, (userCounts.get(client) ?? 0) + 1);
    this.#leave();
    this.#client = client;
    this.requestedName = name;
    client.addEventListener("change", this.#onChange);
    return client;
  }

  #leave() {
    const client = this.#client;
    if (!client) return;
    client.removeEventListener("change", this.#onChange);
    this.#client = null;
    this.#taking = false;
    this.requestedName = null;
    const others = (userCounts.get(client) ?? 1) - 1;
    if (others > 0) {
      userCounts.set(client, others);
    } else {
      userCounts.delete(client);
      client.stop();
    }
  }
}

/**
 * Does a worker load, or has it loaded, the model of this name? Null stands for the first model, which has a name too.
 * @param {WorkerClient} client
 * @param {string | null} name
 */
function serves({ requestedName, loaded }, name) {
  return requestedName === name || (loaded !== null && loaded.name === (name ?? loaded.names[0]));
}
