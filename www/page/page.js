// The page: the home page, the header and the progress, round one <pathlight-puzzle>. The state of the page is the
// puzzle's; with no task the home page is shown.

import { DARK_PALETTE, LIGHT_PALETTE } from "../pkg/constants.js";
import { PathlightPuzzle } from "../element/pathlight-puzzle.js";
import { loadWasm } from "../loading/load-wasm.js";
import { byId, find, focusIsLost } from "../widgets/dom.js";
import { hideParts } from "../widgets/hidden-parts.js";
import { dismissNotice, showDone, showNotice } from "../widgets/notice.js";
import { sceneName } from "../puzzles/puzzle-name.js";
import { isChord, leavesPlainKeys, showsDialog } from "../element/shortcuts.js";
import { TASKS, TEMPLATES, templateOf } from "../puzzles/templates.js";
import { hrefOf, pageViewOf, showsPuzzle } from "../state/links.js";
import { INITIAL_STATE, PAGE_VIEWS } from "../state/url-state.js";
import { sharedProgress } from "../storage/progress.js";
import { knownScene, sceneOfText } from "../editor/scene-link.js";
import { text } from "../text/text.js";
import { FIRST_TASK } from "../home/home-tasks.js";
import { Address } from "./address.js";
import { HomePage } from "./home-page.js";
import { LessonDialog } from "./lesson-dialog.js";
import { loadPart } from "./load-part.js";
import { ProgressView } from "./progress-view.js";

/** @typedef {import("../state/url-state.js").State} State */

const darkScheme = matchMedia("(prefers-color-scheme: dark)");
const taskPicker = byId(document, "task", HTMLSelectElement);

export class Page {
  #puzzle = byId(document, "puzzle", PathlightPuzzle);
  #home;
  #progressView;
  /** @type {import("./share-dialog.js").ShareDialog | null} */
  #shareDialog = null;
  #address = new Address((own) => this.#onNavigation(own));
  /** @type {import("./results-view.js").ResultsView | null} */
  #results = null;
  /** @type {import("./learns-view.js").LearnsView | null} */
  #learns = null;
  /** @type {LessonDialog | null} */
  #lessonDialog = null;
  /**
   * The address of a puzzle with the balls of a model.
   * @type {(task: string, model: string | null) => string | null}
   */
  #hrefInCompare = (task, model) => hrefOf({ ...this.#state, model }, task, "compare");

