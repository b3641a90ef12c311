// Joins the components of one puzzle in its shadow tree: opens and closes its session, starts its model, and passes the
// state to all of them. Each component knows the session and the wasm; only components.js, panel-components.js and this
// file know all of them. widgets/component.js describes their lifecycle. Knows nothing of the page around the shadow
// tree, nor of its address.

import { ModelMemory } from "../model/model-memory.js";
import { SharedClient } from "../model/shared-client.js";
import { Session } from "../play/session.js";
import { Preferences } from "../storage/preferences.js";
import { byId, find, setText } from "../widgets/dom.js";
import { hideParts } from "../widgets/hidden-parts.js";
import { sameBall } from "../puzzles/ball.js";
import { showsPuzzle } from "../state/links.js";
import { INITIAL_STATE, completed, formatFragment, formatState, parseState } from "../state/url-state.js";
import { viewOf, withPresentation, withoutPresentation } from "../state/view.js";
import { text } from "../text/text.js";
import { AskedPuzzle } from "./asked-puzzle.js";
import { Components } from "./components.js";
import { closeDialogs, connectOpeners, showDialog } from "./dialogs.js";
import { onPuzzleKey } from "./shortcuts.js";
import { ModelStarter } from "./model-starter.js";

/** @typedef {import("../state/url-state.js").State} State */
/** @typedef {import("./pathlight-puzzle.js").HrefOf} HrefOf */
/**
 * An attempt of the player's that has run to its end; the task is null for a custom scene.
 * @typedef {{ task: string | null, number: number, ball: import("../pkg/pathlight.js").Ball, solved: boolean }}
 *   PlayedAttempt
 */

const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");

