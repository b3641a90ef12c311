// The lifecycle that every part of a puzzle shares. element/controller.js holds one list of components and calls on
// each of them:
//
// - `setTheme(dark)` at the start, and whenever the colour scheme changes, also while no puzzle is open.
// - `open(session)` when a puzzle has been opened; at most one is open at a time.
// - `setState(view)` when the state has changed; also after every open, and while no puzzle is open.
// - `close()` when the puzzle is being left, also when another follows. Its session and the wasm memory behind it are
//   freed right afterwards, so nothing of it may be kept or called: running worker calls are aborted, and listeners on
//   the session are dropped by the base class.
//
// What a component lays over the scene is its `overlay`; it says by `changeOverlay` that this has changed.
// A component finds its elements in the root that it is given, so that several puzzles live in one page. It asks for
// another state by `requestState` (event "staterequest") and for the model to be started once more by `requestModel`
// (event "modelrequest").

import { byId, fromTemplate, passFocus, setText } from "./dom.js";

/** @typedef {import("../play/session.js").Session} Session */
/** @typedef {import("../state/url-state.js").State} State */
/** @typedef {import("../state/view.js").View} View */
/** @typedef {import("./dom.js").Root} Root */

export class Component extends EventTarget {
  /**
   * The open puzzle, or null.
   * @protected
   * @type {Session | null}
   */
  session = null;
  /** Is the colour scheme dark? */
  dark = false;
  #root;
  #closed = new AbortController();

  /** @param {Root} root holds the elements that this component looks up */
  constructor(root) {
    super();
    this.#root = root;
  }

  /** @param {Session} session */
  open(session) {
    this.session = session;
    this.#closed = new AbortController();
  }

  close() {
    this.#closed.abort();
    this.session = null;
  }

  /** @param {View} view */
  setState(view) {
    // Named for the type that its subclasses share.
    void view;
  }

  /** @param {boolean} dark */
  setTheme(dark) {
    this.dark = dark;
  }

  /**
   * What lies over the scene now; null for nothing.
   * @returns {Partial<import("../play/canvas.js").Overlay> | null}
   */
  get overlay() {
    return null;
  }

  /** @protected */
  changeOverlay() {
    this.dispatchEvent(new Event("overlay"));
  }

  /**
   * Listens to the open session until it is closed.
   * @protected
   * @param {"change" | "draw" | "attempted"} event
   * @param {(session: Session) => void} act
   */
  listen(event, act) {
    const session = this.session;
    if (session) this.listenTo(session, event, () => act(session));
  }

  /**
   * Listens to what outlives the open session, until it is closed.
   * @protected
   * @param {EventTarget} target
   * @param {string} event
   * @param {(event: Event) => void} act
   */
  listenTo(target, event, act) {
    target.addEventListener(event, act, { signal: this.#closed.signal });
  }

  /**
   * The element of this id in the component's root, checked to be of a class.
   * @protected
   * @template {Element} [T=HTMLElement]
   * @param {string} id
   * @param {new () => T} [type] HTMLElement if left out
   */
  byId(id, type) {
    return byId(this.#root, id, type);
  }

  /**
   * A copy of what a <template> in the component's root holds.
   * @protected
   * @param {string} id
   */
  fromTemplate(id) {
    return fromTemplate(this.#root, id);
  }

  /**
   * Hides an element, or shows it. The focus that is in it goes to the scene.
   * @protected
   * @param {HTMLElement} element
   * @param {boolean} hidden
   */
  setHidden(element, hidden) {
    if (hidden) passFocus(element, this.byId("scene"));
    element.hidden = hidden;
  }

  /**
   * Disables a button, or enables it. The focus that is on it goes to the scene.
   * @protected
   * @param {HTMLButtonElement} button
   * @param {boolean} disabled
   */
  setDisabled(button, disabled) {
    if (disabled) passFocus(button, this.byId("scene"));
    button.disabled = disabled;
  }

  /**
   * Writes a sentence to the only live region of the root: a screen reader reads it as soon as there is time, and a
   * later one replaces one that has not been read yet.
   * @protected
   * @param {string} sentence
   */
  announce(sentence) {
    setText(this.byId("announcement"), sentence);
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
