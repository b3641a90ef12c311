// A search of the worker's that goes on until it is done, fails, or is stopped. Knows nothing of what is searched, nor
// of the document.

import { text } from "../text/text.js";

export class Search {
  /**
   * Why the last search failed, and what to do, or null.
   * @type {string | null}
   */
  failure = null;
  #onEnd;
  /** @type {AbortController | null} */
  #call = null;

  /** @param {() => void} onEnd called when a search has ended, however it did, but not when it is forgotten */
  constructor(onEnd) {
    this.#onEnd = onEnd;
  }

  get running() {
    return this.#call !== null;
  }

  /** @param {(signal: AbortSignal) => Promise<unknown>} ask */
  async start(ask) {
    this.forget();
    const call = (this.#call = new AbortController());
    try {
      await ask(call.signal);
    } catch (error) {
      if (!call.signal.aborted) this.failure = text.model.searchEnded(/** @type {Error} */ (error).message);
    }
    if (call === this.#call) this.stop();
  }

  stop() {
    if (!this.#call) return;
    this.#call.abort();
    this.#call = null;
    this.#onEnd();
  }

  /** Drops the search, and what is known of it: the puzzle is left. */
  forget() {
    this.#call?.abort();
    this.#call = null;
    this.failure = null;
  }
}
