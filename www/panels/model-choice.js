// What the menu says of the model: which it is, the others where there are several, and how much its maps cover.

import { Component } from "../widgets/component.js";
import { setText } from "../widgets/dom.js";
import { text } from "../text/text.js";

export class ModelChoice extends Component {
  #client;
  #opacity = this.byId("opacity", HTMLInputElement);
  #select = this.byId("model-select", HTMLSelectElement);

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../model/shared-client.js").SharedClient} client
   */
  constructor(root, client) {
    super(root);
    this.#client = client;
    this.#opacity.addEventListener("input", () => this.requestState({ opacity: Number(this.#opacity.value) }));
    this.#select.addEventListener("change", () => this.requestState({ model: this.#select.value }));
    client.addEventListener("change", () => this.#update());
  }

  /** @param {import("../state/view.js").View} view */
  setState({ opacity }) {
    this.#opacity.value = String(opacity);
  }

  #update() {
    const { loaded } = this.#client;
    if (!loaded) return;
    const { name, names, card } = loaded;
    setText(this.byId("model-words"), text.panels.model.named(name, text.model.knows[card.setup]));
    this.byId("model-choice").hidden = names.length < 2;
    this.#select.replaceChildren(...names.map((model) => new Option(model, model, model === name, model === name)));
  }
}
