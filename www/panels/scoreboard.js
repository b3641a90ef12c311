// Player against model over all the puzzles that both have played, in one line below the race: PHYRE's auccess of each,
// by the same rules. Only valid attempts count, up to the limit; a puzzle that one has not solved counts nothing for
// it. The model's progress is kept beside the player's, for each model by its name. While it plays with a memory, which
// is not kept, there is no score.

import { Component } from "../widgets/component.js";
import { text } from "../text/text.js";
import { setText } from "../widgets/dom.js";
import { pathlight } from "../shell/page-api.js";

export class Scoreboard extends Component {
  #client;
  #progress;
  #memory;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../model/shared-client.js").SharedClient} client
   * @param {import("../storage/progress.js").Progress} progress
   * @param {import("../model/model-memory.js").ModelMemory} memory
   */
  constructor(root, client, progress, memory) {
    super(root);
    this.#client = client;
    this.#progress = progress;
    this.#memory = memory;
    memory.addEventListener("switch", () => this.#update());
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
    const model = name === undefined || this.#memory.on ? null : this.#progress.ofModel(name);
    const tasks = model ? player.tasks.filter((task) => model.of(task).attempts > 0) : [];
    this.byId("score").hidden = tasks.length === 0;
    if (!model || tasks.length === 0) return;
    /** @param {import("../storage/author-progress.js").AuthorProgress} author */
    const score = (author) => Math.round(pathlight.auccess(tasks.map((task) => author.of(task).solved)));
    setText(this.byId("score-words"), text.panels.score(tasks.length, score(player), score(model)));
  }
}
