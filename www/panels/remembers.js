// The switch "The model remembers", beside the race: how many puzzles it remembers, and how it forgets them. It is off
// at first, and the browser remembers the choice. In a challenge or a lesson it is off again, so that everybody meets
// the same model; there it can be switched on for this link alone.

import { Component } from "../widgets/component.js";
import { setText } from "../widgets/dom.js";
import { text } from "../text/text.js";

/** @typedef {import("../state/view.js").View} View */

export class Remembers extends Component {
  #memory;
  #preferences;
  #box = this.byId("remembers-on", HTMLInputElement);
  #forget = this.byId("remembers-forget", HTMLButtonElement);
  /** The challenge or the lesson that the person plays; empty for none. */
  #link = "";
  /** What the person has chosen for it. */
  #chosen = false;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../model/model-memory.js").ModelMemory} memory
   * @param {import("../storage/preferences.js").Preferences} preferences
   */
  constructor(root, memory, preferences) {
    super(root);
    this.#memory = memory;
    this.#preferences = preferences;
    this.#box.addEventListener("change", () => this.#onSwitch());
    this.#forget.addEventListener("click", () => this.#onForget());
    memory.addEventListener("change", () => this.#update());
  }

  /** @param {import("../play/session.js").Session} session */
  open(session) {
    super.open(session);
    this.listen("attempted", () => {
      const { shown } = session;
      if (shown) this.#memory.remember(session, shown.ball, shown.ending.solved);
    });
  }

  close() {
    super.close();
    this.#memory.kept.damaged = false;
  }

  /** @param {View} view */
  setState(view) {
    const link = linkOf(view);
    if (link !== this.#link) this.#chosen = false;
    this.#link = link;
    this.#apply();
  }

  #apply() {
    this.#box.checked = this.#link ? this.#chosen : this.#preferences.remembers;
    this.#memory.switch(this.#box.checked);
    this.#update();
  }

  #onSwitch() {
    if (this.#link) this.#chosen = this.#box.checked;
    else this.#preferences.remembers = this.#box.checked;
    this.#apply();
    this.announce(this.#words);
  }

  #onForget() {
    this.#memory.forget();
    this.#box.focus();
    this.announce(text.learns.forgotten);
  }

  get #words() {
    const { on, count, kept } = this.#memory;
    if (!on) return "";
    const { damaged, nothing } = text.panels.remembers;
    const sentence = count ? text.learns.remembers(count) : nothing;
    return kept.damaged ? `${damaged} ${sentence}` : sentence;
  }

  #update() {
    const { on, able, count } = this.#memory;
    this.byId("remembers").hidden = able === false;
    this.#forget.hidden = !on || count === 0;
    this.byId("proposals-afresh").hidden = !on;
    setText(this.byId("remembers-words"), this.#words);
  }
}

/**
 * The challenge or the lesson of a view; empty for none.
 * @param {View} view
 */
function linkOf({ task, scene, challenge, hide }) {
  return challenge === null ? String(hide) : `${task ?? scene} ${challenge}`;
}
