// The model of one puzzle. Puzzles of a page that ask for the same model share its worker: each worker holds the weights and
// an instance of the wasm, and a lesson may show many puzzles. Has the calls and the events of a WorkerClient, and follows
// the one that it uses at present.

import { WorkerClient } from "./worker-client.js";

/**
 * The workers that are in use, by the name that they were asked for: null for the first model.
 * @type {Map<string | null, { client: WorkerClient, users: number }>}
 */
const shared = new Map();

export class SharedClient extends EventTarget {
  /**
   * The name that was last asked for; null for the first model, and while there is none.
   * @type {string | null}
   */
  requestedName = null;
  #module;
  /** @type {WorkerClient | null} */
  #client = null;
  /** Is another worker taken, so that nothing of the one before counts? */
  #changing = false;
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
    return this.#changing ? "loading" : (this.#client?.status ?? "off");
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
    return this.#changing ? null : (this.#client?.loaded ?? null);
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
    // What came from another model goes, as it would while this one was loading.
    this.#changing = true;
    this.#onChange();
    this.#changing = false;
    this.#onChange();
  }

  /** Leaves the worker; the last puzzle that leaves it ends it. */
  stop() {
    this.#leave();
    this.#onChange();
  }

  /** @param {Parameters<WorkerClient["imagine"]>} args */
  imagine(...args) {
    return this.#taken.imagine(...args);
  }

  /** @param {Parameters<WorkerClient["turn"]>} args */
  turn(...args) {
    return this.#taken.turn(...args);
  }

  /** @param {Parameters<WorkerClient["propose"]>} args */
  propose(...args) {
    return this.#taken.propose(...args);
  }

  /** @param {Parameters<WorkerClient["solve"]>} args */
  solve(...args) {
    return this.#taken.solve(...args);
  }

  get #taken() {
    if (!this.#client) throw new Error("The model has not been started.");
    return this.#client;
  }

  /** @param {string | null} name */
  #take(name) {
    const entry = shared.get(name) ?? { client: new WorkerClient(this.#module), users: 0 };
    entry.users += 1;
    shared.set(name, entry);
    this.#leave();
    this.#client = entry.client;
    this.requestedName = name;
    entry.client.addEventListener("change", this.#onChange);
    return entry.client;
  }

  #leave() {
    const client = this.#client;
    const entry = shared.get(this.requestedName);
    if (!client || !entry) return;
    client.removeEventListener("change", this.#onChange);
    this.#client = null;
    entry.users -= 1;
    if (entry.users === 0) {
      shared.delete(this.requestedName);
      client.stop();
    }
    this.requestedName = null;
  }
}
