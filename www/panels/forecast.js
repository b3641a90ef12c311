// The model's guess: while a person places the ball, the paths that the model imagines for this very ball lie over the
// scene, and its chance stands below. After a run they stay beside the real paths until the ball changes. The switch is
// by the run button in Play, and is remembered.

import { Component } from "../widgets/component.js";
import { sameBall } from "../puzzles/ball.js";
import { text } from "../text/text.js";
import { setText } from "../widgets/dom.js";
import { BallImaginer } from "../model/ball-imaginer.js";
import { chanceWords, errorWords } from "../model/chance-words.js";

/** @typedef {import("../play/session.js").Session} Session */

/** Time without a move after which a ball is at rest, and its chance is announced, ms. */
const REST = 700;

export class Forecast extends Component {
  #client;
  #imaginer;
  #box = this.byId("forecast-on", HTMLInputElement);
  /** Is it switched on, and may it be seen in this panel? */
  #on = false;
  /** Is the switch in sight? */
  #offered = false;
  /** @type {number | undefined} */
  #timer;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../model/shared-client.js").SharedClient} client
   * @param {import("../storage/preferences.js").Preferences} preferences
   */
  constructor(root, client, preferences) {
    super(root);
    this.#client = client;
    this.#imaginer = new BallImaginer(client);
    this.#box.addEventListener("change", () => {
      preferences.guess = this.#box.checked;
      this.requestState({ forecast: this.#box.checked });
    });
    this.#imaginer.addEventListener("answer", () => this.#update());
    client.addEventListener("change", () => this.#follow());
  }

  /** @param {Session} session */
  open(session) {
    super.open(session);
    this.listen("change", () => this.#follow());
    this.#follow();
  }

  close() {
    super.close();
    this.#imaginer.forget();
    clearTimeout(this.#timer);
  }

  /** @param {import("../state/view.js").View} view */
  setState({ forecast, tab, view }) {
    this.#on = this.#box.checked = forecast;
    this.#offered = tab === "play" && view === null;
    this.#follow();
  }

  get overlay() {
    const imagined = this.#paths;
    return imagined && { imagined };
  }

  /** While the ball is dragged they may be those of a moment ago. */
  get #paths() {
    return this.#ball && this.#imaginer.paths;
  }

  /**
   * The ball to imagine: the one that is being placed, or the player's whose attempt is shown; null if there is none.
   */
  get #ball() {
    if (!this.session || !this.#on) return null;
    const { ball, placing, invalidReason, shown } = this.session;
    const isRun = shown?.author === "player" && sameBall(shown.ball, ball);
    return (placing && invalidReason === null) || isRun ? ball : null;
  }

  #follow() {
    if (this.session && this.#ball) this.#imaginer.imagine(this.session.puzzle, this.#ball);
    this.#update();
  }

  #update() {
    const { status, loaded } = this.#client;
    const unable = status === "failed" || (loaded !== null && !this.#imaginer.able);
    this.byId("forecast").hidden = unable || !this.#offered;
    const line = this.byId("forecast-words");
    const words = this.#on && !unable ? this.#words() : "";
    line.hidden = words === "";
    this.byId("forecast-how").hidden = !this.#paths;
    if (line.textContent !== words) {
      setText(line, words);
      clearTimeout(this.#timer);
      if (this.#paths) this.#timer = setTimeout(() => this.announce(words), REST);
    }
    this.changeOverlay();
  }

  #words() {
    const { able, answer, failure } = this.#imaginer;
    const { session } = this;
    const words = text.panels.forecast;
    if (failure) return failure;
    if (!session || !this.#ball) return "";
    if (!able) return words.loading;
    if (!answer) return words.guessing;
    const chance = chanceWords(answer.imagined.probability);
    const ended = session.finished && sameBall(answer.of, session.shown?.ball);
    const real = ended ? session.game.sampledPaths() : undefined;
    return real ? words.guessWas(chance, errorWords(answer.imagined, real)) : words.guess(chance);
  }
}
