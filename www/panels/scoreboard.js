// Player against model over all the puzzles that both have played: PHYRE's auccess of each, by the same rules. Only
// valid attempts count, up to the limit; a puzzle that one has not solved counts nothing for it. The model's progress
// is kept beside the player's, for each model by its name.

import { Component } from "../shell/component.js";
import { ATTEMPT_LIMIT } from "../shell/constants.js";
import { pathlight } from "../shell/page-api.js";
import { puzzleName } from "../shell/puzzle-name.js";

/** @typedef {import("../shell/progress-store.js").ProgressStore} ProgressStore */

export class Scoreboard extends Component {
  #client;
  #progress;
  #hrefOf;

  /**
   * @param {import("../shell/dom.js").Root} root
   * @param {import("../model/shared-client.js").SharedClient} client
   * @param {import("../shell/progress-store.js").SharedProgress} progress
   * @param {(task: string) => string | null} hrefOf the address of a puzzle, or null if there is no way to it
   */
  constructor(root, client, progress, hrefOf) {
    super(root);
    this.#client = client;
    this.#progress = progress;
    this.#hrefOf = hrefOf;
    client.addEventListener("change", () => client.status !== "loading" && this.#update());
  }

  /** @param {import("../play/session.js").Session} session */
  open(session) {
    super.open(session);
    this.listen("change", () => this.#recordTurn(session));
    this.listenTo(this.#progress, "change", () => this.#update());
  }

  setState() {
    this.#update();
  }

  /**
   * Stores how far the model has come in its turn on this puzzle, under the name of the model that made the attempts.
   * @param {import("../play/session.js").Session} session
   */
  #recordTurn(session) {
    if (session.attempts.modelName === null) return;
    const store = this.#progress.ofModel(session.attempts.modelName);
    const { id } = session.about;
    if (id === null) return;
    const { used, solved_at: solved } = session.attempts.standing("model");
    const stored = store.of(id);
    // The turn is the same each time, so the longer one holds the shorter; but one that has ended may be that of newer
    // agents.
    const over = solved !== null || used === ATTEMPT_LIMIT;
    if (used > stored.attempts || (over && (used !== stored.attempts || solved !== stored.solved)))
      store.set(id, { attempts: used, solved });
  }

  #update() {
    const name = this.#client.loaded?.name;
    const { player } = this.#progress;
    const modelStore = name === undefined ? null : this.#progress.ofModel(name);
    const tasks = modelStore ? player.tasks.filter((task) => modelStore.of(task).attempts > 0) : [];
    this.byId("score-empty").hidden = tasks.length > 0;
    this.byId("score-table").hidden = tasks.length === 0;
    if (!modelStore || tasks.length === 0) return;
    /** @param {ProgressStore} store */
    const score = (store) => pathlight.auccess(tasks.map((task) => store.of(task).solved)).toFixed(1);
    this.byId("score-player").textContent = score(player);
    this.byId("score-model").textContent = score(modelStore);
    this.byId("score-count").textContent = tasks.length === 1 ? "over one puzzle" : `over ${tasks.length} puzzles`;
    this.byId("score-rows").replaceChildren(...tasks.map((task) => this.#row(task, [player, modelStore])));
  }

  /**
   * @param {string} task
   * @param {ProgressStore[]} stores
   */
  #row(task, stores) {
    const head = document.createElement("th");
    head.scope = "row";
    head.title = `Puzzle ${task}`;
    const href = this.#hrefOf(task);
    if (href) {
      const link = document.createElement("a");
      link.href = href;
      link.textContent = puzzleName(task);
      head.append(link);
    } else {
      head.textContent = puzzleName(task);
    }
    const row = document.createElement("tr");
    row.append(head, ...stores.map((store) => resultCell(store.of(task))));
    return row;
  }
}

/** @param {import("../shell/progress-store.js").TaskProgress} progress */
function resultCell({ attempts, solved }) {
  const cell = document.createElement("td");
  cell.textContent =
    solved && solved <= ATTEMPT_LIMIT ? `✓ on attempt ${solved}` : `× in ${Math.min(attempts, ATTEMPT_LIMIT)}`;
  return cell;
}