export class PuzzleController extends EventTarget {
  /** @type {State} */
  #state = { ...INITIAL_STATE };
  #root;
  #hrefOf;
  #client;
  #components;
  /** @type {Session | null} */
  #session = null;
  #asked = new AskedPuzzle((scene) => {
    if (this.#state.scene === scene) this.apply(this.#state);
  });
  #modelStarter;
  #preferences;

  /**
   * Fires "statechange" when the person has changed the state, "modelchange" when the model's status changes, and
   * "attempt", a CustomEvent with a PlayedAttempt, when an attempt of the player's has run to its end or was left.
   * @param {ShadowRoot} root
   * @param {WebAssembly.Module} module
   * @param {import("../storage/progress.js").Progress} progress
   * @param {() => HrefOf | null} hrefOf returns the function that knows the addresses of other puzzles, or null if
   *   there is no way to them
   */
  constructor(root, module, progress, hrefOf) {
    super();
    this.#root = root;
    this.#hrefOf = hrefOf;
    this.#client = new SharedClient(module);
    this.#preferences = new Preferences(progress.persistent);
    this.#modelStarter = new ModelStarter(this.#client);
    this.#modelStarter.addEventListener("change", () => this.dispatchEvent(new Event("modelchange")));
    const parts = {
      root,
      module,
      client: this.#client,
      progress,
      preferences: this.#preferences,
      memory: new ModelMemory(this.#client, progress.memory),
      hrefOf: /** @type {HrefOf} */ ((task, panel) => hrefOf()?.(task, panel) ?? null),
    };
    this.#components = new Components(parts, (component) => this.#listenTo(component));
    this.#components.afterSolving.addEventListener("share", (event) =>
      this.dispatchEvent(new CustomEvent("share", { detail: /** @type {CustomEvent} */ (event).detail })),
    );
    connectOpeners(root);
    root.addEventListener("keydown", (event) => this.onKeydown(/** @type {KeyboardEvent} */ (event)));
  }

  /** @param {import("../widgets/component.js").Component} component */
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
    const { panel, view } = this.#state;
    try {
      if (!(await this.#components.addPanels(panel === "play" && view === null))) return;
    } catch {
      return this.#showProblem(text.element.noPanels);
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
    return this.#modelStarter.model;
  }

  /**
   * Shows what texts by key ask for, if that differs from what is shown.
   * @param {[key: string, text: string][]} texts
   */
  applyTexts(texts) {
    const { state, unread } = parseState(texts);
    if (formatFragment(state) !== formatFragment(this.#state)) this.apply(state);
    const attributes = unread.map(([key, value]) => `${key}="${value}"`);
    this.#showProblem(attributes.length ? text.element.unread(attributes) : this.#asked.problemOf(state));
  }

  /**
   * Replaces the whole state.
   * @param {Partial<State>} asked missing values are the initial ones
   */
  apply(asked) {
    const state = completed(asked);
    const modelChanged = state.model !== this.#client.requestedName;
    // Closing the puzzle may still change the old state, so it comes first.
    if (state.task !== this.#state.task || state.scene !== this.#state.scene) this.#closePuzzle();
    else if (modelChanged) this.#session?.clearModelAttempts();
    this.#state = state;
    const puzzle = this.#asked.puzzleOf(state);
    const problem = this.#asked.problemOf(state);
    this.#showProblem(problem);
    find(this.#root, ".puzzle").hidden = !showsPuzzle(state) || problem !== null;
    if (puzzle !== null && !problem) {
      const session = (this.#session ??= this.#openPuzzle(puzzle));
      if (!sameBall(state.ball, session.ball)) session.placement.replace(state.ball);
      if (modelChanged || this.#client.status === "off") this.#startModel();
    }
    this.#applyView();
    this.#makePanels();
  }

  /** @param {boolean} dark */
  setTheme(dark) {
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

  /** @param {KeyboardEvent} event */
  onKeydown(event) {
    onPuzzleKey(event, {
      components: this.#components,
      session: this.#session,
      state: this.#state,
      showPanel: (panel) => this.#changeState({ panel }),
      showKeys: () => this.showDialog("keys-dialog"),
      togglePresentation: () => this.togglePresentation(),
    });
  }

  /** Shows the scene and one sentence, or all panels again. */
  togglePresentation() {
    const state = this.#state;
    if (this.#session)
      this.#changeState(state.view === "presentation" ? withoutPresentation(state) : withPresentation(state));
  }

  /** Makes the state that of what is seen. Resolves to false if that may not be played, which is then said. */
  async settle() {
    await this.#components.panels?.editor.settle();
    return !this.#components.panels?.editor.blocked;
  }

  /** Fires "share" for the open puzzle, once what was last edited is part of it. */
  async share() {
    if (await this.settle()) this.#components.afterSolving.share();
  }

  /** Leads through the open puzzle, step by step. */
  startGuide() {
    this.#components.guide.start();
  }

  /** @param {string} id */
  showDialog(id) {
    showDialog(this.#root, id);
  }

  /** @param {import("../pkg/pathlight.js").Puzzle} puzzle */
  #openPuzzle(puzzle) {
    const session = new Session(puzzle, () => reducedMotion.matches);
    find(this.#root, ".puzzle").setAttribute("aria-label", text.element.puzzle(session.name, session.about.id));
    session.addEventListener("change", () => this.#onSessionChange(session));
    session.addEventListener("attempted", () => this.#onAttempted(session));
    this.#components.open(session);
    return session;
  }

  #closePuzzle() {
    const session = this.#session;
    if (!session) return;
    this.#session = null;
    closeDialogs(this.#root);
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
      this.#startModel();
    }
    this.#applyView();
    this.dispatchEvent(new Event("statechange"));
  }

  /** The panels, which show what comes of the model, have to be there. */
  #startModel() {
    if (this.#components.panels) this.#modelStarter.startFor(this.#state);
  }

  /**
   * Starts the model because it is asked for, whatever is shown; falls back to the first model if the name is unknown.
   */
  #requestModel() {
    if (this.#client.failure?.code === "no_model") this.#changeState({ model: null });
    else this.#client.start(this.#state.model);
  }

  /**
   * Takes the ball into the state.
   * @param {Session} session
   */
  #onSessionChange(session) {
    if (session !== this.#session || sameBall(session.ball, this.#state.ball)) return;
    this.#state.ball = session.ball;
    this.dispatchEvent(new Event("statechange"));
  }

  /** @param {Session} session */
  #onAttempted({ about, shown }) {
    if (!shown) return;
    const { number, ball, ending } = shown;
    /** @type {PlayedAttempt} */
    const attempt = { task: about.id, number, ball, solved: ending.solved };
    this.dispatchEvent(new CustomEvent("attempt", { detail: attempt }));
  }

  /** Passes the visible state to all components. */
  #applyView() {
    const view = viewOf(this.#state, this.#preferences.guess);
    hideParts(this.#root, this.#hrefOf() ? view.hide : [...view.hide, "puzzles"]);
    this.#components.setState(view);
  }

  /** @param {string | null} sentence */
  #showProblem(sentence) {
    const problem = byId(this.#root, "problem");
    problem.hidden = sentence === null;
    this.#root.host.toggleAttribute("data-problem", sentence !== null);
    setText(problem, sentence ?? "");
  }
}
