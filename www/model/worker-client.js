// The page's side of the worker: the model as an object with promises. It is loading, ready or failed; "change"
// says when that changes. A worker that dies fails what was asked of it, in words, and can be started again.

/** The turn of a puzzle is the same each time. */
const SEED = 0;

export class Model extends EventTarget {
  /** "off", "loading", "ready" or "failed". */
  status = "off";
  /** While loading: the share of the weights that is here, 0..1, or null if unknown. */
  progress = null;
  /** After a failure: what went wrong, in a sentence. */
  trouble = null;
  /** After a failure: its code; "no_model" if the name asked for is not there. */
  code = null;
  /** Once ready: { name, names, card }. */
  loaded = null;
  #module;
  #worker = null;
  #waiting = new Map();
  #next = 1;

  /** `module`: the compiled WebAssembly.Module, which page and worker share. */
  constructor(module) {
    super();
    this.#module = module;
  }

  /** Starts the worker and loads weights: those of a name, or the first. Never throws; see `status`. */
  async start(name) {
    this.#end("The model was started again.");
    this.#set("loading");
    const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
    this.#worker = worker;
    worker.addEventListener("message", ({ data }) => this.#answer(data));
    worker.addEventListener("error", (event) => {
      event.preventDefault();
      if (worker === this.#worker) this.#died(event.message);
    });
    try {
      await this.#ask("start", { module: this.#module });
      const loaded = await this.#ask("load", { name }, ({ progress }) => this.#set("loading", { progress }));
      this.#set("ready", { loaded });
    } catch (error) {
      if (worker === this.#worker) this.#set("failed", { trouble: error.message, code: error.code });
    }
  }

  /** The maps of a task: { maps: { base, target, action, placement, judge }, saw, milliseconds }; weights may have no judge. */
  imagine(task) {
    return this.#ask("imagine", { task });
  }

  /** The model's turn: calls `each` with every attempt; resolves to { finished }. */
  turn(task, each) {
    return this.#ask("turn", { task, seed: SEED }, ({ attempt }) => each(attempt));
  }

  /** The balls of that turn, untried: [{ ball, origin, passed }, …]. */
  propose(task) {
    return this.#ask("propose", { task, seed: SEED });
  }

  /** Where a ball of a radius solves a task: calls `each` with { picture, progress }; resolves to { finished }. Needs no
   * weights. */
  solve(task, radius, each) {
    return this.#ask("solve", { task, radius }, ({ map }) => each(map));
  }

  /** Ends the "turn" or the "solve" that is on, after what it is at. */
  stop(what) {
    this.#worker?.postMessage({ call: "stop", what });
  }

  #ask(call, rest, news = () => {}) {
    const id = this.#next++;
    return new Promise((resolve, reject) => {
      if (!this.#worker) return reject(new Error(this.trouble ?? "The model has not been started."));
      this.#waiting.set(id, { resolve, reject, news });
      this.#worker.postMessage({ id, call, ...rest });
    });
  }

  #answer({ id, ...news }) {
    const waiting = this.#waiting.get(id);
    if (!waiting) return;
    if ("error" in news || "value" in news) this.#waiting.delete(id);
    if ("error" in news) waiting.reject(Object.assign(new Error(news.error.message), { code: news.error.code }));
    else if ("value" in news) waiting.resolve(news.value);
    else waiting.news(news);
  }

  #died(message) {
    const trouble = `The model’s worker has stopped${message ? ` (${message})` : ""}.`;
    this.#end(trouble);
    this.#set("failed", { trouble });
  }

  #end(why) {
    this.#worker?.terminate();
    this.#worker = null;
    for (const { reject } of this.#waiting.values()) reject(new Error(why));
    this.#waiting.clear();
  }

  #set(status, { progress = null, trouble = null, code = null, loaded = null } = {}) {
    Object.assign(this, { status, progress, trouble, code, loaded });
    this.dispatchEvent(new Event("change"));
  }
}
