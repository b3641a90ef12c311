// Keeps the attempts of player and model at each puzzle in the browser, and brings them back when the puzzle is opened
// again: the player's are simulated once more; the model's come with its turn, if it was made by the model that is
// loaded, with the same weights and agents. A turn with a memory is not kept: the next time the model remembers more,
// and plays otherwise.

import { Component } from "../widgets/component.js";
import { turnVersions } from "../model/turn-versions.js";
import { SIMULATOR_VERSION } from "../shell/constants.js";
import { puzzleKey } from "../shell/puzzle-key.js";
import { PLAYER, sameVersions } from "../storage/attempt-lines.js";

/** @typedef {import("./session.js").Session} Session */

export class KeptAttempts extends Component {
  #client;
  #progress;
  #memory;
  /** What the attempts at the open puzzle are kept under. */
  #puzzle = "";
  /**
   * The balls of the attempts, as text, when they were last kept or brought back.
   * @type {Record<import("../pkg/pathlight.js").Author, string[]>}
   */
  #kept = { player: [], model: [] };

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
    client.addEventListener("change", () => this.#bringBackModel());
    memory.addEventListener("switch", () => {
      // With a memory and without it plays like two models.
      this.session?.clearModelAttempts();
      this.#bringBackModel();
    });
    this.byId("clear-attempts").addEventListener("click", () => this.session && progress.forget(this.#puzzle));
  }

  /** @param {Session} session */
  open(session) {
    super.open(session);
    this.#puzzle = puzzleKey(session.puzzle);
    session.attempts.restore(
      this.#progress
        .attemptsAt(this.#puzzle)
        .filter(({ by }) => by === PLAYER)
        .map(({ ball }) => ball),
    );
    // Of a custom scene only the attempts that are kept count.
    const { id } = session.about;
    session.attempts.counted = () => (id === null ? null : this.#progress.player.of(id));
    this.#kept = { player: ballsOf(session.attempts.of("player")), model: [] };
    this.#bringBackModel();
    for (const event of /** @type {const} */ (["attempted", "change"])) this.listen(event, () => this.#keep(session));
  }

  /** A turn that the loaded model has made before. */
  #bringBackModel() {
    const { session } = this;
    const { loaded } = this.#client;
    if (!session || !loaded || this.#memory.on || session.attempts.modelName !== null) return;
    const attempts = this.#progress
      .attemptsAt(this.#puzzle)
      .filter((one) => one.by === loaded.name && sameVersions(one, turnVersions(loaded)));
    session.attempts.restoreModel(attempts, loaded.name);
    this.#kept.model = ballsOf(session.attempts.of("model"));
  }

  /** @param {Session} session */
  #keep(session) {
    // An attempt that runs for the first time is kept when it has ended.
    if (session.hiddenAuthor !== null) return;
    for (const author of /** @type {const} */ (["player", "model"])) {
      const kept = this.#kept[author];
      if (session.attempts.standing(author).used === kept.length) continue;
      const attempts = session.attempts.of(author);
      const balls = (this.#kept[author] = ballsOf(attempts));
      const by = author === "player" ? PLAYER : session.attempts.modelName;
      // The attempts of a model that goes are not deleted.
      if (by === null) continue;
      this.#progress.remove(
        this.#puzzle,
        by,
        kept.filter((ball) => !balls.includes(ball)),
      );
      this.#progress.add(
        this.#puzzle,
        by,
        attempts.filter(({ ball }) => !kept.includes(String(ball))),
        author === "player" ? { simulator: SIMULATOR_VERSION } : turnVersions(this.#client.loaded),
      );
    }
  }
}

/** @param {import("../pkg/pathlight.js").Attempt[]} attempts */
function ballsOf(attempts) {
  return attempts.map(({ ball }) => String(ball));
}
