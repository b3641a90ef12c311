// The sheet “About Pathlight”: how the loaded model was trained, as its card says.

import { Component } from "../widgets/component.js";

/** The licences of all that is shipped. Not in the markup, because only a module knows where it lies. */
const LICENCES = new URL("../pkg/licences.txt", import.meta.url);

/** @typedef {import("../pkg/pathlight.js").ModelCard} Card */

/** @param {number} value */
const number = (value) => value.toLocaleString("en");

/**
 * The entries of a card in the order shown: key, term, and the value in words.
 * @type {[key: keyof Card, term: string, words: (value: any, card: Card) => string][]}
 */
const ENTRIES = [
  ["samples", "Learned from", (samples, { tasks }) => `${number(samples)} solutions of ${number(tasks)} puzzles`],
  ["epochs", "Looked at each", (epochs) => `${epochs} times`],
  [
    "setup",
    "Kinds of puzzles",
    (setup) =>
      setup === "within"
        ? "the same kinds that it is tested on, but other puzzles (“within”)"
        : "other kinds than those that it is tested on (“cross”)",
  ],
  [
    "fold",
    "Fold",
    (fold) => `${fold}, one of ten ways to part the puzzles into those to learn from and those to test on`,
  ],
  ["batch", "Batch size", number],
  ["learning_rate", "Learning rate (Adam)", String],
  ["decay_epochs", "Learning rate decays to zero over the last", (epochs) => `${epochs} epochs`],
  [
    "without_dev",
    "Dev tasks",
    (without) => (without ? "left out, to choose settings by them" : "learned from, like the other training puzzles"),
  ],
  ["mirror", "Mirrored", (mirror) => (mirror ? "half of the time, left to right" : "never")],
  [
    "success",
    "The success net learned from",
    ({ balls, epochs }) => `${number(balls)} balls with their outcome, ${epochs} times over`,
  ],
  [
    "dynamics",
    "The net that imagines balls learned from",
    ({ balls, epochs, from }) =>
      `${number(balls)} balls with their paths, in ${epochs} passes over the puzzles${from ? ", after an earlier training" : ""}`,
  ],
  ["simulator", "Version of the simulator", String],
  ["seed", "Random seed", String],
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
    this.byId("card").textContent = loaded ? `The model “${loaded.name}”:` : "No model is loaded.";
    this.byId("card-entries").replaceChildren(...(loaded ? entriesOf(loaded.card) : []));
  }
}

/**
 * The card as terms and descriptions.
 * @param {Card} card
 */
function entriesOf(card) {
  const rows = ENTRIES.filter(([key]) => key in card).map(([key, term, words]) => [term, words(card[key], card)]);
  return rows.flatMap(([term, words]) => {
    const [name, description] = [document.createElement("dt"), document.createElement("dd")];
    name.textContent = term;
    description.textContent = words;
    return [name, description];
  });
}
