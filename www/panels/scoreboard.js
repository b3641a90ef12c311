// Player against model over all the puzzles that both have played: PHYRE's auccess of each, by the same rules. Only
// attempts that may be placed count, at most a hundred; a puzzle that one has not solved counts nothing for it. The
// player's record is the page's; the model's is kept beside it, for each model by its name.

import { Progress } from "../shell/progress-store.js";

const at = (id) => document.getElementById(id);

export class Scoreboard {
  #wasm;
  #model;
  #progress;
  /** The model's own record, once it is known which model it is. */
  #turns = null;
  #name = null;
  #session = null;

  /** `progress`: the player's. */
  constructor(wasm, model, progress) {
    this.#wasm = wasm;
    this.#model = model;
    this.#progress = progress;
    progress.addEventListener("change", () => this.#update());
    model.addEventListener("change", () => this.#meet());
    this.#update();
  }

  show(session) {
    this.#session = session;
    session.addEventListener("change", () => this.#note());
  }

  /** Takes up the record of the model that is loaded. */
  #meet() {
    const name = this.#model.loaded?.name;
    if (!name || name === this.#name) return;
    this.#name = name;
    this.#turns = new Progress(`pathlight.model.${name}`);
    this.#turns.addEventListener("change", () => this.#update());
    this.#update();
  }

  /** Notes how far the model has come in its turn on this puzzle. */
  #note() {
    const { about, puzzle } = this.#session;
    const { used, solved_at } = puzzle.score("model");
    if (this.#turns && used > this.#turns.of(about.id).attempts) this.#turns.keep(about.id, used, solved_at);
  }

  #update() {
    const both = this.#turns ? this.#progress.tasks.filter((task) => this.#turns.of(task).attempts > 0) : [];
    const score = (record) => this.#wasm.auccess(both.map((task) => record.of(task).solved)).toFixed(1);
    at("score-empty").hidden = both.length > 0;
    at("score-table").hidden = both.length === 0;
    if (both.length === 0) return;
    at("score-you").textContent = score(this.#progress);
    at("score-it").textContent = score(this.#turns);
    at("score-count").textContent = both.length === 1 ? "over one puzzle" : `over ${both.length} puzzles`;
    at("score-rows").replaceChildren(...both.map((task) => {
      const row = document.createElement("tr");
      const head = document.createElement("th");
      head.scope = "row";
      const link = document.createElement("a");
      link.href = `#task=${task}&panel=compare`;
      link.textContent = task;
      head.append(link);
      row.append(head, ...[this.#progress, this.#turns].map((record) => cell(record.of(task))));
      return row;
    }));
  }
}

function cell({ attempts, solved }) {
  const data = document.createElement("td");
  data.textContent = solved && solved <= 100 ? `✓ on attempt ${solved}` : `× in ${Math.min(attempts, 100)}`;
  return data;
}
