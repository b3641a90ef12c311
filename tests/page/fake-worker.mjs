// A Worker that does nothing by itself: a test reads what it was sent, and answers.

/** All that were made, in order. @type {FakeWorker[]} */
export const workers = [];

export class FakeWorker extends EventTarget {
  sent = /** @type {any[]} */ ([]);
  terminated = false;

  constructor() {
    super();
    workers.push(this);
  }

  postMessage(message) {
    this.sent.push(message);
  }

  terminate() {
    this.terminated = true;
  }

  /** Sends a message about the request of this name that was made last. */
  answer(call, message) {
    const { id } = this.sent.findLast((request) => request.call === call);
    this.dispatchEvent(new MessageEvent("message", { data: { id, ...message } }));
  }
}

Object.assign(globalThis, { Worker: FakeWorker });

export const MODULE = new WebAssembly.Module(Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0));
export const LOADED = { name: "within-0", names: ["within-0", "cross-0"], card: {} };

/** Lets all promises that are settled go on. */
export const settled = () => new Promise((resolve) => setImmediate(resolve));
