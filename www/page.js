// The page: follows the address and joins the components. Each component knows the session and the wasm; only this file
// knows all of them. shell/component.js describes their lifecycle.

import { palette, templates } from "./pkg/pathlight.js";
import { WorkerClient } from "./model/worker-client.js";
import { Compare } from "./panels/compare.js";
import { Imagine } from "./panels/imagine.js";
import { ImaginedVsReal } from "./panels/imagined-vs-real.js";
import { Overlays } from "./panels/overlays.js";
import { Predict } from "./panels/predict.js";
import { Probe } from "./panels/probe.js";
import { Proposals } from "./panels/proposals.js";
import { ScenePicture } from "./panels/scene-picture.js";
import { Scoreboard } from "./panels/scoreboard.js";
import { SolveMapPanel } from "./panels/solve-map.js";
import { Walkthrough } from "./panels/walkthrough.js";
import { AttemptList } from "./play/attempt-list.js";
import { SceneCanvas } from "./play/canvas.js";
import { Controls } from "./play/controls.js";
import { Session } from "./play/session.js";
import { About } from "./shell/about.js";
import { byId } from "./shell/dom.js";
import { Gallery } from "./shell/gallery.js";
import { HiddenParts } from "./shell/hidden-parts.js";
import { dismissNotice, showNotice } from "./shell/notice.js";
import { ProgressStore } from "./shell/progress-store.js";
import { ProgressView } from "./shell/progress-view.js";
import { listenForShortcuts } from "./shell/shortcuts.js";
import { Tabs } from "./shell/tabs.js";
import { INITIAL_STATE, formatFragment, hrefOf, parseFragment, viewOf, visiblePanels } from "./shell/url-state.js";

/** @typedef {import("./shell/component.js").Component} Component */
/** @typedef {import("./shell/url-state.js").State} State */

/** Browsers refuse to change the address at every step of a drag; it is changed this much later, ms. */
const URL_DELAY = 200;

const darkScheme = matchMedia("(prefers-color-scheme: dark)");
const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");
const taskPicker = byId("task", HTMLSelectElement);

export class Page {
  #templates = templates();
  /** @type {State} */
  #state = { ...INITIAL_STATE };
  /** @type {Session | null} */
  #session = null;
  #client;
  #canvas = new SceneCanvas(byId("scene", HTMLCanvasElement));
  #progress = new ProgressStore();
  /** @type {Component[]} */
  #components;
  /** @type {number | undefined} */
  #urlTimer;

