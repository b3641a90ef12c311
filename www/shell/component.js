// The lifecycle that every part of the page shares. page.js holds one list of components and calls on each of them:
//
//   setTheme(dark)    at the start, and whenever the colour scheme changes, also while no puzzle is open
//   open(session)     a puzzle has been opened; at most one is open at a time
//   setState(view)    what the address says has changed; also after every open, and on the grid
//   close()           the puzzle is being left, also when another follows. Its session and the wasm memory behind it are
//                     freed right afterwards, so nothing of it may be kept or called: running worker calls are aborted,
//                     and listeners on the session are dropped by the base class
//
// A component asks the page for another state by `requestState` (event "staterequest") and for the model to be started
// once more by `requestModel` (event "modelrequest"). It never changes the address itself.

/** @typedef {import("../play/session.js").Session} Session */
/** @typedef {import("./url-state.js").State} State */
/** @typedef {import("./url-state.js").View} View */

export class Component extends EventTarget {
  /**
   * The open puzzle, or null.
   * @protected
   * @type {Session | null}
   */
  session = null;
  /** Is the colour scheme dark? */
  dark = false;
  #closed = new AbortController();

  /** @param {Session} session */
  open(session) {
    this.session = session;
    this.#closed = new AbortController();
  }

  close() {
    this.#closed.abort();
    this.session = null;
  }

  /** @type {(view: View) => void} */
  setState() {}

  /** @param {boolean} dark */
  setTheme(dark) {
    this.dark = dark;
  }

  /**
   * Listens to the open session until it is closed.
   * @protected
   * @param {"change" | "draw" | "attempted"} event
   * @param {(session: Session) => void} act
   */
  listen(event, act) {
    const session = this.session;
    session?.addEventListener(event, () => act(session), { signal: this.#closed.signal });
  }

  /**
   * @protected
   * @param {Partial<State>} patch
   */
  requestState(patch) {
    this.dispatchEvent(new CustomEvent("staterequest", { detail: patch }));
  }

  /** @protected */
  requestModel() {
    this.dispatchEvent(new Event("modelrequest"));
  }
}
