// The presentation: the scene and one sentence in large type, for a projector. The sentence is the goal, then the
// story's, at the viewer's pace: by buttons, arrow keys or the keys of a clicker, or by itself. Everything else of the
// puzzle is out of sight.

import { withoutPresentation } from "../state/view.js";
import { text } from "../text/text.js";
import { Component } from "../widgets/component.js";
import { setText } from "../widgets/dom.js";

/**
 * The keys of the story; a clicker sends those of a page.
 * @type {Record<string, 1 | -1>}
 */
const STORY_KEYS = { ArrowRight: 1, PageDown: 1, ArrowLeft: -1, PageUp: -1 };
/** What keeps these keys for itself. */
const OWN_KEYS = "input, select, dialog";

export class Presentation extends Component {
  #walkthrough;
  /** Is it shown? */
  #on = false;
  #hasStory = false;
  /** May the person leave it? */
  #leaves = true;
  /** @type {Partial<import("../state/url-state.js").State>} */
  #left = { view: null };

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("./walkthrough.js").Walkthrough} walkthrough
   */
  constructor(root, walkthrough) {
    super(root);
    this.#walkthrough = walkthrough;
    walkthrough.addEventListener("step", () => this.#update());
    this.byId("caption-back").addEventListener("click", () => walkthrough.go(-1));
    this.byId("caption-next").addEventListener("click", () => walkthrough.go(1));
    this.byId("caption-play").addEventListener("click", () => walkthrough.toggle());
    this.byId("presentation-leave").addEventListener("click", () => this.requestState(this.#left));
    // Before the scene, where arrows move the ball.
    root.addEventListener("keydown", (event) => this.onKeydown(/** @type {KeyboardEvent} */ (event)), {
      capture: true,
    });
  }

  /** @param {import("../play/session.js").Session} session */
  open(session) {
    super.open(session);
    this.#update();
  }

  /** @param {import("../state/view.js").View} state */
  setState(state) {
    const { view, hide } = state;
    const on = view === "presentation";
    this.#left = withoutPresentation(state);
    const arrived = on && !this.#on;
    const left = !on && this.#on;
    this.#on = on;
    this.#hasStory = !hide.includes("imagine");
    this.#leaves = !hide.includes("tools");
    this.byId("presentation").hidden = !on;
    this.byId("puzzle").classList.toggle("presentation", on);
    this.#update();
    // What had the focus is out of sight now.
    if (arrived && this.session) this.byId(this.#hasStory ? "caption-next" : "scene").focus({ preventScroll: true });
    if (left && this.session) this.byId("scene").focus({ preventScroll: true });
  }

  /**
   * Acts on a key of the story, or on Escape, which leaves the presentation.
   * @param {KeyboardEvent} event
   */
  onKeydown(event) {
    const { key, target } = event;
    if (
      !this.#on ||
      event.defaultPrevented ||
      event.ctrlKey ||
      event.metaKey ||
      event.altKey ||
      (target instanceof Element && target.closest(OWN_KEYS))
    )
      return;
    const by = STORY_KEYS[key];
    if (key === "Escape" && this.#leaves) this.requestState(this.#left);
    else if (by && this.#hasStory) this.#walkthrough.go(by);
    else return;
    event.preventDefault();
  }

  #update() {
    if (!this.#on || !this.session) return;
    const { shown, playing } = this.#walkthrough;
    const { goal, name } = this.session;
    setText(this.byId("caption-step"), shown ? text.panels.of(shown.number, shown.count) : "");
    setText(this.byId("caption-title"), shown?.name ?? name);
    setText(this.byId("caption"), shown?.meaning ?? goal);
    setText(this.byId("caption-result"), shown?.result ?? "");
    const label = this.byId("scene-label");
    label.hidden = !shown;
    setText(label, shown?.name ?? "");
    this.byId("caption-back").setAttribute("aria-disabled", String(!shown));
    this.byId("caption-next").setAttribute("aria-disabled", String(shown !== null && shown.number === shown.count));
    setText(this.byId("caption-play-label"), playing ? text.panels.imagine.pause : text.panels.imagine.play);
    this.byId("caption-play-icon", SVGUseElement).setAttribute("href", playing ? "#icon-pause" : "#icon-run");
  }
}
