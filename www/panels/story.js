// The stages told one after another: a row of steps above the maps. A step lays its map alone over the scene
// and leaves only its own map in the panel. Asks for another stage by "set"; which one is on is in the link.

import { say } from "../shell/announce.js";
import { STAGES } from "../shell/url-state.js";
import { WORDS, summary } from "../model/stages.js";

/** How long a step stands while the story plays, ms: time to read a sentence and look. */
const PAUSE = 4500;

const at = (id) => document.getElementById(id);

export class Story extends EventTarget {
  #imagine;
  /** The stage that is told, or null for all together. */
  #stage = null;
  #timer = null;
  #dots;

  constructor(imagine) {
    super();
    this.#imagine = imagine;
    this.#dots = STAGES.map((stage, index) => {
      const dot = document.createElement("button");
      dot.type = "button";
      dot.textContent = index + 1;
      dot.title = WORDS[stage].name;
      dot.setAttribute("aria-label", `Step ${index + 1}: ${WORDS[stage].name}`);
      dot.addEventListener("click", () => this.#turn(stage));
      return dot;
    });
    at("story-dots").append(...this.#dots);
    at("story-back").addEventListener("click", () => this.#turn(STAGES[STAGES.indexOf(this.#stage) - 1] ?? null));
    at("story-next").addEventListener("click", () => this.#turn(STAGES[STAGES.indexOf(this.#stage) + 1]));
    at("story-all").addEventListener("click", () => this.#turn(null));
    at("story-play").addEventListener("click", () => (this.#timer ? this.#pause() : this.#play()));
    imagine.addEventListener("imagined", () => this.#tell());
  }

  /** Takes what the link says. */
  set({ stage, panel }) {
    if (panel !== "imagine") this.#pause();
    const fresh = stage !== this.#stage;
    this.#stage = stage;
    this.#imagine.alone = stage;
    const index = STAGES.indexOf(stage);
    this.#dots.forEach((dot, place) => {
      if (place === index) dot.setAttribute("aria-current", "step");
      else dot.removeAttribute("aria-current");
    });
    // A button that the focus is on stays able: the focus would be lost.
    at("story-back").setAttribute("aria-disabled", String(index < 0));
    at("story-next").setAttribute("aria-disabled", String(index === STAGES.length - 1));
    at("story-all").setAttribute("aria-pressed", String(stage === null));
    at("story-step").textContent = stage ? `Step ${index + 1} of ${STAGES.length}` : "All together";
    if (fresh) this.#tell();
  }

  #turn(stage) {
    this.#pause();
    this.#go(stage);
  }

  #go(stage) {
    if (stage === undefined || stage === this.#stage) return;
    this.dispatchEvent(new CustomEvent("set", { detail: { stage, ...(stage && { layers: [stage] }) } }));
  }

  /** From the first step, or on from the one that is told. */
  #play() {
    const last = STAGES.at(-1);
    const next = () => STAGES[STAGES.indexOf(this.#stage) + 1];
    this.#go(this.#stage === last ? STAGES[0] : next());
    this.#timer = setInterval(() => {
      this.#go(next());
      if (this.#stage === last) this.#pause();
    }, PAUSE);
    this.#label();
  }

  #pause() {
    clearInterval(this.#timer);
    this.#timer = null;
    this.#label();
  }

  #label() {
    at("story-play-label").textContent = this.#timer ? "Pause" : "Play";
    at("story-play-icon").setAttribute("href", this.#timer ? "#icon-pause" : "#icon-run");
  }

  /** Says the step aloud. */
  #tell() {
    const map = this.#imagine.values?.[this.#stage];
    const words = WORDS[this.#stage];
    if (words) say(`${words.name}. ${words.means} ${map ? `It is ${summary(map)}.` : ""}`);
  }
}
