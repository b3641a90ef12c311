// Joins the components of one puzzle in its shadow tree: opens and closes its session, starts its model, and passes the
// state to all of them. Each component knows the session and the wasm; only components.js, panel-components.js and this
// file know all of them. shell/component.js describes their lifecycle. Knows nothing of the page around the shadow
// tree, nor of its address.

import { palette } from "../pkg/pathlight.js";
import { afterFrame } from "../shell/after-frame.js";
import { SharedClient } from "../model/shared-client.js";
import { Session } from "../play/session.js";
import { byId, find, setText } from "../shell/dom.js";
import { hideParts } from "../shell/hidden-parts.js";
import { onShortcut } from "../shell/shortcuts.js";
import { TASKS } from "../shell/templates.js";
import {
  INITIAL_STATE,
  formatFragment,
  formatState,
  parseState,
  showsPuzzle,
  viewOf,
  visiblePanels,
} from "../shell/url-state.js";
import { knownScene, sceneOfText } from "../workshop/scene-link.js";
import { Components } from "./components.js";

/** @typedef {import("../shell/url-state.js").State} State */

/**
 * An attempt of the player's that has run to its end; the task is null for an own scene.
 * @typedef {{ task: string | null, number: number, ball: import("../pkg/pathlight.js").Ball, solved: boolean }}
 *   PlayedAttempt
 */

const KNOWN_TASKS = new Set(TASKS);
const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");

export class PuzzleController extends EventTarget {
  /** @type {State} */
  #state = { ...INITIAL_STATE };
  #root;
  #progress;
  #hrefOf;
  #client;
  #components;
  /** Are the components of the panels on their way, or there? */
  #panelsAwaited = false;
  /** @type {Session | null} */
  #session = null;
  /**
   * The text of an own scene that could not be read, and why.
   * @type {{ text: string, sentence: string } | null}
   */
  #unreadable = null;
  #lastModel;
  /** @type {boolean | null} */
  #dark = null;

