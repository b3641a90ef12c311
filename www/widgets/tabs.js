// The tabs and the panels that they show, by pointer and by arrow keys.

import { Component } from "./component.js";
import { find, setText } from "./dom.js";
import { PANELS } from "../state/url-state.js";
import { visiblePanels } from "../state/view.js";

/** @typedef {import("../state/url-state.js").Panel} Panel */

export class Tabs extends Component {
  /** @type {Panel[]} */
  #visible = [];
  /** @type {Panel} */
  #selected = "play";

  /** @param {import("./dom.js").Root} root */
  constructor(root) {
    super(root);
    for (const panel of PANELS) {
      const tab = this.byId(`tab-${panel}`);
      tab.addEventListener("click", () => this.requestState({ panel }));
      tab.addEventListener("keydown", (event) => this.#onKeydown(event));
    }
  }

  /** @param {import("../state/view.js").View} view */
  setState(view) {
    this.#visible = visiblePanels(view);
    this.#selected = view.panel;
    // A single panel needs no tab; the sheet about the keys tells of those that are there.
    this.byId("tabs").hidden = this.#visible.length === 1;
    for (const id of ["keys-of-panels", "key-panels"]) this.byId(id).hidden = this.#visible.length === 1;
    setText(find(this.byId("keys-of-panels"), "kbd:last-child"), String(this.#visible.length));
    setText(this.byId("key-panels"), this.#visible.map((panel) => this.byId(`tab-${panel}`).textContent).join(", "));
    for (const panel of PANELS) {
      const tab = this.byId(`tab-${panel}`);
      tab.setAttribute("aria-selected", String(panel === view.panel));
      tab.tabIndex = panel === view.panel ? 0 : -1;
      this.byId(panel).hidden = panel !== view.panel;
    }
  }

  /** @param {KeyboardEvent} event */
  #onKeydown(event) {
    const offset = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!offset) return;
    const panels = this.#visible;
    const panel = panels[(panels.indexOf(this.#selected) + offset + panels.length) % panels.length];
    this.requestState({ panel });
    this.byId(`tab-${panel}`).focus();
    event.preventDefault();
  }
}
