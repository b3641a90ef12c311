// The custom element <pathlight-puzzle>: shows one puzzle in any page, without a frame. The page of Pathlight itself is
// made of it. Importing this file defines the element:
//
//     <script type="module" src="…/element/pathlight-puzzle.js"></script>
//     <pathlight-puzzle task="00007:008" panel="imagine"></pathlight-puzzle>
//
// The attributes say what is shown, follow the person, and can be changed at any time: `task` or `scene`, `model`,
// `panel`, `step`, `view`, `proposal`, `layers`, `opacity`, `forecast`, `ball`, `challenge` and `hide`, as in the
// links of Pathlight, and `theme`. Besides:
//   fill      takes the height of its container too, which must have one; else it is as high as its content
//   remember  keeps the attempts at each puzzle, their number and the one that solved it, in this browser
//             (localStorage); else they are forgotten with the page. Read once, when the puzzle is loaded
//
// This file knows only the element; everything else is loaded once the wasm is there.

import {
  FLAGS,
  PROPERTY_ATTRIBUTES,
  STATE_ATTRIBUTES,
  currentName,
  setAttribute,
  stateTexts,
  takeEarlyProperties,
} from "./attributes.js";
import { focusIsLost } from "../widgets/dom.js";
import { PuzzleLoader } from "./puzzle-loader.js";

/** @typedef {import("../state/url-state.js").State} State */
/** @typedef {import("../state/url-state.js").Panel} Panel */
/** @typedef {import("./controller.js").PlayedAttempt} PlayedAttempt */
/** @typedef {import("../play/after-solving.js").Result} Result */
/** @typedef {(task: string, panel: Panel) => string | null} HrefOf */

const darkScheme = matchMedia("(prefers-color-scheme: dark)");

/**
 * Fires, all bubbling:
 *   "statechange"  the person has changed the state; `detail` is the State
 *   "attempt"      an attempt of the player's has run to its end, or was left; `detail` is a PlayedAttempt
 *   "share"        the person wants to share a result; `detail` is a Result. Only if `hrefOf` is set, or by `share()`
 *   "modelchange"  the model's status changes; `detail` is { name, status: "off" | "loading" | "ready" | "failed" }
 */
export class PathlightPuzzle extends HTMLElement {
  static observedAttributes = [...PROPERTY_ATTRIBUTES, ...FLAGS];

  static {
    for (const name of PROPERTY_ATTRIBUTES) {
      Object.defineProperty(this.prototype, name, {
        get() {
          return this.getAttribute(currentName(name));
        },
        set(value) {
          if (name === "ball") this.#ballGiven = true;
          setAttribute(this, currentName(name), value);
        },
      });
    }
  }

