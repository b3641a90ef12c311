// Player against model over all the puzzles that both have played: PHYRE's auccess of each, by the same rules. Only valid
// attempts count, up to the limit; a puzzle that one has not solved counts nothing for it. The model's progress is kept
// beside the player's, for each model by its name.

import { auccess } from "../pkg/pathlight.js";
import { Component } from "../shell/component.js";
import { ATTEMPT_LIMIT } from "../shell/constants.js";
import { byId } from "../shell/dom.js";
import { ProgressStore } from "../shell/progress-store.js";
import { hrefOf } from "../shell/url-state.js";

/** @typedef {import("../shell/url-state.js").View} View */

export class Scoreboard extends Component {
  #client;
  #playerStore;
  /**
   * The stores of the models that were loaded on this page, by name.
   * @type {Map<string, ProgressStore>}
   */
  #modelStores = new Map();
  /** @type {View | null} */
  #view = null;

  /**
   * @param {import("../model/worker-client.js").WorkerClient} client
   * @param {ProgressStore} playerStore
   */
  constructor(client, playerStore) {
    super();
    this.#client = client;
    this.#playerStore = playerStore;
    playerStore.addEventListener("change", () => this.#update());
    client.addEventListener("change", () => client.status !== "loading" && this.#update());
    this.#update();
  }

  /** @param {import("../play/session.js").Session} session */
  open(session) {
    super.open(session);
    this.listen("change", () => this.#recordTurn(session));
  }

  /** @param {View} view */
  setState(view) {
    this.#view = view;
    this.#update();
  }

  /** @param {string} name */
  #storeOf(name) {
    let store = this.#modelStores.get(name);
    if (!store) {
      store = ProgressStore.ofModel(name);
      store.addEventListener("change", () => this.#update());
      this.#modelStores.set(name, store);
    }
    return store;
  }

  /**
   * Stores how far the model has come in its turn on this puzzle, under the name of the model that made the attempts.
   * @param {import("../play/session.js").Session} session
   */
  #recordTurn(session) {
    if (session.modelName === null) return;
    const store = this.#storeOf(session.modelName);
    const { id } = session.about;
    const { used, solved_at: solved } = session.standing("model");
    const stored = store.of(id);
    // The turn is the same each time, so the longer one holds the shorter.
    if (used > stored.attempts) store.set(id, { attempts: used, solved });
  }

  #update() {
    const name = this.#client.loaded?.name;
    const modelStore = name === undefined ? null : this.#storeOf(name);
    const tasks = modelStore ? this.#playerStore.tasks.filter((task) => modelStore.of(task).attempts > 0) : [];
    byId("score-empty").hidden = tasks.length > 0;
    byId("score-table").hidden = tasks.length === 0;
    if (!modelStore || tasks.length === 0) return;
    /** @param {ProgressStore} store */
    const score = (store) => auccess(tasks.map((task) => store.of(task).solved)).toFixed(1);
    byId("score-player").textContent = score(this.#playerStore);
    byId("score-model").textContent = score(modelStore);
    byId("score-count").textContent = tasks.length === 1 ? "over one puzzle" : `over ${tasks.length} puzzles`;
    byId("score-rows").replaceChildren(...tasks.map((task) => this.#row(task, [this.#playerStore, modelStore])));
  }

  /**
   * @param {string} task
   * @param {ProgressStore[]} stores
   */
  #row(task, stores) {
    const head = document.createElement("th");
    head.scope = "row";
    const href = this.#view && hrefOf(this.#view, task, "compare");
    if (href) {
      const link = document.createElement("a");
      link.href = href;
      link.textContent = task;
      head.append(link);
    } else {
      head.textContent = task;
    }
    const row = document.createElement("tr");
    row.append(head, ...stores.map((store) => resultCell(store.of(task))));
    return row;
  }
}

/** @param {import("../shell/progress-store.js").TaskProgress} progress */
function resultCell({ attempts, solved }) {
  const cell = document.createElement("td");
  cell.textContent = solved && solved <= ATTEMPT_LIMIT ? `✓ on attempt ${solved}` : `× in ${Math.min(attempts, ATTEMPT_LIMIT)}`;
  return cell;
}