  /** @param {WebAssembly.Module} module */
  constructor(module) {
    this.#client = new WorkerClient(module);
    this.#components = this.#createComponents(this.#client);
    for (const component of this.#components) {
      component.addEventListener("staterequest", (event) => this.#changeState(/** @type {CustomEvent<Partial<State>>} */ (event).detail));
      component.addEventListener("modelrequest", () => this.#retryModel());
    }
    this.#listen();
  }

  /** Shows what the address asks for. */
  start() {
    this.#applyTheme();
    this.#onRoute();
  }

  /**
   * All components, in the order in which they are opened: the maps are asked for first, and what others read comes before
   * them.
   * @param {WorkerClient} client
   * @returns {Component[]}
   */
  #createComponents(client) {
    const gallery = new Gallery(byId("templates"), this.#templates);
    const scenePicture = new ScenePicture();
    const imagine = new Imagine(client, scenePicture);
    const predict = new Predict(imagine, scenePicture);
    const proposals = new Proposals(client, imagine);
    const solveMap = new SolveMapPanel(client, imagine);
    return [
      new HiddenParts(),
      new Tabs(),
      gallery,
      new ProgressView(this.#progress, this.#templates, gallery),
      new About(client),
      scenePicture,
      imagine,
      this.#canvas,
      new Controls(),
      new AttemptList(byId("play-attempts"), byId("play-count"), "player"),
      new AttemptList(byId("player-attempts"), byId("player-count"), "player"),
      new AttemptList(byId("model-attempts"), byId("model-count"), "model"),
      new Walkthrough(imagine),
      new Probe(imagine),
      new ImaginedVsReal(imagine, scenePicture),
      predict,
      new Compare(client),
      proposals,
      solveMap,
      new Scoreboard(client, this.#progress),
      new Overlays(this.#canvas, { imagine, predict, proposals, solveMap }),
    ];
  }

  #listen() {
    addEventListener("popstate", () => this.#onRoute());
    darkScheme.addEventListener("change", () => this.#applyTheme());
    byId("previous").addEventListener("click", () => this.#stepPuzzle(-1));
    byId("next").addEventListener("click", () => this.#stepPuzzle(1));
    byId("random").addEventListener("click", () => this.#openRandomPuzzle());
    taskPicker.addEventListener("change", () => this.#navigate(taskPicker.value));
    byId("skip").addEventListener("click", (event) => {
      // Not the browser's own jump: what follows # is the state.
      event.preventDefault();
      byId("scene").focus();
    });
    byId("copy").addEventListener("click", () => this.#copyLink());
    for (const button of document.querySelectorAll("button[data-opens]")) {
      const id = button.getAttribute("data-opens") ?? "";
      button.addEventListener("click", () => byId(id, HTMLDialogElement).showModal());
    }
    const page = this;
    listenForShortcuts({
      get session() {
        return page.#session;
      },
      scene: this.#canvas,
      stepPuzzle: (offset) => this.#stepPuzzle(offset),
      showPanel: (index) => {
        const panel = visiblePanels(this.#state)[index];
        if (panel) this.#changeState({ panel });
      },
      showKeys: () => byId("keys-dialog", HTMLDialogElement).showModal(),
    });
  }

  /** Applies the colour scheme to the style sheet and to what the wasm paints. */
  #applyTheme() {
    const dark = darkScheme.matches;
    for (const [name, colour] of Object.entries(palette(dark))) document.documentElement.style.setProperty(`--${name}`, colour);
    for (const component of this.#components) component.setTheme(dark);
  }

  /** Shows what the address asks for. */
  #onRoute() {
    dismissNotice();
    const { state, problem } = parseFragment(location.hash);
    const gallery = hrefOf(state, null);
    if (problem) showNotice(problem, gallery ? [["All puzzles", gallery]] : []);
    if (state.task !== null && !this.#templateOf(state.task)?.tasks.includes(state.task)) {
      const template = this.#templateOf(state.task);
      const first = template && hrefOf(state, template.tasks[0]);
      /** @type {[string, string][]} */
      const links = [];
      if (template && first) links.push([`The first puzzle of ${template.name}`, first]);
      if (gallery) links.push(["All puzzles", gallery]);
      showNotice(`This link asks for puzzle ${state.task}, which does not exist.`, links);
      state.task = null;
    } else if (state.task === null && !gallery && !problem) {
      showNotice("This link names no puzzle, and hides the list of them.");
    }
    this.#applyState(state);
  }

  /**
   * Replaces the whole state.
   * @param {State} state
   */
  #applyState(state) {
    const cameFromGallery = byId("gallery").contains(document.activeElement);
    const modelChanged = state.model !== this.#client.requestedName;
    // What is left behind may still change the old state, so it goes first.
    if (state.task !== this.#state.task) this.#closePuzzle();
    else if (modelChanged) this.#session?.clearModelAttempts();
    this.#state = state;
    byId("gallery").hidden = state.task !== null || state.hide.includes("puzzles");
    for (const id of ["puzzle", "title", "copy", "skip"]) byId(id).hidden = state.task === null;
    if (state.task !== null) {
      const session = (this.#session ??= this.#openPuzzle(state.task));
      if (state.ball && String(state.ball) !== String(session.ball)) session.place(state.ball);
      if (modelChanged || this.#client.status === "off") this.#client.start(state.model);
    }
    this.#applyView();
    if (state.task !== null && cameFromGallery) byId("scene").focus({ preventScroll: true });
  }

  /** @param {string} task */
  #openPuzzle(task) {
    const session = new Session(task, () => reducedMotion.matches);
    byId("puzzle-name").textContent = session.about.name;
    document.title = `${session.about.name} ${task} – Pathlight`;
    session.addEventListener("change", () => this.#onSessionChange(session));
    session.addEventListener("attempted", () => session.shown && this.#progress.add(task, session.shown.ending.solved));
    for (const component of this.#components) component.open(session);
    return session;
  }

  #closePuzzle() {
    const session = this.#session;
    if (!session) return;
    this.#session = null;
    // In reverse: what others read goes last.
    for (const component of this.#components.toReversed()) component.close();
    session.close();
    document.title = "Pathlight";
  }

  /** @param {string} task */
  #templateOf(task) {
    return this.#templates.find(({ id }) => task.startsWith(id));
  }

  /**
   * Goes to another puzzle with a new entry in the history. What belongs to the puzzle alone stays behind.
   * @param {string} task
   */
  #navigate(task) {
    const state = { ...this.#state, task, ball: null, proposal: null };
    history.pushState(null, "", `#${formatFragment(state)}`);
    dismissNotice();
    this.#applyState(state);
  }

  /**
   * Changes the state of the same puzzle.
   * @param {Partial<State>} patch
   */
  #changeState(patch) {
    Object.assign(this.#state, patch);
    if (this.#state.model !== this.#client.requestedName) {
      // First, so that what follows from the cleared attempts finds the new model requested and does not start it again.
      this.#client.start(this.#state.model);
      this.#session?.clearModelAttempts();
    }
    this.#applyView();
    this.#syncUrl();
  }

  /** Starts the model once more; falls back to the first model if the name is unknown. */
  #retryModel() {
    if (this.#client.failure?.code === "no_model") this.#changeState({ model: null });
    else this.#client.start(this.#state.model);
  }

  /**
   * Takes the ball into the address.
   * @param {Session} session
   */
  #onSessionChange(session) {
    if (session !== this.#session) return;
    this.#state.ball = session.ball;
    this.#syncUrl();
  }

  /** Writes the state to the address, a little later. */
  #syncUrl() {
    clearTimeout(this.#urlTimer);
    this.#urlTimer = setTimeout(() => {
      if (this.#state.task) history.replaceState(null, "", `#${formatFragment(this.#state)}`);
    }, URL_DELAY);
  }

  /** Passes the visible state to all components. */
  #applyView() {
    const view = viewOf(this.#state);
    for (const component of this.#components) component.setState(view);
  }

  /** @param {number} offset */
  #stepPuzzle(offset) {
    const { task, hide } = this.#state;
    const template = task === null ? undefined : this.#templateOf(task);
    if (task === null || !template || hide.includes("puzzles")) return;
    const { tasks } = template;
    this.#navigate(tasks[(tasks.indexOf(task) + offset + tasks.length) % tasks.length]);
  }

  #openRandomPuzzle() {
    /** @type {<Item>(list: Item[]) => Item} */
    const any = (list) => list[Math.floor(Math.random() * list.length)];
    this.#navigate(any(any(this.#templates).tasks));
  }

  async #copyLink() {
    history.replaceState(null, "", `#${formatFragment(this.#state)}`);
    try {
      await navigator.clipboard.writeText(location.href);
      showNotice("The link to what you see is copied.");
    } catch {
      showNotice(`This browser does not let the page copy. The link is ${location.href}`);
    }
  }
}
