// The address of the page and its history: another puzzle, a tab and a step are entries of their own; anything else, a
// place of the ball say, changes the present one a little later.

import { showsPuzzle } from "../state/links.js";
import { formatFragment, parseFragment } from "../state/url-state.js";

/** @typedef {import("../state/url-state.js").State} State */

/**
 * Least time between two changes of the address, ms. Browsers refuse to change it at every step of a drag, or of a key
 * that is held.
 */
const DELAY = 200;

/** Marks the entries that the page itself has written. */
const OWN_ENTRY = "pathlight";

export class Address {
  /** What has an entry of its own, as it was last written. */
  #place = "";
  /**
   * The state that is still to be written.
   * @type {State | null}
   */
  #waiting = null;
  /** @type {number | undefined} */
  #timer;
  /** When an entry was last added, ms. */
  #pushed = -DELAY;
  /** When the state was last changed, ms. */
  #changed = -DELAY;

  /** @param {(own: boolean) => void} onRoute the person has gone to another entry; has the page written it? */
  constructor(onRoute) {
    addEventListener("popstate", ({ state }) => {
      // It belongs to the entry that was left.
      this.#forget();
      onRoute(state === OWN_ENTRY);
    });
  }

  /** What the address asks for, and a sentence about what in it cannot be read (or null). */
  read() {
    return parseFragment(location.hash);
  }

  /**
   * The state that the address asked for is shown.
   * @param {State} state
   */
  take(state) {
    this.#place = placeOf(state);
  }

  /**
   * Adds an entry for a state.
   * @param {State} state
   */
  push(state) {
    this.flush();
    history.pushState(OWN_ENTRY, "", addressOf(state));
    this.#place = placeOf(state);
    this.#pushed = performance.now();
  }

  /**
   * Takes a state that the person has changed. Without a puzzle nothing is written.
   * @param {State} state
   */
  write(state) {
    if (!showsPuzzle(state)) return this.#forget();
    // At once, so that the way back leads to the place before, however soon it is taken.
    if (placeOf(state) !== this.#place && performance.now() - this.#pushed >= DELAY) return this.push(state);
    this.#waiting = state;
    clearTimeout(this.#timer);
    const now = performance.now();
    // A single change is written at once, so that a page that is loaded again right after it has it.
    if (now - this.#changed >= DELAY) this.flush();
    else this.#timer = setTimeout(() => this.flush(), DELAY);
    this.#changed = now;
  }

  /** Writes what is still to be written. */
  flush() {
    const state = this.#waiting;
    if (!state) return;
    this.#forget();
    if (placeOf(state) !== this.#place) this.push(state);
    else history.replaceState(OWN_ENTRY, "", addressOf(state));
  }

  #forget() {
    clearTimeout(this.#timer);
    this.#waiting = null;
  }
}

/** @param {State} state */
function addressOf(state) {
  return `#${formatFragment(state)}`;
}

/**
 * What of a state is worth an entry: the way back leads through tabs and steps, not through each place of a ball.
 * @param {State} state
 */
function placeOf({ task, panel, step, view }) {
  return String([task, panel, step, view]);
}
