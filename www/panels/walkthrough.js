// The stages explained one after another: a row of steps above the maps. A step lays its map alone over the scene and
// leaves only its own map in the panel. The stage it is at is in the address.

import { Component } from "../shell/component.js";
import { STAGES } from "../shell/constants.js";
import { createButton, setText } from "../shell/dom.js";
import { summary } from "../model/map-summary.js";
import { STAGE_TEXT } from "../model/stage-text.js";

/** @typedef {import("../pkg/pathlight.js").Stage} Stage */

/** How long a step stays while the walkthrough plays, ms: time to read a sentence and look. */
const STEP_TIME = 4500;
const LAST = STAGES[STAGES.length - 1];

export class Walkthrough extends Component {
  #imagine;
  /**
   * The stage that is explained, or null for all together.
   * @type {Stage | null}
   */
  #stage = null;
  /** @type {number | undefined} */
  #timer;
  #dots;

  /**
   * @param {import("../shell/dom.js").Root} root
   * @param {import("./imagine.js").Imagine} imagine
   */
  constructor(root, imagine) {
    super(root);
    this.#imagine = imagine;
    this.#dots = STAGES.map((stage, index) => this.#createDot(stage, index));
    this.byId("walkthrough-dots").append(...this.#dots);
    this.byId("walkthrough-back").addEventListener("click", () => this.#select(STAGES[this.#index - 1] ?? null));
    this.byId("walkthrough-next").addEventListener("click", () => this.#select(STAGES[this.#index + 1]));
    this.byId("walkthrough-all").addEventListener("click", () => this.#select(null));
    this.byId("walkthrough-play").addEventListener("click", () => (this.#timer ? this.#pause() : this.#play()));
    imagine.addEventListener("maps", () => this.#announceStage());
  }

  close() {
    super.close();
    this.#pause();
  }

  /** @param {import("../shell/url-state.js").View} view */
  setState({ stage, panel }) {
    if (panel !== "imagine") this.#pause();
    const changed = stage !== this.#stage;
    this.#stage = stage;
    this.#imagine.showOnly(stage);
    const index = this.#index;
    this.#dots.forEach((dot, place) => {
      if (place === index) dot.setAttribute("aria-current", "step");
      else dot.removeAttribute("aria-current");
    });
    // A button with the focus stays enabled: otherwise the focus would be lost.
    this.byId("walkthrough-back").setAttribute("aria-disabled", String(index < 0));
    this.byId("walkthrough-next").setAttribute("aria-disabled", String(index === STAGES.length - 1));
    this.byId("walkthrough-all").setAttribute("aria-pressed", String(stage === null));
    setText(this.byId("walkthrough-step"), stage ? `Step ${index + 1} of ${STAGES.length}` : "All together");
    if (changed) this.#announceStage();
  }

  /** The index of the stage; -1 for all together. */
  get #index() {
    return this.#stage ? STAGES.indexOf(this.#stage) : -1;
  }

  /**
   * @param {Stage} stage
   * @param {number} index
   */
  #createDot(stage, index) {
    const dot = createButton(String(index + 1), () => this.#select(stage));
    dot.title = STAGE_TEXT[stage].name;
    dot.setAttribute("aria-label", `Step ${index + 1}: ${STAGE_TEXT[stage].name}`);
    return dot;
  }

  /**
   * The person chooses a stage; undefined is past the last.
   * @param {Stage | null | undefined} stage
   */
  #select(stage) {
    this.#pause();
    this.#goTo(stage);
  }

  /** @param {Stage | null | undefined} stage */
  #goTo(stage) {
    if (stage === undefined || stage === this.#stage) return;
    this.requestState(stage ? { stage, layers: [stage] } : { stage });
  }

  /** Plays from the first step, or on from the present one. */
  #play() {
    this.#goTo(this.#stage === LAST ? STAGES[0] : STAGES[this.#index + 1]);
    this.#timer = setInterval(() => {
      this.#goTo(STAGES[this.#index + 1]);
      if (this.#stage === LAST) this.#pause();
    }, STEP_TIME);
    this.#updatePlayButton();
  }

  #pause() {
    clearInterval(this.#timer);
    this.#timer = undefined;
    this.#updatePlayButton();
  }

  #updatePlayButton() {
    setText(this.byId("walkthrough-play-label"), this.#timer ? "Pause" : "Play");
    this.byId("walkthrough-play-icon", SVGUseElement).setAttribute("href", this.#timer ? "#icon-pause" : "#icon-run");
  }

  #announceStage() {
    if (!this.#stage) return;
    const map = this.#imagine.maps?.[this.#stage];
    const { name, meaning } = STAGE_TEXT[this.#stage];
    this.announce(`${name}. ${meaning} ${map ? `It is ${summary(map)}.` : ""}`);
  }
}
