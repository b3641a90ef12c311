// The tabs and the panels that they show, by pointer and by arrow keys, and the parts of a tab.

import { Component } from "./component.js";
import { find, setText } from "./dom.js";
import { PANELS, TABS, factsOf, partsOf, tabOf } from "../state/panels.js";
import { visiblePanels, visibleTabs } from "../state/view.js";
import { text } from "../text/text.js";

/** @typedef {import("../state/panels.js").Panel} Panel */

export class Tabs extends Component {
  #root;
  /**
   * What the tabs open.
   * @type {Panel[]}
   */
  #opened = [];
  /** @type {Panel} */
  #selected = "play";

  /** @param {import("./dom.js").Root} root */
  constructor(root) {
    super(root);
    this.#root = root;
    for (const { name } of TABS) {
      const tab = this.byId(`tab-${name}`);
      tab.addEventListener("click", () => this.#open(name));
      tab.addEventListener("keydown", (event) => this.#onKeydown(event));
    }
    for (const { name, below } of PANELS)
      root.getElementById(`open-${name}`)?.addEventListener("click", () => {
        // What opens below is closed the same way.
        if (below && this.#selected === name) this.#open(tabOf(name));
        else this.requestState({ panel: name });
      });
  }

  /** @param {import("../state/view.js").View} view */
  setState(view) {
    const { panel: selected, tab: selectedTab } = view;
    const visible = visiblePanels(view);
    this.#opened = visibleTabs(view);
    this.#selected = selected;
    // A single tab needs no row; the sheet about the keys tells of those that are there.
    const single = this.#opened.length === 1;
    for (const id of ["tabs", "keys-of-panels", "key-panels"]) this.byId(id).hidden = single;
    setText(find(this.byId("keys-of-panels"), "kbd:last-child"), String(this.#opened.length));
    setText(this.byId("key-panels"), this.#opened.map((panel) => text.element.panels[panel]).join(", "));
    for (const { name } of TABS) {
      const tab = this.byId(`tab-${name}`);
      const opened = this.#opened.find((panel) => tabOf(panel) === name);
      tab.hidden = !opened;
      // A tab that has lost its own panel is named after what is left.
      setText(tab, text.element.panels[opened ?? name]);
      tab.setAttribute("aria-selected", String(name === selectedTab));
      tab.tabIndex = name === selectedTab ? 0 : -1;
      this.byId(`tabpanel-${name}`).hidden = name !== selectedTab;
      this.#showParts(name, visible);
    }
  }

  /**
   * @param {Panel} tab
   * @param {Panel[]} visible
   */
  #showParts(tab, visible) {
    const parts = partsOf(tab);
    const inPlace = parts.filter(({ name, below }) => !below && visible.includes(name));
    // What opens below leaves the others of its tab in sight.
    const beneath = factsOf(this.#selected).below && tabOf(this.#selected) === tab;
    for (const { name, below } of parts) {
      const shown = name === this.#selected;
      this.byId(name).hidden = !shown && !(beneath && name === tab);
      const opener = this.#root.getElementById(`open-${name}`);
      opener?.setAttribute(below ? "aria-expanded" : "aria-pressed", String(shown));
    }
    const row = this.#root.getElementById(`parts-${tab}`);
    if (row) row.hidden = inPlace.length < 2;
  }

  /** @param {Panel} tab */
  #open(tab) {
    const panel = this.#opened.find((one) => tabOf(one) === tab);
    if (panel) this.requestState({ panel });
  }

  /** @param {KeyboardEvent} event */
  #onKeydown(event) {
    const offset = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!offset) return;
    const tabs = this.#opened.map(tabOf);
    const tab = tabs[(tabs.indexOf(tabOf(this.#selected)) + offset + tabs.length) % tabs.length];
    this.#open(tab);
    this.byId(`tab-${tab}`).focus();
    event.preventDefault();
  }
}
