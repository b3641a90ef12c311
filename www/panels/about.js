// The sheet “About Pathlight”: how the loaded model was trained, as its card says.

import { Component } from "../widgets/component.js";
import { text } from "../text/text.js";

/** The licences of all that is shipped. Not in the markup, because only a module knows where it lies. */
const LICENCES = new URL("../pkg/licences.txt", import.meta.url);

/** @typedef {import("../pkg/pathlight.js").ModelCard} Card */

/**
 * The entries of a card in the order shown.
 * @type {import("../text/en/model.js").CardEntry[]}
 */
const ENTRIES = [
  "samples",
  "epochs",
  "setup",
  "fold",
  "batch",
  "learning_rate",
  "decay_epochs",
  "without_dev",
  "mirror",
  "success",
  "dynamics",
  "simulator",
  "seed",
];

export class About extends Component {
  #client;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../model/shared-client.js").SharedClient} client
   */
  constructor(root, client) {
    super(root);
    this.#client = client;
    client.addEventListener("change", () => this.#update());
    this.byId("licences", HTMLAnchorElement).href = LICENCES.href;
  }

  #update() {
    const { loaded } = this.#client;
    this.byId("card").textContent = loaded ? text.panels.about(loaded.name) : text.element.about.noModel;
    this.byId("card-entries").replaceChildren(...(loaded ? entriesOf(loaded.card) : []));
  }
}

/**
 * The card as terms and descriptions.
 * @param {Card} card
 */
function entriesOf(card) {
  return ENTRIES.filter((key) => key in card).flatMap((key) => {
    const { term, words } = text.model.card[key];
    const [name, description] = [document.createElement("dt"), document.createElement("dd")];
    name.textContent = term;
    description.textContent = words(card[key], card);
    return [name, description];
  });
}
