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

import { afterFrame } from "../loading/after-frame.js";
import { loadWasm } from "../loading/load-wasm.js";
import { puzzleMarkup } from "./markup.js";
import { Placeholder, placeholderSheet } from "./placeholder.js";
import { loadStyleSheets } from "./style-sheets.js";

/** @typedef {import("../state/url-state.js").State} State */
/** @typedef {import("../state/url-state.js").Panel} Panel */
/** @typedef {import("./controller.js").PlayedAttempt} PlayedAttempt */
/** @typedef {import("../play/after-solving.js").Result} Result */
/** @typedef {(task: string, panel: Panel) => string | null} HrefOf */

/** The attributes that make up the state; state/url-state.js knows their values. */
const STATE_ATTRIBUTES = [
  "task",
  "scene",
  "model",
  "panel",
  "step",
  "view",
  "proposal",
  "layers",
  "opacity",
  "forecast",
  "ball",
  "challenge",
  "hide",
];

/** The attributes that are on or off. */
const FLAGS = ["fill", "remember"];

/**
 * Frames that a page has for itself before a puzzle with nothing to show is made: its first pictures are in the
 * second.
 */
const FRAMES_FOR_THE_PAGE = 3;

const darkScheme = matchMedia("(prefers-color-scheme: dark)");

/**
 * Fires, all bubbling:
 *   "statechange"  the person has changed the state; `detail` is the State
 *   "attempt"      an attempt of the player's has run to its end, or was left; `detail` is a PlayedAttempt
 *   "share"        the person wants to share a result; `detail` is a Result. Only if `hrefOf` is set, or by `share()`
 *   "modelchange"  the model's status changes; `detail` is { name, status: "off" | "loading" | "ready" | "failed" }
 */
export class PathlightPuzzle extends HTMLElement {
  static observedAttributes = [...STATE_ATTRIBUTES, "stage", "theme", ...FLAGS];

  /** @type {HrefOf | null} */
  #hrefOf = null;
  #root = this.attachShadow({ mode: "open" });
  #placeholder = new Placeholder();
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
  /** Is the puzzle on its way, there, or failed since the element was connected? */
  #begun = false;
  #failed = false;
  #updating = false;
  /** Has the ball been set since the last update? */
  #ballGiven = false;
  /** Ends what the element listens to while it is connected. */
  #disconnected = new AbortController();

  constructor() {
    super();
    this.#root.adoptedStyleSheets = [placeholderSheet];
    this.#root.append(this.#placeholder.element);
  }