  /** @param {import("../home/hero.js").Hero} hero */
  constructor(hero) {
    const progress = sharedProgress("kept");
    this.#home = new HomePage(hero, progress, (scene) => this.#navigate({ scene }));
    this.#progressView = new ProgressView(progress, TEMPLATES, this.#home.gallery);
    this.#puzzle.hrefOf = (task, panel) => hrefOf(this.#state, task, panel);
    this.#puzzle.addEventListener("statechange", () => this.#onStateChange());
    this.#puzzle.addEventListener("share", (event) => this.#share(/** @type {CustomEvent} */ (event).detail));
    darkScheme.addEventListener("change", () => this.#applyTheme());
    this.#onClick("guide-start", () => this.#startGuide());
    this.#onClick("previous", () => this.#stepPuzzle(-1));
    this.#onClick("next", () => this.#stepPuzzle(1));
    this.#onClick("random", () => this.#openRandomPuzzle());
    this.#onClick("share-button", () => this.#puzzle.share());
    this.#onClick("copy", () => this.#copyLink());
    this.#onClick("presentation-button", () => this.#puzzle.togglePresentation());
    this.#onClick("lesson-button", () => {
      byId(document, "share-dialog", HTMLDialogElement).close();
      (this.#lessonDialog ??= new LessonDialog()).show(this.#state);
    });
    this.#onClick("about-button", () => this.#puzzle.showAbout());
    this.#onClick("keys-button", () => this.#puzzle.showKeys());
    this.#onClick("skip", (event) => {
      // Not the browser's own jump: what follows # is the state.
      event.preventDefault();
      this.#puzzle.focus();
    });
    taskPicker.addEventListener("change", () => this.#navigate({ task: taskPicker.value }));
    document.addEventListener("keydown", (event) => this.#onKeydown(event));
  }

  /** Shows what the address asks for. */
  start() {
    this.#applyTheme();
    this.#onRoute();
  }

  /** @returns {State} */
  get #state() {
    return this.#puzzle.state ?? { ...INITIAL_STATE };
  }

  /**
   * @param {string} id
   * @param {(event: Event) => void} act
   */
  #onClick(id, act) {
    byId(document, id).addEventListener("click", act);
  }

  /** Applies the colour scheme to the style sheet and to what the wasm paints. */
  #applyTheme() {
    const dark = darkScheme.matches;
    for (const [name, colour] of Object.entries(dark ? DARK_PALETTE : LIGHT_PALETTE))
      document.documentElement.style.setProperty(`--${name}`, colour);
    this.#home.setTheme(dark);
  }

  /**
   * Shows what another address asks for.
   * @param {boolean} own is it an entry that the page has written?
   */
  #onNavigation(own) {
    dismissNotice();
    this.#onRoute(own);
  }

  /**
   * Shows what the address asks for. A notice stays: the first time it may say what broke before the page was there.
   * @param {boolean} [own] is it an entry that the page has written?
   */
  #onRoute(own = false) {
    const { state, problem } = this.#address.read();
    // The ball stays where it is, unless a link to the same puzzle places it elsewhere.
    const ballStays =
      (own || state.ball === null) && state.task === this.#state.task && state.scene === this.#state.scene;
    if (ballStays) state.ball = this.#state.ball;
    const gallery = hrefOf(state, null);
    const words = text.page.links;
    if (problem) showNotice(problem, gallery ? [[words.all, gallery]] : []);
    if (state.task !== null && !templateOf(state.task)?.tasks.includes(state.task)) {
      const template = templateOf(state.task);
      const first = template && hrefOf(state, template.tasks[0]);
      /** @type {[string, string][]} */
      const links = [];
      if (template && first) links.push([words.first(template.name), first]);
      if (gallery) links.push([words.all, gallery]);
      showNotice(words.noPuzzle(state.task), links);
      state.task = null;
    } else if (!showsPuzzle(state) && !gallery && !problem) {
      showNotice(words.hidesAll);
    }
    // There is nothing to present, and the way out of it is the puzzle's.
    if (!showsPuzzle(state) && state.view === "presentation") state.view = null;
    this.#applyState(state);
    // A panel may have changed the state meanwhile.
    this.#address.take(this.#state);
    if (ballStays) this.#address.write(this.#state);
  }

  /**
   * Replaces the whole state.
   * @param {State} state
   */
  #applyState(state) {
    const focused = document.activeElement;
    const shown = showsPuzzle(state);
    const view = pageViewOf(state);
    this.#home.show(state);
    for (const name of PAGE_VIEWS) byId(document, name).hidden = name !== view;
    if (view === "results") this.#showResults(state.model);
    if (view === "learns") this.#showLearns();
    else this.#learns?.stop();
    for (const id of ["title", "share-button", "presentation-button", "skip"]) byId(document, id).hidden = !shown;
    // First, so that the worker imagines while the page goes on.
    this.#puzzle.state = state;
    this.#applyTitle(state);
    this.#applyLinks();
    // A view of the page takes the focus itself, once it is loaded.
    if (focused !== document.body && focusIsLost()) (shown ? this.#puzzle : this.#home).focus({ preventScroll: true });
  }

  /**
   * Names the puzzle in the header and in the title of the page.
   * @param {State} state
   */
  #applyTitle(state) {
    const { task, scene } = state;
    // Its name is known once it has been read; the puzzle itself says if it cannot be.
    if (scene !== null && !knownScene(scene))
      sceneOfText(scene).then(
        () => this.#applyTitle(this.#state),
        () => {},
      );
    const name = scene === null ? (task !== null && templateOf(task)?.name) || "" : sceneName(knownScene(scene));
    byId(document, "puzzle-name").textContent = name;
    const view = pageViewOf(state);
    const title = name ? `${name}${task ? ` ${task}` : ""}` : view && text.page.views[view];
    document.title = title ? text.page.title(title) : text.page.name;
    find(document, ".picker").hidden = task === null;
    if (task !== null) this.#progressView.showTask(task);
  }

  /** Takes into the page's own links what the state says of them. */
  #applyLinks() {
    const state = this.#state;
    // Who came by a link for a lesson is not told what it leaves out.
    byId(document, "lesson-button").hidden = state.task === null || state.hide.length > 0;
    this.#home.setState(state);
    const home = byId(document, "home", HTMLAnchorElement);
    const gallery = hrefOf(state, null);
    if (gallery) home.href = gallery;
    else home.removeAttribute("href");
    // Last, because some parts have just been made.
    hideParts(document, state.hide);
  }

  #onStateChange() {
    this.#applyTitle(this.#state);
    this.#applyLinks();
    this.#address.write(this.#state);
  }

  #startGuide() {
    this.#navigate({ task: FIRST_TASK });
    this.#puzzle.startGuide();
  }

  /**
   * Goes to another puzzle with a new entry in the history. What belongs to the puzzle alone stays behind.
   * @param {{ task?: string, scene?: string }} puzzle a task, or a custom scene
   */
  #navigate({ task, scene }) {
    const state = {
      ...this.#state,
      task: task ?? null,
      scene: scene ?? null,
      view: showsPuzzle(this.#state) ? this.#state.view : null,
      ball: null,
      proposal: null,
      challenge: null,
    };
    this.#address.push(state);
    dismissNotice();
    this.#applyState(state);
  }

  /** @param {KeyboardEvent} event */
  #onKeydown(event) {
    // When nothing in a dialog has the focus, keys go to the page behind it.
    if (showsDialog(document) || showsDialog(this.#puzzle.shadowRoot)) return;
    if (!event.composedPath().includes(this.#puzzle)) this.#puzzle.pressKey(event);
    const offset = { "[": -1, "]": 1 }[event.key];
    if (!offset || event.defaultPrevented || isChord(event) || !leavesPlainKeys(event.composedPath()[0])) return;
    event.preventDefault();
    this.#stepPuzzle(offset);
  }

  /** @param {number} offset */
  #stepPuzzle(offset) {
    const { task, hide } = this.#state;
    const template = task === null ? undefined : templateOf(task);
    if (task === null || !template || hide.includes("puzzles")) return;
    const { tasks } = template;
    this.#navigate({ task: tasks[(tasks.indexOf(task) + offset + tasks.length) % tasks.length] });
  }

  #openRandomPuzzle() {
    this.#navigate({ task: TASKS[Math.floor(Math.random() * TASKS.length)] });
  }

  /** @param {string | null} model */
  async #showResults(model) {
    const results = await loadPart(text.page.notLoaded.results, async () => {
      const { ResultsView } = await import("./results-view.js");
      return (this.#results ??= new ResultsView(TEMPLATES, this.#hrefInCompare));
    });
    results?.show(model);
  }

  async #showLearns() {
    const learns = await loadPart(text.page.notLoaded.learns, async () => {
      const { LearnsView } = await import("./learns-view.js");
      return (this.#learns ??= new LearnsView(await loadWasm(), this.#hrefInCompare));
    });
    // The person may have gone on meanwhile.
    if (pageViewOf(this.#state) === "learns") learns?.show();
  }

  /** @param {import("../play/after-solving.js").Result} result */
  async #share(result) {
    const dialog = await loadPart(text.page.notLoaded.share, async () => {
      const { ShareDialog } = await import("./share-dialog.js");
      return (this.#shareDialog ??= new ShareDialog(TEMPLATES));
    });
    // The result can be drawn only while its puzzle is open.
    if (result.isOpen()) dialog?.show(result, this.#state, darkScheme.matches);
  }

  async #copyLink() {
    byId(document, "share-dialog", HTMLDialogElement).close();
    if (!(await this.#puzzle.settle())) return;
    this.#address.write(this.#state);
    this.#address.flush();
    try {
      await navigator.clipboard.writeText(location.href);
      showDone(text.page.links.copied);
    } catch {
      showNotice(text.page.links.notCopied(location.href));
    }
  }
}
