// The page's side of the worker: each call is a promise. Once its signal is aborted, it rejects with the signal's
// reason and ignores later answers of the worker.

import { loadError } from "./loading.ts";
import type { Failure } from "../core/change/model.ts";
import type { Calls } from "./worker.ts";

type Answer<Name extends keyof Calls> =
  ReturnType<Calls[Name]> extends Generator<infer Update, infer Value> | AsyncGenerator<infer Update, infer Value>
    ? { update: Update; value: Value }
    : { update: never; value: Awaited<ReturnType<Calls[Name]>> };

interface Pending {
  resolve(value: any): void;
  reject(reason: unknown): void;
  onUpdate(update: any): void;
}

/** Rejected calls have a `failure`, unless they were aborted. */
export class WorkerError extends Error {
  readonly failure: Failure;

  constructor(failure: Failure) {
    super(failure.reason);
    this.failure = failure;
  }
}

export class ModelClient {
  #worker: Worker | null = null;
  /** Why there is no worker. */
  #ended: Failure = { code: "broken", reason: "There is no worker." };
  #pending = new Map<number, Pending>();
  #lastId = 0;
  #onCrash: (failure: Failure) => void;
  #create: () => Worker;
  #script: string;

  /** `script` is the address of the worker's code, to find out why it does not start. */
  constructor(create: () => Worker, script: string, onCrash: (failure: Failure) => void) {
    this.#create = create;
    this.#script = script;
    this.#onCrash = onCrash;
  }

  /** Replaces the worker by a new one. Open calls reject. */
  start(): void {
    this.stop({ code: "broken", reason: "The worker was started again." });
    const worker = (this.#worker = this.#create());
    worker.addEventListener("message", ({ data }) => worker === this.#worker && this.#onMessage(data));
    worker.addEventListener("error", async (event) => {
      event.preventDefault();
      // Without a message, its code could not even be loaded.
      const failure: Failure = event.message
        ? { code: "crashed", reason: event.message }
        : (await loadError(this.#script, "the worker could not be loaded", "worker")).failure;
      if (worker === this.#worker) this.#crash(failure);
    });
  }

  stop(failure: Failure): void {
    this.#worker?.terminate();
    this.#worker = null;
    this.#ended = failure;
    const pending = [...this.#pending.values()];
    this.#pending.clear();
    for (const { reject } of pending) reject(new WorkerError(failure));
  }

  call<Name extends keyof Calls>(
    call: Name,
    args: Parameters<Calls[Name]>,
    signal: AbortSignal | null,
    onUpdate: (update: NonNullable<Answer<Name>["update"]>) => void = () => {},
  ): Promise<Answer<Name>["value"]> {
    if (signal?.aborted) return Promise.reject(signal.reason);
    const worker = this.#worker;
    if (!worker) return Promise.reject(new WorkerError(this.#ended));
    const id = ++this.#lastId;
    let onAbort = () => {};
    const answer = new Promise<Answer<Name>["value"]>((resolve, reject) => {
      this.#pending.set(id, { resolve, reject, onUpdate });
      onAbort = () => {
        if (!this.#pending.delete(id)) return;
        worker.postMessage({ cancel: id });
        reject(signal!.reason);
      };
    });
    signal?.addEventListener("abort", onAbort);
    worker.postMessage({ id, call, args });
    return answer.finally(() => signal?.removeEventListener("abort", onAbort));
  }

  #onMessage({ id, value, update, failure }: { id: number; value?: any; update?: any; failure?: Failure }): void {
    if (failure?.code === "crashed") return this.#crash(failure);
    const call = this.#pending.get(id);
    if (!call) return;
    if (update !== undefined) return call.onUpdate(update);
    this.#pending.delete(id);
    if (failure) call.reject(new WorkerError(failure));
    else call.resolve(value);
  }

  #crash(failure: Failure): void {
    this.stop(failure);
    this.#onCrash(failure);
  }
}
