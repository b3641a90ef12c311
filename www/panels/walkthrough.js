// The maps explained one after another: a row of steps above them. A step lays its map alone over the scene and
// leaves only its own map in the panel. With a model that imagines balls, the story goes on with how it chooses one,
// and ends with what comes of it. The step it is at is in the address. Fires "step" when the step, or what is said of
// it, has changed.

import { Component } from "../widgets/component.js";
import { MAPS } from "../shell/constants.js";
import { CHOICE_STEPS } from "../state/url-state.js";
import { createButton, setText } from "../widgets/dom.js";
import { CHOICE_TEXT, MAP_TEXT } from "../model/map-text.js";

/** @typedef {import("../pkg/pathlight.js").MapName} MapName */
/** @typedef {MapName | import("../state/url-state.js").ChoiceStep} Step */

/** How long a step stays while the walkthrough plays, ms: time to read a sentence and look. */
const STEP_TIME = 4500;
/** How often it looks whether the ball of a step has come to rest, ms. */
const WAIT = 500;
/** @type {Step[]} */
const ALL_STEPS = [...MAPS, ...CHOICE_STEPS];
const TEXT = { ...MAP_TEXT, ...CHOICE_TEXT };

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
  /** @type {number | undefined} */
  #timer;
  #dots;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("./imagine.js").Imagine} imagine
   * @param {import("./choice.js").Choice} choice
   */
  constructor(root, imagine, choice) {
    super(root);
    this.#imagine = imagine;
    this.#choice = choice;
    this.#dots = ALL_STEPS.map((step, index) => this.#createDot(step, index));
    this.byId("walkthrough-dots").append(...this.#dots);
    this.byId("walkthrough-back").addEventListener("click", () => this.go(-1));
    this.byId("walkthrough-next").addEventListener("click", () => this.go(1));
    this.byId("walkthrough-all").addEventListener("click", () => this.#select(null));
    this.byId("walkthrough-play").addEventListener("click", () => this.toggle());
    choice.addEventListener("choice", () => this.#onChoice());
    // The maps come as soon as it is known what the model can do.
    imagine.addEventListener("maps", () => {
      this.#update();
      this.#announceStep();
    });
  }

  close() {
    super.close();
    this.#pause();
  }

  /** @param {import("../state/view.js").View} view */
  setState({ step, panel }) {
    this.#visible = panel === "imagine";
    this.#requested = step;
    if (!this.#visible) this.#pause();
    this.#update();
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
    const { name, meaning } = TEXT[this.#step];
    return { number: this.#index + 1, count: this.#steps.length, name, meaning, result: this.#result };
  }

  /** What the step shows on this puzzle; empty until it is known. */
  get #result() {
    const mapName = MAPS.find((one) => one === this.#step);
    if (!mapName) return this.#choice.result;
    const words = this.#imagine.words(mapName);
    return words && `It is ${words}.`;
  }

  #onChoice() {
    if (MAPS.some((mapName) => mapName === this.#step)) return;
    this.#announceStep();
    this.dispatchEvent(new Event("step"));
  }

  #update() {
    const steps = this.#steps;
    const step = this.#requested && steps.includes(this.#requested) ? this.#requested : null;
    const changed = step !== this.#step;
    this.#step = step;
    const mapName = MAPS.find((one) => one === step) ?? null;
    const choice = CHOICE_STEPS.find((one) => one === step) ?? null;
    this.#imagine.showOnly(mapName, choice !== null);
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
    setText(this.byId("walkthrough-step"), step ? `Step ${index + 1} of ${steps.length}` : "All together");
    if (changed) this.#announceStep();
    this.dispatchEvent(new Event("step"));
  }

  /** The steps of the loaded model's story. */
  get #steps() {
    return this.#choice.able ? ALL_STEPS : /** @type {Step[]} */ (MAPS);
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
    dot.title = TEXT[step].name;
    dot.setAttribute("aria-label", `Step ${index + 1}: ${TEXT[step].name}`);
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
    const mapName = MAPS.find((one) => one === step);
    this.requestState(step ? { step, layers: mapName ? [mapName] : [] } : { step });
  }

  /** Plays from the first step, or on from the present one. */
  #play() {
    this.#goTo(this.#steps[this.#index + 1] ?? this.#steps[0]);
    this.#timer = setTimeout(() => this.#playOn(), STEP_TIME);
    this.#updatePlayButton();
  }

  /** Goes to the next step once the present one is over. */
  #playOn() {
    const settled = this.#choice.settled;
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
    setText(this.byId("walkthrough-play-label"), this.#timer ? "Pause" : "Play");
    this.byId("walkthrough-play-icon", SVGUseElement).setAttribute("href", this.#timer ? "#icon-pause" : "#icon-run");
    this.dispatchEvent(new Event("step"));
  }

  #announceStep() {
    const { shown } = this;
    if (shown) this.announce(`${shown.name}. ${shown.meaning} ${shown.result}`);
  }
}
