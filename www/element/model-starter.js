// Starts the model of a puzzle when something that is shown needs it. Fires "change" when another model is loaded or
// its status changes.

import { visiblePanels } from "../state/view.js";

/** @typedef {import("../state/url-state.js").State} State */

export class ModelStarter extends EventTarget {
  #client;
  #last;

  /** @param {import("../model/shared-client.js").SharedClient} client */
  constructor(client) {
    super();
    this.#client = client;
    this.#last = this.model;
    client.addEventListener("change", () => this.#onChange());
  }

  /** The name of the model that is loaded, or null, and its status. */
  get model() {
    const { status, loaded } = this.#client;
    return { name: loaded?.name ?? null, status };
  }

  /**
   * Starts the model, unless no panel that needs it is shown; Play and Bend ask for it where they need it.
   * @param {State} state
   */
  startFor(state) {
    if (visiblePanels(state).some((panel) => panel !== "play" && panel !== "bend")) this.#client.start(state.model);
  }

  #onChange() {
    const { name, status } = this.model;
    if (name === this.#last.name && status === this.#last.status) return;
    this.#last = { name, status };
    this.dispatchEvent(new Event("change"));
  }
}
