// The box in a panel that says what went wrong with the model, with a button that tries again. Used by all panels that
// call the worker.

import { text } from "../text/text.js";
import { byId, find, passFocus, setText } from "../widgets/dom.js";

/** @typedef {import("../model/shared-client.js").SharedClient} SharedClient */

export class TroubleBox {
  #box;
  #button;
  /** @type {() => void} */
  #onRetry = () => {};

  /** @param {HTMLElement} box */
  constructor(box) {
    this.#box = box;
    this.#button = find(box, "button");
    this.#button.addEventListener("click", () => this.#onRetry());
  }

  /**
   * Shows why the model could not be loaded, if so, else why a call failed, else nothing.
   * @param {SharedClient} client
   * @param {string | null} callFailure
   * @param {{ restartModel: () => void, repeatCall: () => void }} actions
   */
  update(client, callFailure, { restartModel, repeatCall }) {
    const { failure } = client;
    const message = failure?.message ?? callFailure;
    if (message === null) passFocus(this.#box, byId(/** @type {ShadowRoot} */ (this.#box.getRootNode()), "scene"));
    this.#box.hidden = message === null;
    setText(find(this.#box, "p"), message ?? "");
    setText(this.#button, failure?.code === "no_model" ? text.panels.trouble.otherModel : text.element.tryAgain);
    this.#onRetry = failure ? restartModel : repeatCall;
  }
}
