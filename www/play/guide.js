// The introduction on a first visit, half a minute long: watch without a ball, place one, drop it, and race the model.
// It follows what the person does on the scene, says the next step, and can be left at any time.

import { Component } from "../widgets/component.js";
import { GOAL_SECONDS } from "../shell/constants.js";
import { setText } from "../widgets/dom.js";
import { text } from "../text/text.js";
import { invalidWords } from "./invalid-words.js";

/** @typedef {import("./session.js").Session} Session */
/** @typedef {"watch" | "watching" | "guess" | "blocked" | "drop" | "dropped" | "missed" | "solved" | "race"} Step */

/** The steps that are counted, each with those that belong to it. */
const COUNTED = [["watch", "watching"], ["guess", "blocked", "drop"], ["dropped", "missed", "solved"], ["race"]];

export class Guide extends Component {
  /** @type {Step | null} */
  #step = null;
  /** The highest number that was shown: another try is no step back. */
  #number = 0;
  #act = this.byId("guide-act", HTMLButtonElement);

  /** @param {import("../widgets/dom.js").Root} root */
  constructor(root) {
    super(root);
    this.#act.addEventListener("click", () => this.#onAct());
    this.byId("guide-skip").addEventListener("click", () => this.#end());
  }

  /** @param {Session} session */
  open(session) {
    super.open(session);
    this.listen("change", () => this.#follow(session));
  }

  close() {
    super.close();
    this.#show(null);
  }

  /** Begins on the open puzzle. */
  start() {
    this.session?.reset();
    this.#number = 0;
    this.requestState({ forecast: true });
    this.#show("watch");
    this.#act.focus({ preventScroll: true });
  }

  #onAct() {
    const { session } = this;
    if (!session) return;
    if (this.#step === "watch") session.watch();
    else if (this.#step === "drop") session.run();
    else if (this.#step === "race") this.#end();
    else this.#race();
  }

  /** Begins the race, or leaves that to the person while the model is still being loaded. */
  #race() {
    this.#show("race");
    this.requestState({ panel: "play" });
    if (this.session?.attempts.standing("model").used === 0) this.byId("race-it", HTMLButtonElement).click();
  }

  /** @param {Session} session */
  #follow({ phase, finished, ball, invalidReason, shown, placing, about }) {
    const step = this.#step;
    if (!step || step === "race") return;
    if (phase === "watch") this.#show(finished ? "guess" : "watching");
    else if (phase === "compare" || (shown?.author === "model" && !shown.preview)) this.#show("race");
    else if (phase === "attempt" && shown)
      this.#show(!finished ? "dropped" : shown.ending.solved ? "solved" : "missed");
    else if (placing && ball && invalidReason)
      this.#show(
        "blocked",
        `${text.play.status.notHere(invalidWords(invalidReason, about.scene))} ${wordsOf("blocked")}`,
      );
    else if (placing && ball) this.#show("drop");
    else if (placing && step !== "watch") this.#show("guess");
  }

  #end() {
    this.#show(null);
    this.byId("scene").focus({ preventScroll: true });
  }

  /**
   * @param {Step | null} step
   * @param {string} [words] what it says, if that is not always the same
   */
  #show(step, words = step ? wordsOf(step) : "") {
    if (step === this.#step && words === this.byId("guide-words").textContent) return;
    this.#step = step;
    this.byId("guide").hidden = step === null;
    if (!step) return;
    const { button } = text.play.guide[step];
    setText(this.byId("guide-words"), words);
    this.#number = Math.max(this.#number, COUNTED.findIndex((steps) => steps.includes(step)) + 1);
    setText(this.byId("guide-count"), text.play.guideCount(this.#number, COUNTED.length));
    this.setHidden(this.#act, button === null);
    setText(this.#act, button ?? "");
    this.byId("guide-skip").hidden = step === "race";
    this.announce(words);
  }
}

/** @param {Step} step */
function wordsOf(step) {
  return text.play.guide[step].words(GOAL_SECONDS);
}