  connectedCallback() {
    this.#takeEarlyProperties();
    this.#disconnected.abort();
    this.#disconnected = new AbortController();
    const { signal } = this.#disconnected;
    darkScheme.addEventListener("change", () => this.#scheduleUpdate(), { signal });
    addEventListener("pagehide", () => this.#controller?.onPageHide(), { signal });
    if (!this.#controller) this.#prepare();
    this.#scheduleUpdate();
  }

  /**
   * Starts what the puzzle waits for longest. One with nothing to show leaves the page some frames for its own first
   * picture.
   */
  async #prepare() {
    const sheets = loadStyleSheets();
    // `#load` handles what becomes of them.
    sheets.catch(() => {});
    await Promise.allSettled([loadWasm(), sheets]);
    for (let frame = 0; frame < FRAMES_FOR_THE_PAGE; frame += 1) await afterFrame();
    if (this.isConnected) this.#loadOnce();
  }

  disconnectedCallback() {
    // An element that is moved within its page is connected again at once, and keeps its puzzle.
    queueMicrotask(() => {
      if (this.isConnected) return;
      this.#disconnected.abort();
      this.#controller?.release();
      // One that has failed is tried again where it is connected next.
      if (this.#failed) this.#begun = this.#failed = false;
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
    if (name === "stage") this.step = value;
    if (name === "ball") this.#ballGiven = true;
    this.#scheduleUpdate();
  }

  /**
   * Takes over the properties that were set before this file had defined the element: they are the object's own, and
   * hide the accessors.
   */
  #takeEarlyProperties() {
    for (const name of ["hrefOf", "state", ...PathlightPuzzle.observedAttributes]) {
      if (!Object.hasOwn(this, name)) continue;
      const value = Reflect.get(this, name);
      Reflect.deleteProperty(this, name);
      Reflect.set(this, name, value);
    }
  }

  /** The puzzle, "00007:008"; null for none. */
  get task() {
    return this.getAttribute("task");
  }
  set task(value) {
    this.#setAttribute("task", value);
  }
  /** A custom scene, as the link to it holds it; null for a task. */
  get scene() {
    return this.getAttribute("scene");
  }
  set scene(value) {
    this.#setAttribute("scene", value);
  }
  /** The name of the model; null for the first. */
  get model() {
    return this.getAttribute("model");
  }
  set model(value) {
    this.#setAttribute("model", value);
  }
  /** A tab, "play", "imagine" or "make", or a part: "compare", "predict" or "map"; null for "play". */
  get panel() {
    return this.getAttribute("panel");
  }
  set panel(value) {
    this.#setAttribute("panel", value);
  }
  /**
   * The step that the walkthrough is at: "base", "target", "action", "placement", "imagined" or "run"; null for all
   * together.
   */
  get step() {
    return this.getAttribute("step");
  }
  set step(value) {
    this.#setAttribute("step", value);
  }
  /** @deprecated The old name of `step`. */
  get stage() {
    return this.step;
  }
  set stage(value) {
    this.step = value;
  }
  /** "presentation" for the scene and one sentence, in large type; null for all panels. */
  get view() {
    return this.getAttribute("view");
  }
  set view(value) {
    this.#setAttribute("view", value);
  }
  /** The number of the model's ball that is looked at, from 1; null for none. */
  get proposal() {
    return this.getAttribute("proposal");
  }
  set proposal(value) {
    this.#setAttribute("proposal", value);
  }
  /**
   * The maps that lie over the scene: their names, with commas between them; null for those that the panel or the step
   * lays there by itself.
   */
  get layers() {
    return this.getAttribute("layers");
  }
  set layers(value) {
    this.#setAttribute("layers", value);
  }
  /** How much the maps cover, 0 to 1. */
  get opacity() {
    return this.getAttribute("opacity");
  }
  set opacity(value) {
    this.#setAttribute("opacity", value);
  }
  /**
   * "on" if the model's guess for the ball being placed is shown, "off" if not; null for what the person likes, where
   * that is remembered, else off.
   */
  get forecast() {
    return this.getAttribute("forecast");
  }
  set forecast(value) {
    this.#setAttribute("forecast", value);
  }
  /** The ball that is being placed: "x,y,r" in px of the scene; null for none. */
  get ball() {
    return this.getAttribute("ball");
  }
  set ball(value) {
    this.#ballGiven = true;
    this.#setAttribute("ball", value);
  }
  /** The attempt at which somebody solved the puzzle, whom the player is to beat; null for none. */
  get challenge() {
    return this.getAttribute("challenge");
  }
  set challenge(value) {
    this.#setAttribute("challenge", value);
  }
  /** The names of the parts that are hidden, with commas between them. */
  get hide() {
    return this.getAttribute("hide");
  }
  set hide(value) {
    this.#setAttribute("hide", value);
  }
  /** "light", "dark" or "auto"; null for "auto", which follows the system. */
  get theme() {
    return this.getAttribute("theme");
  }
  set theme(value) {
    this.#setAttribute("theme", value);
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
    if (state === null) return;
    this.#awaited = { ...state };
    if (this.#controller && this.isConnected) this.#applyAwaited(this.#controller);
    else this.#scheduleUpdate();
  }

  /**
   * Puts the focus on the scene.
   * @param {FocusOptions} [options]
   */
  focus(options) {
    this.#root.getElementById("scene")?.focus(options);
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
    await this.#controller?.settle();
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

  #loadOnce() {
    if (!this.#begun) this.#load();
  }

  async #load() {
    this.#begun = true;
    try {
      const [module, sheets] = await Promise.all([loadWasm(), loadStyleSheets()]);
      const [{ PuzzleController }, { sharedProgress }] = await Promise.all([
        import("./controller.js"),
        import("../storage/progress.js"),
      ]);
      this.#root.adoptedStyleSheets = [placeholderSheet, ...sheets];
      this.#root.append(puzzleMarkup());
      const progress = sharedProgress(this.hasAttribute("remember") ? "kept" : "forgotten");
      this.#controller = this.#listened(new PuzzleController(this.#root, module, progress, () => this.#hrefOf));
    } catch (error) {
      const { code, message } = /** @type {Error & { code?: string }} */ (error);
      this.#failed = true;
      this.#placeholder.showFailure(message, () => this.#loadAgain());
      this.#root.replaceChildren(this.#placeholder.element);
      // An error without a code is a bug of ours.
      if (!code) reportError(error);
      return;
    }
    this.#placeholder.element.remove();
    this.#update();
    for (const act of this.#awaitedCalls.splice(0)) this.#call(act);
  }

  async #loadAgain() {
    this.#placeholder.showLoading();
    await this.#load();
    // The focus was on the button that has gone.
    if (this.#controller) this.focus();
    else this.#placeholder.focus();
  }

  /** @param {import("./controller.js").PuzzleController} controller */
  #listened(controller) {
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
    return controller;
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
      const { task, scene } = this.#awaited ?? this;
      if (task !== null || scene !== null) this.#loadOnce();
      return;
    }
    const { theme } = this;
    controller.setTheme(theme === "dark" || (theme !== "light" && darkScheme.matches));
    if (this.#awaited) return this.#applyAwaited(controller);
    // The ball that was placed in one puzzle does not go on to the next.
    const { task, scene } = controller.texts;
    const shown = task ?? scene;
    if (shown && !ballGiven && (task !== this.task || scene !== this.scene)) this.ball = null;
    controller.applyTexts(
      STATE_ATTRIBUTES.filter((name) => this.hasAttribute(name)).map((name) => [name, this.getAttribute(name) ?? ""]),
    );
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
    for (const name of STATE_ATTRIBUTES) this.#setAttribute(name, texts[name]);
  }

  /**
   * @param {string} name
   * @param {string | null} value
   */
  #setAttribute(name, value) {
    if (value === null || value === undefined) this.removeAttribute(name);
    else if (value !== this.getAttribute(name)) this.setAttribute(name, value);
  }
}

// A page may load a second copy of this file from elsewhere; the first one stays.
if (!customElements.get("pathlight-puzzle")) customElements.define("pathlight-puzzle", PathlightPuzzle);
