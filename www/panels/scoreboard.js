// Player against model over all the puzzles that both have played: PHYRE's auccess of each, by the same rules. Only
// valid attempts count, up to the limit; a puzzle that one has not solved counts nothing for it. The model's progress
// is kept beside the player's, for each model by its name.

import { Component } from "../widgets/component.js";
import { ATTEMPT_LIMIT } from "../shell/constants.js";
import { pathlight } from "../shell/page-api.js";
import { puzzleName } from "../puzzles/puzzle-name.js";

/** @typedef {import("../storage/author.js").Author} Author */

export class Scoreboard extends Component {
  #client;
  #progress;
  #hrefOf;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../model/shared-client.js").SharedClient} client
   * @param {import("../storage/progress.js").Progress} progress
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
    this.listenTo(this.#progress, "change", () => this.#update());
  }

  setState() {
    this.#update();
  }

  #update() {
    const name = this.#client.loaded?.name;
    const { player } = this.#progress;
    const model = name === undefined ? null : this.#progress.ofModel(name);
    const tasks = model ? player.tasks.filter((task) => model.of(task).attempts > 0) : [];
    this.byId("score-empty").hidden = tasks.length > 0;
    this.byId("score-table").hidden = tasks.length === 0;
    if (!model || tasks.length === 0) return;
    /** @param {Author} author */
    const score = (author) => pathlight.auccess(tasks.map((task) => author.of(task).solved)).toFixed(1);
    this.byId("score-player").textContent = score(player);
    this.byId("score-model").textContent = score(model);
    this.byId("score-count").textContent = tasks.length === 1 ? "over one puzzle" : `over ${tasks.length} puzzles`;
    this.byId("score-rows").replaceChildren(...tasks.map((task) => this.#row(task, [player, model])));
  }

  /**
   * @param {string} task
   * @param {Author[]} authors
   */
  #row(task, authors) {
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
    row.append(head, ...authors.map((author) => resultCell(author.of(task))));
    return row;
  }
}

/** @param {import("../storage/counts.js").TaskProgress} progress */
function resultCell({ attempts, solved }) {
  const cell = document.createElement("td");
  cell.textContent =
    solved && solved <= ATTEMPT_LIMIT ? `✓ on attempt ${solved}` : `× in ${Math.min(attempts, ATTEMPT_LIMIT)}`;
  return cell;
}
