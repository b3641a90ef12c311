// The last steps of the story, for a model that imagines balls: what it imagines for each ball that it considers, and
// what comes of the one that it tries first. Nothing of it is shown for another model, which does not choose so. Fires
// "choice" when there is something else to say.

import { Component } from "../widgets/component.js";
import { setText } from "../widgets/dom.js";
import { BallImaginer } from "../model/ball-imaginer.js";
import { chanceWords, errorWords } from "../model/chance-words.js";
import { sameBall } from "../puzzles/ball.js";
import { sentence } from "../text/sentence.js";
import { text } from "../text/text.js";
import { endingWords } from "../play/ending-words.js";

/** @typedef {import("../state/url-state.js").ChoiceStep} ChoiceStep */
/** @typedef {import("../model/worker.js").Considered} Considered */

/** How many of the likeliest balls show their imagined path: more would cover each other. */
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
   * The chosen ball as the session shows it; null while it does not.
   * @type {import("../play/shown.js").ShownAttempt | null}
   */
  #running = null;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../model/shared-client.js").SharedClient} client
   */
  constructor(root, client) {
    super(root);
    this.#client = client;
    this.#imaginer = new BallImaginer(client);
    this.#imaginer.addEventListener("answer", () => this.#update());
    client.addEventListener("change", () => this.#onClientChange());
  }

  /** @param {import("../play/session.js").Session} session */
  open(session) {
    super.open(session);
    this.listen("change", () => this.#onSessionChange(session));
  }

  close() {
    super.close();
    this.#running = null;
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
    this.#run();
    this.#update();
  }

  /** Has the step come to its end? The chosen ball takes its time. */
  get settled() {
    return this.#running === null || (this.session?.finished ?? true);
  }

  /** @returns {Partial<import("../play/canvas.js").Overlay> | null} */
  get overlay() {
    if (!this.#step || !this.#considered) return null;
    const { candidates } = this.#considered;
    if (this.#step === "run") return { imagined: this.#imaginer.paths };
    const likeliest = candidates.toSorted((one, other) => other.probability - one.probability).slice(0, HINTS);
    const most = likeliest[0]?.probability;
    return {
      hints: likeliest.map(({ object, probability }) => ({
        object,
        opacity: FAINTEST + (1 - FAINTEST) * (probability / most),
      })),
    };
  }

  /** Plays the chosen ball in its step; the other shows nothing that runs. */
  #run() {
    const { session } = this;
    const ball = this.#considered?.chosen.ball;
    const runs = this.#step === "run";
    if (!session || runs === (this.#running !== null)) return;
    // First, because the session tells at once that it shows something else.
    this.#running = null;
    if (!runs) {
      if (session.shown?.preview) session.reset();
    } else if (ball) {
      const tried = session.attempts.of("model").some((attempt) => sameBall(attempt.ball, ball));
      session.preview(1, ball, tried, true);
      this.#running = session.shown;
    }
  }

  /**
   * Something else is shown than the chosen ball: the story is left.
   * @param {import("../play/session.js").Session} session
   */
  #onSessionChange({ shown }) {
    if (!this.#running) return;
    if (shown === this.#running) return this.#update();
    this.#running = null;
    this.requestState({ step: null });
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
    const { puzzle } = this.session;
    try {
      const considered = await this.#client.call("consider", [puzzle], call.signal);
      if (call.signal.aborted) return;
      this.#considered = considered;
      this.#answered = true;
      if (considered) this.#imaginer.imagine(puzzle, considered.chosen.ball);
      this.#run();
    } catch (error) {
      if (!call.signal.aborted) this.#failure = /** @type {Error} */ (error).message;
    } finally {
      if (this.#call === call) this.#call = null;
    }
    this.#update();
  }

  #update() {
    if (this.#step) {
      const { name, meaning, how } = text.model.steps[this.#step];
      setText(this.byId("choice-title"), name);
      setText(this.byId("choice-meaning"), meaning);
      setText(this.byId("choice-result"), this.result);
      setText(this.byId("choice-how"), how);
    }
    this.changeOverlay();
    this.dispatchEvent(new Event("choice"));
  }

  /** What it was for the open puzzle, in a sentence or two. */
  get result() {
    const words = text.panels.choice;
    if (this.#failure) return this.#failure;
    if (!this.#considered) return this.#answered ? words.none : words.choosing;
    if (this.#step === "run") return this.#ending;
    const { candidates } = this.#considered;
    const likely = candidates.filter(({ probability }) => probability > 0.5).length;
    return words.ideas(candidates.length, likely);
  }

  /** What comes of the chosen ball, beside what was imagined. */
  get #ending() {
    const { answer } = this.#imaginer;
    const { session } = this;
    if (!session?.finished || !session.shown) return text.panels.choice.running;
    const ended = text.panels.choice.ended(session.shown.ending.solved, sentence(endingWords(session.shown.ending)));
    const real = session.game.sampledPaths();
    if (!answer || !real) return ended;
    const { imagined } = answer;
    return text.panels.forecast.guessWas(chanceWords(imagined.probability), ended, errorWords(imagined, real));
  }
}
