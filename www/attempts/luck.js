// "Luck or plan?", for a ball of the player's that solved: how many of the balls within a pixel of it solve too.

import { Component } from "../widgets/component.js";
import { sameBall } from "../puzzles/ball.js";
import { text } from "../text/text.js";
import { setText } from "../widgets/dom.js";

/** At least this share of the balls beside it solves: a plan. At most the other: luck. */
const PLAN = 2 / 3;
const LUCK = 1 / 3;

export class Luck extends Component {
  #client;
  /**
   * Runs while the worker is asked.
   * @type {AbortController | null}
   */
  #call = null;
  /**
   * The ball that the sentence is about, or null.
   * @type {import("../pkg/pathlight.js").Ball | null}
   */
  #asked = null;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../model/shared-client.js").SharedClient} client
   */
  constructor(root, client) {
    super(root);
    this.#client = client;
    this.byId("luck-ask").addEventListener("click", () => this.#ask());
  }

  /** @param {import("../play/session.js").Session} session */
  open(session) {
    super.open(session);
    this.listen("change", () => this.#update());
    this.#update();
  }

  close() {
    super.close();
    this.#call?.abort();
    this.#call = null;
    this.#asked = null;
    setText(this.byId("luck-words"), "");
  }

  /** The ball of the attempt that is shown, if it is the player's and solved. */
  get #ball() {
    const { shown = null, finished = false } = this.session ?? {};
    return finished && shown?.author === "player" && shown.ending.solved ? shown.ball : null;
  }

  async #ask() {
    const { session } = this;
    const ball = this.#ball;
    if (!session || !ball) return;
    if (!this.#client.alive) this.requestModel();
    this.#call?.abort();
    const call = (this.#call = new AbortController());
    this.#asked = ball;
    this.#say(text.attempts.luck.asking);
    try {
      const found = await this.#client.call("luck", [session.puzzle, ball], call.signal);
      if (!call.signal.aborted) this.#say(luckWords(found));
    } catch (error) {
      if (!call.signal.aborted) this.#say(/** @type {Error} */ (error).message);
    }
  }

  /** @param {string} sentence */
  #say(sentence) {
    setText(this.byId("luck-words"), sentence);
    this.announce(sentence);
  }

  #update() {
    const ball = this.#ball;
    this.byId("luck").hidden = ball === null;
    if (ball && !sameBall(ball, this.#asked)) {
      this.#call?.abort();
      this.#asked = null;
      setText(this.byId("luck-words"), "");
    }
  }
}

/** @param {import("../pkg/pathlight.js").Luck} found */
function luckWords({ valid, solved }) {
  const share = solved / valid;
  const words = text.attempts.luck;
  const verdict = share >= PLAN ? "plan" : share <= LUCK ? "luck" : "both";
  return words.found(words.verdict[verdict], valid, solved);
}
