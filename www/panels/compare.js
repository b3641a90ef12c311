// The Compare panel: the model's turn, and the attempts of player and model side by side.

const at = (id) => document.getElementById(id);

export class Compare extends EventTarget {
  #model;
  #session = null;
  /** The session whose turn the model is playing, or null. */
  #turning = null;

  /** Fires "again" when the person wants a model that failed to be started once more. */
  constructor(model) {
    super();
    this.#model = model;
    at("turn").addEventListener("click", () => (this.#turning ? this.#stop() : this.#turn()));
    at("both").addEventListener("click", () => this.#session.compare(true));
    at("clear").addEventListener("click", () => {
      this.#stop();
      this.#session.clear();
    });
    at("compare-trouble").querySelector("button").addEventListener("click", () => this.dispatchEvent(new Event("again")));
    model.addEventListener("change", () => this.#update());
  }

  show(session) {
    this.#session = session;
    session.addEventListener("change", () => this.#update());
    this.#update();
  }

  /** The puzzle is being left: its turn ends, and nothing is shown until the next. */
  leave() {
    this.#stop();
    this.#session = null;
  }

  /** The panel has come into sight: shows both paths over each other if there is something to show. */
  open() {
    const { placing, playback } = this.#session;
    if (placing || !playback.playing) this.#session.compare(false);
  }

  async #turn() {
    const session = this.#session;
    this.#turning = session;
    this.#update();
    try {
      await this.#model.turn(session.about.id, (attempt) => {
        if (session === this.#turning) session.record(attempt);
      });
      // Who is watching something else meanwhile goes on watching it.
      const busy = session.playback.playing || session.shown?.rehearsed;
      if (session === this.#turning && !busy) session.compare(true);
    } catch {
      // The model tells its own trouble; `#update` shows it.
    } finally {
      if (session === this.#turning) this.#turning = null;
      this.#update();
    }
  }

  #stop() {
    if (!this.#turning) return;
    this.#turning = null;
    this.#model.stop("turn");
  }

  #update() {
    const { status, trouble } = this.#model;
    at("compare-trouble").hidden = status !== "failed";
    at("compare-trouble").querySelector("p").textContent = trouble ?? "";
    at("compare-trouble").querySelector("button").textContent = this.#model.code === "no_model" ? "Use the model that is here" : "Try again";
    if (!this.#session) return;
    const { puzzle } = this.#session;
    const [player, model] = ["player", "model"].map((agent) => puzzle.score(agent));
    const over = model.solved_at !== null || model.used === 100;
    const turn = at("turn");
    turn.disabled = status !== "ready" || over;
    turn.textContent = this.#turning ? "Stop the model" : over ? "The model has played" : "Let the model play";
    at("both").disabled = player.used + model.used === 0;
    at("clear").disabled = player.used + model.used === 0;
    const verdict = this.#session.unseen ? "Your attempt is running." : puzzle.verdict();
    if (at("verdict").textContent !== verdict) at("verdict").textContent = verdict;
  }
}
