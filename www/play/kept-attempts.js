// Keeps the attempts of player and model at each puzzle in the browser, and brings them back when the puzzle is opened again: the
// player's are simulated once more; the model's come with its turn, if it was made by the model that is loaded.

import { Component } from "../shell/component.js";
import { SIMULATOR_VERSION } from "../shell/constants.js";

/** @typedef {import("./session.js").Session} Session */

export class KeptAttempts extends Component {
  #client;
  #store;
  /** How many attempts there were when they were last kept or brought back. */
  #kept = { player: 0, model: 0 };

  /**
   * @param {import("../shell/dom.js").Root} root
   * @param {import("../model/shared-client.js").SharedClient} client
   * @param {import("../shell/attempt-store.js").AttemptStore} store
   */
  constructor(root, client, store) {
    super(root);
    this.#client = client;
    this.#store = store;
    client.addEventListener("change", () => this.session && this.#bringBackModel(this.session));
    this.byId("clear-attempts").addEventListener("click", () => this.session?.about.id && store.forget(this.session.about.id));
  }

  /** @param {Session} session */
  open(session) {
    super.open(session);
    const { id } = session.about;
    // An own scene has no id to keep them by.
    if (id === null) return;
    session.restore(this.#store.of(id).filter(({ by }) => by === "player").map(({ ball }) => ball));
    this.#kept = { player: session.standing("player").used, model: 0 };
    this.#bringBackModel(session);
    this.listen("change", () => this.#keep(session));
  }

  /**
   * A turn that the loaded model has made before.
   * @param {Session} session
   */
  #bringBackModel(session) {
    const name = this.#client.loaded?.name;
    const { id } = session.about;
    if (name === undefined || session.modelName !== null || id === null) return;
    const attempts = this.#store.of(id).filter(({ by, simulator }) => by === name && simulator === SIMULATOR_VERSION);
    for (const attempt of attempts) session.recordModelAttempt(attempt, name);
    this.#kept.model = session.standing("model").used;
  }

  /** @param {Session} session */
  #keep(session) {
    // An attempt that runs for the first time is kept when it has ended.
    const { id } = session.about;
    if (session.resultHidden || id === null) return;
    for (const contender of /** @type {const} */ (["player", "model"])) {
      const { used } = session.standing(contender);
      const by = contender === "player" ? contender : session.modelName;
      if (used === this.#kept[contender]) continue;
      this.#kept[contender] = used;
      // The attempts of a model that goes are not deleted.
      if (by !== null) this.#store.set(id, by, session.attempts(contender), SIMULATOR_VERSION);
    }
  }
}
