// What stands in for a puzzle that is on its way, in the size that it is going to have, or says why there is none.
// Nothing is inherited from the page around it.

import { language } from "../text/language.js";
import { text } from "../text/text.js";
import { createButton } from "../widgets/dom.js";

export const placeholderSheet = new CSSStyleSheet();
placeholderSheet.replaceSync(`
  :host { all: initial; display: block; container-type: inline-size; }
  :host([hidden]) { display: none; }
  .placeholder { all: initial; display: block; direction: ltr; block-size: calc(100cqi + 384px); border-radius: 14px; background: rgb(128 128 128 / 0.12); }
  .placeholder:not(:empty) { block-size: auto; padding: 16px; color-scheme: light dark; background: Canvas; color: CanvasText; font: 16px/1.45 system-ui, sans-serif; }
  .placeholder p { margin: 0 0 8px; }
  .placeholder button { min-block-size: 36px; padding: 0 12px; font: inherit; }
  :host([fill]) .placeholder:empty, :host(:not([task], [scene])) .placeholder:empty { display: none; }
  @container (min-width: 760px) { .placeholder:empty { block-size: calc(min(55cqi, 640px) + 112px); } }
`);

export class Placeholder {
  element = document.createElement("div");

  constructor() {
    this.element.className = "placeholder";
  }

  showLoading() {
    this.element.removeAttribute("role");
    this.element.replaceChildren();
  }

  /**
   * Shows why there is no puzzle, with a button to try again.
   * @param {string} message
   * @param {() => void} onRetry
   */
  showFailure(message, onRetry) {
    const sentence = document.createElement("p");
    sentence.textContent = message;
    this.element.lang = language;
    this.element.setAttribute("role", "alert");
    this.element.replaceChildren(sentence, createButton(text.element.tryAgain, onRetry));
  }

  /** Puts the focus on the button, if there is one. */
  focus() {
    this.element.querySelector("button")?.focus();
  }
}