  /**
   * Fires "statechange" when the person has changed the state, "modelchange" when the model's status changes, and
   * "attempt", a CustomEvent with a PlayedAttempt, when an attempt of the player's has run to its end or was left.
   * @param {ShadowRoot} root
   * @param {WebAssembly.Module} module
   * @param {import("../shell/progress-store.js").SharedProgress} progress
   * @param {() => ((task: string, panel: import("../shell/url-state.js").Panel) => string | null) | null} hrefOf
   *   returns the function that knows the addresses of other puzzles, or null if there is no way to them
   */
  constructor(root, module, progress, hrefOf) {
    super();
    this.#root = root;
    this.#progress = progress;
    this.#hrefOf = hrefOf;
    this.#client = new SharedClient(module);
    this.#lastModel = this.model;
    const parts = {
      root,
      module,
      client: this.#client,
      progress,
      hrefOf: (/** @type {string} */ task, /** @type {import("../shell/url-state.js").Panel} */ panel) =>
        hrefOf()?.(task, panel) ?? null,
    };
    this.#components = new Components(parts, (component) => this.#listenTo(component));
    this.#components.afterSolving.addEventListener("share", (event) =>
      this.dispatchEvent(new CustomEvent("share", { detail: /** @type {CustomEvent} */ (event).detail })),
    );
    this.#client.addEventListener("change", () => this.#onClientChange());
    for (const button of root.querySelectorAll("button[data-opens]")) {
      button.addEventListener("click", () => this.showDialog(button.getAttribute("data-opens") ?? ""));
    }
    root.addEventListener("keydown", (event) => this.onKeydown(/** @type {KeyboardEvent} */ (event)));
  }

  /** @param {import("../shell/component.js").Component} component */
  #listenTo(component) {
    component.addEventListener("staterequest", (event) =>
      this.#changeState(/** @type {CustomEvent<Partial<State>>} */ (event).detail),
    );
    component.addEventListener("modelrequest", () => this.#requestModel());
  }

  /**
   * Makes the components of the panels: once the scene is drawn, or at once if another panel than Play is asked for.
   */
  async #makePanels() {
    if (this.#panelsAwaited) return;
    this.#panelsAwaited = true;
    const { panel, view } = this.#state;
    if (panel === "play" && view === null) await afterFrame();
    try {
      await this.#components.addPanels();
    } catch (error) {
      this.#panelsAwaited = false;
      this.#showProblem(
        "The panels of this puzzle could not be loaded. Check the connection, and load the page again.",
      );
      throw error;
    }
    if (this.#session) this.#startModel();
    this.#applyView();
  }

  /** Returns a copy of the state. */
  get state() {
    return { ...this.#state };
  }

  /** Returns the state as text by key; null where it is as at the start. */
  get texts() {
    return formatState(this.#state);
  }

  /** Returns the name of the model that is loaded, or null, and its status. */
  get model() {
    const { status, loaded } = this.#client;
    return { name: loaded?.name ?? null, status };
  }

  /**
   * Shows what texts by key ask for, if that differs from what is shown.
   * @param {[key: string, text: string][]} texts
   */
  applyTexts(texts) {
    const { state, unread } = parseState(texts);
    if (formatFragment(state) !== formatFragment(this.#state)) this.apply(state);
    const words = unread.map(([key, text]) => `${key}="${text}"`);
    if (words.length)
      this.#showProblem(`This puzzle is asked for with ${words.join(" and ")}, which Pathlight does not understand.`);
    else this.#showProblem(this.#problemOf(state));
  }

  /**
   * Replaces the whole state.
   * @param {State} state
   */
  apply(state) {
    const modelChanged = state.model !== this.#client.requestedName;
    // What is left behind may still change the old state, so it goes first.
    if (state.task !== this.#state.task || state.scene !== this.#state.scene) this.#closePuzzle();
    else if (modelChanged) this.#session?.clearModelAttempts();
    this.#state = { ...state };
    const { ball } = state;
    const played = this.#playedOf(state);
    const problem = this.#problemOf(state);
    this.#showProblem(problem);
    find(this.#root, ".puzzle").hidden = !showsPuzzle(state) || problem !== null;
    if (played !== null && !problem) {
      const session = (this.#session ??= this.#openPuzzle(played));
      if (String(ball) !== String(session.ball)) session.placement.replace(ball);
      if (modelChanged || this.#client.status === "off") this.#startModel();
    }
    this.#applyView();
    this.#makePanels();
  }

  /**
   * What a state plays; null if it is nothing, or an own scene that is still to be read. Then the state is applied
   * again.
   * @param {State} state
   * @returns {import("../pkg/pathlight.js").Played | null}
   */
  #playedOf({ task, scene }) {
    if (scene === null) return task;
    const known = knownScene(scene);
    if (!known && this.#unreadable?.text !== scene) this.#readScene(scene);
    return known;
  }

  /** @param {string} text */
  async #readScene(text) {
    try {
      await sceneOfText(text);
    } catch (error) {
      this.#unreadable = { text, sentence: /** @type {Error} */ (error).message };
    }
    if (this.#state.scene === text) this.apply(this.#state);
  }

  /**
   * Why there is no puzzle for a state; null if there is one, or may be.
   * @param {State} state
   */
  #problemOf({ task, scene }) {
    if (scene !== null) return this.#unreadable?.text === scene ? this.#unreadable.sentence : null;
    return task === null || KNOWN_TASKS.has(task) ? null : `There is no puzzle ${task}.`;
  }

  /**
   * Applies the colour scheme to what the wasm paints, and its colours to the style sheet.
   * @param {boolean} dark
   */
  setTheme(dark) {
    if (dark === this.#dark) return;
    this.#dark = dark;
    const { style } = find(this.#root, ".puzzle");
    for (const [name, colour] of Object.entries(palette(dark))) style.setProperty(`--${name}`, colour);
    this.#components.setTheme(dark);
  }

  /** The page is being left, perhaps for good: an attempt that runs is kept, as it is when its puzzle is left. */
  onPageHide() {
    this.#session?.revealResult();
  }

  /** Closes the puzzle and ends the worker; `apply` begins anew. */
  release() {
    this.#closePuzzle();
    this.#client.stop();
    this.#state = { ...INITIAL_STATE };
  }

  /**
   * Acts on a shortcut.
   * @param {KeyboardEvent} event
   */
  onKeydown(event) {
    this.#components.panels?.stageView.onKeydown(event);
    onShortcut(event, {
      session: this.#session,
      undoing:
        this.#state.panel === "bend" ? (this.#components.panels?.bend ?? null) : (this.#session?.placement ?? null),
      scene: this.#components.canvas,
      showPanel: (index) => {
        const panel = visiblePanels(this.#state)[index];
        if (panel) this.#changeState({ panel });
      },
      // What a link for a lesson hides has no key either.
      showKeys: () => !this.#locked && this.showDialog("keys-dialog"),
      goToOtherOutcome: (by) => this.#components.panels?.proposals.goToOtherOutcome(by),
      toggleStageView: () => !this.#locked && this.toggleStageView(),
    });
  }

  /**
   * Shows the scene and one sentence, or all panels again. The story begins with the goal, unless the person was in the
   * middle of it.
   */
  toggleStageView() {
    const { view, stage, panel } = this.#state;
    this.#changeState(view === "stage" ? { view: null } : { view: "stage", stage: panel === "imagine" ? stage : null });
  }

  /** Resolves when the state is that of what is seen. */
  async settle() {
    await this.#session?.settle?.();
  }

  /** Leads through the open puzzle, step by step. */
  startGuide() {
    this.#components.guide.start();
  }

  /** @param {string} id */
  showDialog(id) {
    byId(this.#root, id, HTMLDialogElement).showModal();
  }

  /** @param {import("../pkg/pathlight.js").Played} played */
  #openPuzzle(played) {
    const session = new Session(played, () => reducedMotion.matches);
    find(this.#root, ".puzzle").setAttribute(
      "aria-label",
      `Puzzle ${session.about.name} ${session.about.id ?? ""}`.trim(),
    );
    session.addEventListener("change", () => this.#onSessionChange(session));
    session.addEventListener("attempted", () => this.#onAttempted(session));
    this.#components.open(session);
    return session;
  }

  #closePuzzle() {
    const session = this.#session;
    if (!session) return;
    this.#session = null;
    // While the components still listen.
    session.revealResult();
    this.#components.close();
    session.close();
  }

  /**
   * Changes the state of the same puzzle, because the person has asked for it.
   * @param {Partial<State>} patch
   */
  #changeState(patch) {
    if ("scene" in patch) {
      // Another puzzle, with the ball where it was.
      this.apply({ ...this.#state, ...patch });
      this.dispatchEvent(new Event("statechange"));
      return;
    }
    Object.assign(this.#state, patch);
    if (this.#state.model !== this.#client.requestedName) {
      // The attempts of the model that goes, before the new one brings its own back.
      this.#session?.clearModelAttempts();
      // Unless a component that saw them go has changed the state, and so started it already.
      if (this.#state.model !== this.#client.requestedName) this.#startModel();
    }
    this.#applyView();
    this.dispatchEvent(new Event("statechange"));
  }

  /**
   * Starts the model, unless no panel that needs it is shown; Play and Bend ask for it where they need it. The panels,
   * which show what comes of it, have to be there.
   */
  #startModel() {
    if (this.#components.panels && visiblePanels(this.#state).some((one) => one !== "play" && one !== "bend"))
      this.#client.start(this.#state.model);
  }

  /** Does a link leave out the buttons that lead away from what it shows? */
  get #locked() {
    return this.#state.hide.includes("tools");
  }

  /**
   * Starts the model because it is asked for, whatever is shown; falls back to the first model if the name is unknown.
   */
  #requestModel() {
    if (this.#client.failure?.code === "no_model") this.#changeState({ model: null });
    else this.#client.start(this.#state.model);
  }

  #onClientChange() {
    const { name, status } = this.model;
    if (name === this.#lastModel.name && status === this.#lastModel.status) return;
    this.#lastModel = { name, status };
    this.dispatchEvent(new Event("modelchange"));
  }

  /**
   * Takes the ball into the state.
   * @param {Session} session
   */
  #onSessionChange(session) {
    if (session !== this.#session || String(session.ball) === String(this.#state.ball)) return;
    this.#state.ball = session.ball;
    this.dispatchEvent(new Event("statechange"));
  }

  /** @param {Session} session */
  #onAttempted({ about, shown }) {
    if (!shown) return;
    const { number, ball, ending } = shown;
    // The progress is on the benchmark's tasks.
    if (about.id !== null) this.#progress.player.add(about.id, ending.solved);
    /** @type {PlayedAttempt} */
    const attempt = { task: about.id, number, ball, solved: ending.solved };
    this.dispatchEvent(new CustomEvent("attempt", { detail: attempt }));
  }

  /** Passes the visible state to all components. */
  #applyView() {
    const view = viewOf(this.#state);
    hideParts(this.#root, this.#hrefOf() ? view.hide : [...view.hide, "puzzles"]);
    this.#components.setState(view);
  }

  /** @param {string | null} sentence */
  #showProblem(sentence) {
    const problem = byId(this.#root, "problem");
    problem.hidden = sentence === null;
    setText(problem, sentence ?? "");
  }
}
