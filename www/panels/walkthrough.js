// What the model imagines, told as a story of six steps. A step lays its maps over the scene and leaves only them in
// the panel; with a model that imagines balls, the last two show what each ball would do, and the likeliest one run.
// The step it is at is in the address. It plays by itself when a person opens the panel for the first time. Fires
// "step" when the step, or what is said of it, has changed.

import { Component } from "../widgets/component.js";
import { CHOICE_STEPS, MAP_STEPS } from "../state/url-state.js";
import { STEP_LAYERS } from "../state/view.js";
import { createButton, setText } from "../widgets/dom.js";
import { text } from "../text/text.js";

/** @typedef {import("../state/url-state.js").Step} Step */

/** How long a step stays while the walkthrough plays, ms: time to read a sentence and look. */
const STEP_TIME = 4500;
/** How often it looks whether the ball of a step has come to rest, ms. */
const WAIT = 500;
/** @type {Step[]} */
const ALL_STEPS = [...MAP_STEPS, ...CHOICE_STEPS];

export class Walkthrough extends Component {
  #imagine;
  #choice;
  /**
   * The step that is explained, or null for all together.
   * @type {Step | null}
   */
  #step = null;
  /**
   * The step that the address asks for.
   * @type {Step | null}
   */
  #requested = null;
  #visible = false;
  /**
   * The session whose panel has been in or out of sight; null before.
   * @type {import("../play/session.js").Session | null}
   */
  #known = null;
  #preferences;
  /** @type {number | undefined} */
  #timer;
  #dots;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("./imagine.js").Imagine} imagine
   * @param {import("./choice.js").Choice} choice
   * @param {import("../storage/preferences.js").Preferences} preferences
   */
  constructor(root, imagine, choice, preferences) {
    super(root);
    this.#imagine = imagine;
    this.#choice = choice;
    this.#preferences = preferences;
    this.#dots = ALL_STEPS.map((step, index) => this.#createDot(step, index));
    this.byId("walkthrough-dots").append(...this.#dots);
    this.byId("walkthrough-back").addEventListener("click", () => this.go(-1));
    this.byId("walkthrough-next").addEventListener("click", () => this.go(1));
    this.byId("walkthrough-all").addEventListener("click", () => this.#select(null));
    this.byId("walkthrough-play").addEventListener("click", () => this.toggle());
    choice.addEventListener("choice", () => this.#onChoice());
    imagine.addEventListener("switch", () => this.#pause());
    // The maps come as soon as it is known what the model can do.
    imagine.addEventListener("maps", () => {
      this.#update();
      this.#announceStep();
    });
  }

  /** @param {import("../play/session.js").Session} session */
  open(session) {
    super.open(session);
    this.listenTo(session.placement, "change", () => this.#pause());
  }

  close() {
    super.close();
    this.#known = null;
    this.#pause();
  }

  /** @param {import("../state/view.js").View} view */
  setState({ step, panel, view, hide }) {
    const opened = panel === "imagine" && !this.#visible && this.session !== null && this.session === this.#known;
    this.#visible = panel === "imagine";
    this.#known = this.session;
    this.#requested = step;
    if (!this.#visible) this.#pause();
    this.#update();
    // A link shows what it says, and a lesson goes at the teacher's pace.
    const quiet = step !== null || view !== null || hide.length > 0 || (this.session?.reducedMotion ?? true);
    if (opened && !quiet && this.#preferences.takeStory()) this.#wait();
  }

  /**
   * The person goes to the next step, or back to the one before; before the first are all together.
   * @param {1 | -1} by
   */
  go(by) {
    this.#select(this.#steps[this.#index + by] ?? (by < 0 ? null : undefined));
  }

  /** Plays the story, or pauses it. */
  toggle() {
    if (this.#timer) this.#pause();
    else this.#play();
  }

  /** Does the story go on by itself? */
  get playing() {
    return this.#timer !== undefined;
  }

  /** The step that is shown: its place from 1, in how many, and in words; null for all together. */
  get shown() {
    if (!this.#step || !this.#visible) return null;
    const { name, meaning } = text.model.steps[this.#step];
    return { number: this.#index + 1, count: this.#steps.length, name, meaning, result: this.#result };
  }

  /** What the step shows on this puzzle; empty until it is known. */
  get #result() {
    const mapName = MAP_STEPS.find((one) => one === this.#step);
    if (!mapName) return this.#choice.result;
    const words = this.#imagine.words(mapName);
    return words && text.panels.walkthrough.here(words);
  }

  #onChoice() {
    if (MAP_STEPS.some((mapName) => mapName === this.#step)) return;
    this.#announceStep();
    this.dispatchEvent(new Event("step"));
  }

  #update() {
    const steps = this.#steps;
    const step = this.#requested && steps.includes(this.#requested) ? this.#requested : null;
    const changed = step !== this.#step;
    this.#step = step;
    const choice = CHOICE_STEPS.find((one) => one === step) ?? null;
    this.#imagine.showOnly(step && STEP_LAYERS[step]);
    this.#choice.show(this.#visible ? choice : null);
    const index = this.#index;
    this.#dots.forEach((dot, place) => {
      dot.hidden = place >= steps.length;
      if (place === index) dot.setAttribute("aria-current", "step");
      else dot.removeAttribute("aria-current");
    });
    // A button with the focus stays enabled: otherwise the focus would be lost.
    this.byId("walkthrough-back").setAttribute("aria-disabled", String(index < 0));
    this.byId("walkthrough-next").setAttribute("aria-disabled", String(index === steps.length - 1));
    this.byId("walkthrough-all").setAttribute("aria-pressed", String(step === null));
    const words = text.panels.walkthrough;
    setText(this.byId("walkthrough-step"), step ? words.step(index + 1, steps.length) : words.all);
    if (changed) this.#announceStep();
    this.dispatchEvent(new Event("step"));
  }

  /** The steps of the loaded model's story. */
  get #steps() {
    return this.#choice.able ? ALL_STEPS : ALL_STEPS.slice(0, MAP_STEPS.length);
  }

  /** The index of the step; -1 for all together. */
  get #index() {
    return this.#step ? this.#steps.indexOf(this.#step) : -1;
  }

  /**
   * @param {Step} step
   * @param {number} index
   */
  #createDot(step, index) {
    const dot = createButton(String(index + 1), () => this.#select(step));
    dot.title = text.model.steps[step].name;
    dot.setAttribute("aria-label", text.panels.walkthrough.dot(index + 1, dot.title));
    return dot;
  }

  /**
   * The person chooses a step; undefined is past the last.
   * @param {Step | null | undefined} step
   */
  #select(step) {
    this.#pause();
    this.#goTo(step);
  }

  /** @param {Step | null | undefined} step */
  #goTo(step) {
    if (step === undefined || step === this.#step) return;
    this.requestState({ step, layers: null });
  }

  /** Plays from the first step, or on from the present one. */
  #play() {
    this.#goTo(this.#steps[this.#index + 1] ?? this.#steps[0]);
    this.#wait();
  }

  /** Plays on when the present step, or the first look at all together, is over. */
  #wait() {
    this.#timer = setTimeout(() => this.#playOn(), STEP_TIME);
    this.#updatePlayButton();
  }

  /** Goes to the next step once the present one is over. */
  #playOn() {
    const settled = this.#imagine.maps !== null && this.#choice.settled;
    if (settled) this.#goTo(this.#steps[this.#index + 1]);
    if (this.#index === this.#steps.length - 1) this.#pause();
    else this.#timer = setTimeout(() => this.#playOn(), settled ? STEP_TIME : WAIT);
  }

  #pause() {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    this.#updatePlayButton();
  }

  #updatePlayButton() {
    setText(this.byId("walkthrough-play-label"), this.#timer ? text.panels.imagine.pause : text.panels.imagine.play);
    this.byId("walkthrough-play-icon", SVGUseElement).setAttribute("href", this.#timer ? "#icon-pause" : "#icon-run");
    this.dispatchEvent(new Event("step"));
  }

  #announceStep() {
    const { shown } = this;
    if (shown) this.announce(`${shown.name}. ${shown.meaning} ${shown.result}`);
  }
}
