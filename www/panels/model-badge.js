// Says what the model knows wherever a result of it stands, and whether it has seen the puzzle in training, which
// decides what the result is worth. Also says which nets the model has.

import { Component } from "../widgets/component.js";
import { PAPER_MAPS } from "../shell/constants.js";
import { setText } from "../widgets/dom.js";
import { ballNetOf } from "../model/ball-net.js";
import { practice } from "../model/practice.js";
import { text } from "../text/text.js";

export class ModelBadge extends Component {
  #client;
  #imagine;
  #badges;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../model/shared-client.js").SharedClient} client
   * @param {import("./imagine.js").Imagine} imagine
   */
  constructor(root, client, imagine) {
    super(root);
    this.#client = client;
    this.#imagine = imagine;
    this.#badges = Array.from(root.querySelectorAll(".model-badge"), (element) => {
      const [name, seen] = [document.createElement("b"), document.createElement("span")];
      element.append(name, " ", seen);
      return { element: /** @type {HTMLElement} */ (element), name, seen };
    });
    client.addEventListener("change", () => this.#update());
    imagine.addEventListener("maps", () => this.#update());
    this.#update();
  }

  #update() {
    const { loaded } = this.#client;
    const known = this.#imagine.seen;
    const { nets, knows, kinds } = text.model;
    const ballNet = ballNetOf(loaded?.card);
    setText(this.byId("imagine-intro"), nets.intro(PAPER_MAPS.length, ballNet));
    setText(this.byId("about-nets"), text.panels.model.nets(nets.about(PAPER_MAPS.length, ballNet)));
    for (const { element, name, seen } of this.#badges) {
      element.hidden = !loaded;
      if (!loaded) continue;
      setText(name, kinds[loaded.card.setup]);
      element.title = text.panels.model.named(loaded.name, knows[loaded.card.setup]);
      seen.hidden = known === null;
      seen.dataset.seen = String(known);
      setText(seen, known === null ? "" : practice(loaded.card, known));
    }
  }
}
