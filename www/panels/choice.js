// The last steps of the story, for a model that imagines balls: which balls it considers, what it imagines for each of them,
// and which one it tries first. Nothing of it is shown for another model, which does not choose so. Fires "choice" when there is
// something else to lay over the scene.

import { Component } from "../shell/component.js";
import { setText } from "../shell/dom.js";
import { BallImaginer } from "../model/ball-imaginer.js";
import { chanceWords } from "../model/chance-words.js";
import { CHOICE_TEXT } from "../model/stage-text.js";

/** @typedef {import("../shell/url-state.js").ChoiceStep} ChoiceStep */
/** @typedef {import("../model/messages.js").Considered} Considered */

/** The imagined paths of so many of the likeliest balls are hinted at: more would cover each other. */
const HINTS = 40;
/** The opacity of the least of them; the likeliest ball has 1. */
const FAINTEST = 0.25;

export class Choice extends Component {
  #client;
  #imaginer;
  /** @type {ChoiceStep | null} */
  #step = null;
  /**
   * Null until it has come.
   * @type {Considered | null}
   */
  #considered = null;
  /**
   * Runs while the worker is asked.
   * @type {AbortController | null}
   */
  #call = null;
  /** Has the worker answered? Weights that are damaged know no ball. */
  #answered = false;
  /** @type {string | null} */
  #failure = null;

  /**
   * @param {import("../shell/dom.js").Root} root
   * @param {import("../model/shared-client.js").SharedClient} client
   */
  constructor(root, client) {
    super(root);
    this.#client = client;
    this.#imaginer = new BallImaginer(client);
    this.#imaginer.addEventListener("answer", () => this.#update());
    client.addEventListener("change", () => this.#onClientChange());
  }

  close() {
    super.close();
    this.#forget();
  }

  /** Does the loaded model choose its balls so? */
  get able() {
    return this.#imaginer.able;
  }

  /**
   * Shows one step, or none.
   * @param {ChoiceStep | null} step
   */
  show(step) {
    this.#step = step;
    this.byId("choice").hidden = step === null;
    this.#ask();
    this.#update();
  }

  /** The step in words. */
  get words() {
    if (!this.#step) return "";
    const { meaning } = CHOICE_TEXT[this.#step];
    return `${meaning} ${this.#result}`;
  }

  /**
   * What to lay over the scene, or null.
   * @returns {Partial<import("../play/canvas.js").Overlay> | null}
   */
  get overlay() {
    if (!this.#step || !this.#considered) return null;
    const { candidates, chosen } = this.#considered;
    if (this.#step === "candidates") return { marks: candidates.map(({ ball }) => ({ ball, from: null, chosen: false })) };
    if (this.#step === "chosen") return { marks: [{ ball: chosen.ball, from: null, chosen: true }], imagined: this.#imaginer.paths };
    const likeliest = candidates.toSorted((one, other) => other.probability - one.probability).slice(0, HINTS);
    const most = likeliest[0]?.probability;
    return { hints: likeliest.map(({ object, probability }) => ({ object, opacity: FAINTEST + (1 - FAINTEST) * (probability / most) })) };
  }

  #onClientChange() {
    if (this.#client.status !== "ready") this.#forget();
    this.#ask();
  }

  /** Forgets what is another puzzle's or another model's. */
  #forget() {
    this.#call?.abort();
    this.#call = null;
    this.#considered = null;
    this.#answered = false;
    this.#failure = null;
    this.#imaginer.forget();
  }

  async #ask() {
    if (!this.#step || !this.able || this.#call || this.#answered || !this.session) return;
    const call = (this.#call = new AbortController());
    this.#failure = null;
    const task = this.session.about.id;
    try {
      const considered = await this.#client.consider(task, call.signal);
      if (call.signal.aborted) return;
      this.#considered = considered;
      this.#answered = true;
      if (considered) this.#imaginer.imagine(task, considered.chosen.ball);
    } catch (error) {
      if (!call.signal.aborted) this.#failure = /** @type {Error} */ (error).message;
    } finally {
      if (this.#call === call) this.#call = null;
    }
    this.#update();
  }

  #update() {
    if (this.#step) {
      const { name, meaning, how } = CHOICE_TEXT[this.#step];
      setText(this.byId("choice-title"), name);
      setText(this.byId("choice-meaning"), meaning);
      setText(this.byId("choice-result"), this.#result);
      setText(this.byId("choice-how"), how);
    }
    this.dispatchEvent(new Event("choice"));
  }

  /** What it was for the open puzzle. */
  get #result() {
    if (this.#failure) return this.#failure;
    if (!this.#considered) return this.#answered ? "The model finds no ball to try." : "The model is choosing.";
    const { candidates, chosen: { ball: [x, y, r], origin } } = this.#considered;
    if (this.#step === "candidates") return `Here there are ${candidates.length}; a ring stands for the middle of each.`;
    if (this.#step === "imagined") {
      const likely = candidates.filter(({ probability }) => probability > 0.5).length;
      return `Here ${likely} of the ${candidates.length} balls are more likely to solve the puzzle than not. The dotted lines are the ways of the green object with the ${Math.min(HINTS, candidates.length)} likeliest, the likelier the stronger.`;
    }
    const chance = origin.kind === "imagined" ? `: ${chanceWords(origin.probability)}` : "";
    return `Here it is the ball at x ${x}, y ${y} with radius ${r}${chance}.`;
  }
}
