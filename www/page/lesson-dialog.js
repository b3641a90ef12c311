// The dialog that makes a link for a lesson: what of the page it shows, a preview, the address, and the address as a QR
// code.

import { PathlightPuzzle } from "../element/pathlight-puzzle.js";
import { byId } from "../widgets/dom.js";
import { PANELS } from "../state/panels.js";
import { HIDEABLE, formatFragment } from "../state/url-state.js";
import { visiblePanels } from "../state/view.js";
import { text } from "../text/text.js";

/** @typedef {import("../state/url-state.js").State} State */
/** @typedef {import("../state/url-state.js").Hideable} Hideable */
/** @typedef {import("../state/panels.js").Panel} Panel */
/**
 * @typedef {{ generate: (address: string) => { toCanvas: (canvas: HTMLCanvasElement, colours: { on: number[], off:
 *   number[] }) => void } }} QrLibrary
 */

/** The size of the page that the preview shows, CSS px. */
const PREVIEW_WIDTH = 1280;
/** Names of this machine, which mean another one elsewhere. */
const OWN_MACHINE = /^(localhost|127\.|\[::1\])/;

export class LessonDialog {
  #dialog = byId(document, "lesson-dialog", HTMLDialogElement);
  #address = byId(document, "lesson-address", HTMLInputElement);
  /** @type {Map<Hideable, HTMLInputElement>} */
  #boxes = new Map();
  #presentation = byId(document, "lesson-presentation", HTMLInputElement);
  #withBall = byId(document, "lesson-ball", HTMLInputElement);
  /** @type {State | null} */
  #state = null;
  /** @type {PathlightPuzzle | null} */
  #preview = null;

  constructor() {
    /** @type {(part: Hideable) => boolean} */
    const isPanel = (part) => PANELS.some(({ name }) => name === part);
    byId(document, "lesson-panels").append(...PANELS.map(({ name }) => this.#row(name)));
    byId(document, "lesson-parts").append(...HIDEABLE.filter((part) => !isPanel(part)).map((part) => this.#row(part)));
    this.#dialog.addEventListener("change", () => this.#update());
    this.#dialog.addEventListener("close", () => this.#removePreview());
    byId(document, "lesson-copy").addEventListener("click", () => this.#copy());
    byId(document, "lesson-close").addEventListener("click", () => this.#dialog.close());
  }

  /**
   * Opens the dialog for what is shown.
   * @param {State} state
   */
  show(state) {
    this.#state = state;
    for (const [part, box] of this.#boxes) box.checked = !state.hide.includes(part);
    this.#presentation.checked = state.view === "presentation";
    this.#withBall.checked = false;
    this.#withBall.disabled = state.ball === null;
    byId(document, "lesson-words").textContent = "";
    this.#dialog.showModal();
    this.#addPreview();
    this.#update();
  }

  /** @param {Hideable} part */
  #row(part) {
    const box = document.createElement("input");
    box.type = "checkbox";
    box.name = part;
    this.#boxes.set(part, box);
    const label = document.createElement("label");
    label.className = "check";
    label.append(box, ` ${text.sharing.lesson.parts[part] ?? text.element.panels[/** @type {Panel} */ (part)]}`);
    const row = document.createElement("li");
    row.append(label);
    return row;
  }

  /** What the link asks for. */
  get #lesson() {
    const state = /** @type {State} */ (this.#state);
    const hide = HIDEABLE.filter((part) => !this.#boxes.get(part)?.checked);
    const panels = visiblePanels({ ...state, hide });
    const panel = panels.includes(state.panel) ? state.panel : panels[0];
    const ball = this.#withBall.checked ? state.ball : null;
    const step = panel === "imagine" || this.#presentation.checked ? state.step : null;
    return {
      ...state,
      panel,
      step,
      ball,
      hide,
      view: this.#presentation.checked ? /** @type {const} */ ("presentation") : null,
    };
  }

  #update() {
    const lesson = this.#lesson;
    const panels = visiblePanels(lesson);
    // One panel stays.
    for (const { name } of PANELS) {
      const box = this.#boxes.get(name);
      if (box) box.disabled = panels.length === 1 && panels[0] === name;
    }
    const address = new URL(`#${formatFragment(lesson)}`, location.href);
    this.#address.value = address.href;
    byId(document, "lesson-own-machine").hidden = !OWN_MACHINE.test(address.hostname);
    // Where the link does not say, newcomers see the model's guess. The preview keeps nothing, so it would not show it.
    const forecast = lesson.forecast ?? (lesson.view === null && lesson.challenge === null);
    if (this.#preview) this.#preview.state = { ...lesson, forecast };
    this.#drawCode(address.href);
  }

  /** @param {string} address */
  async #drawCode(address) {
    const canvas = byId(document, "lesson-code", HTMLCanvasElement);
    const failure = byId(document, "lesson-code-failure");
    try {
      // A module of its own, because few need it.
      /** @type {QrLibrary} */
      const { generate } = /** @type {any} */ (await import("../pkg/lean-qr.js"));
      generate(address).toCanvas(canvas, { on: [0, 0, 0], off: [255, 255, 255] });
      failure.textContent = "";
    } catch (error) {
      failure.textContent = text.sharing.lesson.noCode(/** @type {Error} */ (error).message);
    }
    canvas.hidden = failure.textContent !== "";
    failure.hidden = failure.textContent === "";
  }

  async #copy() {
    this.#address.select();
    const words = byId(document, "lesson-words");
    try {
      await navigator.clipboard.writeText(this.#address.value);
      words.textContent = text.sharing.lesson.copied;
    } catch {
      words.textContent = text.sharing.lesson.notCopied;
    }
  }

  /** The puzzle as the link shows it, as a picture: it is not operated here. */
  #addPreview() {
    const frame = byId(document, "lesson-preview");
    const preview = new PathlightPuzzle();
    preview.setAttribute("fill", "");
    preview.inert = true;
    frame.replaceChildren(preview);
    frame.style.setProperty("--scale", String(frame.clientWidth / PREVIEW_WIDTH));
    this.#preview = preview;
  }

  #removePreview() {
    this.#preview?.remove();
    this.#preview = null;
  }
}