  /** @type {HrefOf | null} */
  #hrefOf = null;
  #root = this.attachShadow({ mode: "open" });
  #loader = new PuzzleLoader(this.#root, {
    remembers: () => this.hasAttribute("remember"),
    hrefOf: () => this.#hrefOf,
    onLoad: (controller) => this.#onLoad(controller),
  });
  /** @type {import("./controller.js").PuzzleController | null} */
  #controller = null;
  /**
   * A state that was set before the controller was there.
   * @type {State | null}
   */
  #awaited = null;
  /**
   * What was asked of the controller before it was there.
   * @type {((controller: import("./controller.js").PuzzleController) => void)[]}
   */
  #awaitedCalls = [];
  #updating = false;
  /** Has the ball been set since the last update? */
  #ballGiven = false;
  /** What it showed before it was taken out of its page. @type {Record<string, string | null> | null} */
  #released = null;
  /** Ends what the element listens to while it is connected. */
  #disconnected = new AbortController();

  connectedCallback() {
    takeEarlyProperties(this, ["hrefOf", "state", ...PathlightPuzzle.observedAttributes]);
    this.#disconnected.abort();
    this.#disconnected = new AbortController();
    const { signal } = this.#disconnected;
    darkScheme.addEventListener("change", () => this.#scheduleUpdate(), { signal });
    addEventListener("pagehide", () => this.#controller?.onPageHide(), { signal });
    if (!this.#controller) this.#loader.prepare(() => this.isConnected);
    this.#scheduleUpdate();
  }

  disconnectedCallback() {
    // An element that is moved within its page is connected again at once, and keeps its puzzle.
    queueMicrotask(() => {
      if (this.isConnected) return;
      this.#disconnected.abort();
      this.#released = this.#controller?.texts ?? null;
      this.#controller?.release();
      // One that has failed is tried again where it is connected next.
      this.#loader.forgetFailure();
    });
  }

  /**
   * @param {string} name
   * @param {string | null} _
   * @param {string | null} value
   */
  attributeChangedCallback(name, _, value) {
    // React 18 writes `remember={false}` so.
    if (value === "false" && FLAGS.includes(name)) this.removeAttribute(name);
    if (currentName(name) !== name) setAttribute(this, currentName(name), value);
    if (name === "ball") this.#ballGiven = true;
    this.#scheduleUpdate();
  }

  /**
   * Returns the address of another puzzle, for links to it; null where it has none. Null: there are no such links.
   * @type {HrefOf | null}
   */
  get hrefOf() {
    return this.#hrefOf;
  }
  set hrefOf(value) {
    this.#hrefOf = value;
  }

  /**
   * All that the attributes say, as one object; null until the wasm is there, if it has not been set.
   * @type {State | null}
   */
  get state() {
    return this.#controller?.state ?? this.#awaited;
  }

  set state(state) {
    if (!state) return;
    this.#awaited = { ...state };
    if (this.#controller && this.isConnected) this.#applyAwaited(this.#controller);
    else this.#scheduleUpdate();
  }

  /**
   * Puts the focus on the scene; once the puzzle is loaded, if nothing else has it by then.
   * @param {FocusOptions} [options]
   */
  focus(options) {
    const isLoaded = this.#controller !== null;
    this.#call(() => {
      if (isLoaded || focusIsLost()) this.#root.getElementById("scene")?.focus(options);
    });
  }

  /** Fires "share" for the open puzzle, as when the person wants to share it. */
  share() {
    this.#call((controller) => controller.share());
  }

  /** Leads through the open puzzle, step by step. */
  startGuide() {
    this.#call((controller) => controller.startGuide());
  }

  /** Shows the sheet about the keys. */
  showKeys() {
    this.#call((controller) => controller.showDialog("keys-dialog"));
  }

  /** Shows the scene and one sentence in large type, or all panels again. */
  togglePresentation() {
    this.#controller?.togglePresentation();
  }

  /**
   * Resolves when the state is that of what is seen: a scene that is being edited becomes the puzzle only when it
   * rests.
   */
  async settle() {
    return (await this.#controller?.settle()) ?? true;
  }

  /** Shows the sheet about Pathlight and its model. */
  showAbout() {
    this.#call((controller) => controller.showDialog("about-dialog"));
  }

  /**
   * Acts on a key that was pressed elsewhere in the page. By itself the element hears only the keys that are pressed in
   * it, so that several puzzles in one page do not all react.
   * @param {KeyboardEvent} event
   */
  pressKey(event) {
    this.#controller?.onKeydown(event);
  }

  /**
   * Asks the controller for something, once it is there.
   * @param {(controller: import("./controller.js").PuzzleController) => void} act
   */
  #call(act) {
    if (this.#controller) act(this.#controller);
    else this.#awaitedCalls.push(act);
  }

  /** @param {import("./controller.js").PuzzleController} controller */
  #onLoad(controller) {
    this.#controller = controller;
    controller.addEventListener("statechange", () => {
      this.#reflect(controller);
      this.#dispatch("statechange", controller.state);
    });
    controller.addEventListener("share", (event) =>
      this.#dispatch("share", /** @type {CustomEvent<Result>} */ (event).detail),
    );
    controller.addEventListener("modelchange", () => this.#dispatch("modelchange", controller.model));
    controller.addEventListener("attempt", (event) =>
      this.#dispatch("attempt", /** @type {CustomEvent<PlayedAttempt>} */ (event).detail),
    );
    this.#update();
    for (const act of this.#awaitedCalls.splice(0)) this.#call(act);
  }

  /**
   * @param {string} type
   * @param {unknown} detail
   */
  #dispatch(type, detail) {
    this.dispatchEvent(new CustomEvent(type, { detail, bubbles: true }));
  }

  /** Takes all attributes that change now together. */
  #scheduleUpdate() {
    if (this.#updating) return;
    this.#updating = true;
    queueMicrotask(() => {
      this.#updating = false;
      this.#update();
    });
  }

  #update() {
    const controller = this.#controller;
    if (!this.isConnected) return;
    const ballGiven = this.#ballGiven;
    this.#ballGiven = false;
    if (!controller) {
      const asked = this.#awaited
        ? this.#awaited.task !== null || this.#awaited.scene !== null
        : this.hasAttribute("task") || this.hasAttribute("scene");
      if (asked) this.#loader.load();
      return;
    }
    const theme = this.getAttribute("theme");
    controller.setTheme(theme === "dark" || (theme !== "light" && darkScheme.matches));
    if (this.#awaited) return this.#applyAwaited(controller);
    // The ball that was placed in one puzzle does not go on to the next.
    const { task, scene } = this.#released ?? controller.texts;
    this.#released = null;
    const shown = task ?? scene;
    const isAnother = task !== this.getAttribute("task") || scene !== this.getAttribute("scene");
    if (shown && !ballGiven && isAnother) this.removeAttribute("ball");
    controller.applyTexts(stateTexts(this));
  }

  /** @param {import("./controller.js").PuzzleController} controller */
  #applyAwaited(controller) {
    const state = this.#awaited;
    this.#awaited = null;
    if (!state) return;
    controller.apply(state);
    this.#reflect(controller);
  }

  /**
   * Writes the state to the attributes.
   * @param {import("./controller.js").PuzzleController} controller
   */
  #reflect({ texts }) {
    for (const name of STATE_ATTRIBUTES) setAttribute(this, name, texts[name]);
  }
}

// A page may load a second copy of this file from elsewhere; the first one stays.
if (!customElements.get("pathlight-puzzle")) customElements.define("pathlight-puzzle", PathlightPuzzle);
