// The introduction on a first visit, half a minute long: watch without a ball, guess, place, run, and see what the
// model imagined. It follows what the person does on the scene, says the next step, and can be skipped at any time.

import { Component } from "../widgets/component.js";
import { GOAL_SECONDS } from "../shell/constants.js";
import { setText } from "../widgets/dom.js";

/** @typedef {import("./session.js").Session} Session */
/** @typedef {"watch" | "watching" | "guess" | "run" | "running" | "missed" | "solved" | "imagined"} Step */

/**
 * What each step says, and what its button does.
 * @type {Record<Step, { words: string, button: string | null }>}
 */
const STEPS = {
  watch: {
    words: `The green object should come to rest against its hatched goal, for ${GOAL_SECONDS} seconds. First watch what happens without help.`,
    button: "Watch",
  },
  watching: { words: "Nobody helps. Watch the green object.", button: null },
  guess: {
    words:
      "It does not stay there by itself. You may add one red ball, anywhere that is free. Where would it help? Click or tap there.",
    button: null,
  },
  run: { words: "A guess! Drag the ball to move it, or its knob to change its size. Then let it go.", button: "Run" },
  running: { words: "Now nobody touches anything.", button: null },
  missed: {
    words: "Not yet: that is how most attempts end. Move the ball and run again, or see what the model imagines here.",
    button: "What does the model imagine?",
  },
  solved: {
    words: "Solved! Now see what the model imagines, before anything moves.",
    button: "What does the model imagine?",
  },
  imagined: {
    words:
      "The shade is where the model imagines the green object, if the puzzle is solved. It has never seen your ball. In Compare it plays against you.",
    button: "I see",
  },
};
/** The steps that are counted, each with those that belong to it. */
const COUNTED = [["watch", "watching"], ["guess"], ["run", "running"], ["missed", "solved"], ["imagined"]];

export class Guide extends Component {
  /** @type {Step | null} */
  #step = null;
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
    this.#show("watch");
    this.#act.focus({ preventScroll: true });
  }

  #onAct() {
    const { session } = this;
    if (!session) return;
    if (this.#step === "watch") session.watch();
    else if (this.#step === "run") session.run();
    else if (this.#step === "imagined") this.#end();
    else {
      this.requestState({ panel: "imagine", step: "target", layers: ["target"] });
      this.#show("imagined");
    }
  }

  /** @param {Session} session */
  #follow({ phase, finished, ball, invalidReason, shown, placing }) {
    const step = this.#step;
    if (!step || step === "imagined") return;
    if (phase === "watch") this.#show(finished ? "guess" : "watching");
    else if (phase === "attempt" && shown)
      this.#show(!finished ? "running" : shown.ending.solved ? "solved" : "missed");
    else if (placing && ball && !invalidReason) this.#show("run");
    else if (placing && step !== "watch") this.#show("guess");
  }

  #end() {
    this.#show(null);
    this.byId("scene").focus({ preventScroll: true });
  }

  /** @param {Step | null} step */
  #show(step) {
    if (step === this.#step) return;
    this.#step = step;
    this.byId("guide").hidden = step === null;
    if (!step) return;
    const { words, button } = STEPS[step];
    setText(this.byId("guide-words"), words);
    const number = COUNTED.findIndex((steps) => steps.includes(step)) + 1;
    setText(this.byId("guide-count"), `${number} of ${COUNTED.length}`);
    this.#act.hidden = button === null;
    setText(this.#act, button ?? "");
    this.announce(words);
  }
}
