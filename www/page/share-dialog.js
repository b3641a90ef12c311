// The sheet on which a person shares a result: a picture, a text, and a link that challenges others. Loaded when it is first
// needed. What is shared goes to the system’s share sheet where there is one, else to the clipboard or a file.

import { palette } from "../pkg/pathlight.js";
import { byId } from "../shell/dom.js";
import { difficultyWords } from "../shell/difficulty.js";
import { download } from "../shell/download.js";
import { puzzleName } from "../shell/puzzle-name.js";
import { INITIAL_STATE, formatFragment } from "../shell/url-state.js";
import { dayWords, taskOfDay } from "./daily.js";
import { paintResultCard } from "./result-card.js";

/** @typedef {import("../play/after-solving.js").Result} Result */
/** @typedef {import("../shell/gallery.js").Template} Template */

/** More misses than these are counted, not drawn. */
const MOST_MARKS = 20;

export class ShareDialog {
  #templates;
  #dialog = byId(document, "share-dialog", HTMLDialogElement);
  #picture = byId(document, "share-picture", HTMLImageElement);
  #withBall = byId(document, "share-ball", HTMLInputElement);
  /** @type {Result | null} */
  #result = null;
  #dark = false;
  /** @type {File | null} */
  #file = null;

  /** @param {Template[]} templates */
  constructor(templates) {
    this.#templates = templates;
    this.#withBall.addEventListener("change", () => this.#draw());
    byId(document, "share-copy").addEventListener("click", () => this.#copy());
    byId(document, "share-save").addEventListener("click", () => this.#save());
    byId(document, "share-system").addEventListener("click", () => this.#share());
    // The result can be drawn only while its puzzle is open.
    addEventListener("popstate", () => this.#dialog.close());
  }

  /**
   * @param {Result} result
   * @param {boolean} dark
   */
  async show(result, dark) {
    this.#result = result;
    this.#dark = dark;
    this.#withBall.checked = false;
    this.#say("");
    byId(document, "share-text").textContent = this.#words(result);
    await this.#draw();
    byId(document, "share-system").hidden = !this.#file || !navigator.canShare?.({ files: [this.#file] });
    this.#dialog.showModal();
  }

  async #draw() {
    const result = this.#result;
    if (!result) return;
    const canvas = document.createElement("canvas");
    const lines = {
      name: puzzleName(result.task),
      solved: result.solvedAt === 1 ? "Solved at the first attempt" : `Solved in ${result.solvedAt} attempts`,
      model: modelWords(result),
      difficulty: difficultyWords(result.task),
    };
    paintResultCard(canvas, palette(this.#dark), lines, (context) => result.paint(context, this.#dark, this.#withBall.checked));
    this.#picture.alt = `${lines.name}. ${lines.solved}. ${lines.model}`;
    /** @type {Blob | null} */
    const blob = await new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
    if (!blob) return;
    this.#file = new File([blob], `pathlight-${result.task.replace(":", "-")}.png`, { type: blob.type });
    URL.revokeObjectURL(this.#picture.src);
    this.#picture.src = URL.createObjectURL(blob);
  }

  /** @param {Result} result */
  #words(result) {
    const today = new Date();
    const name = puzzleName(result.task);
    if (result.task === taskOfDay(today, this.#templates.flatMap(({ tasks }) => tasks))) {
      const misses = result.solvedAt - 1;
      const marks = misses > MOST_MARKS ? `${misses} × 🔴 ` : "🔴".repeat(misses);
      return `Pathlight, ${dayWords(today)}: ${name}\n${marks}🟢\n${modelWords(result)}`.trim();
    }
    const how = result.solvedAt === 1 ? "at the first attempt" : `in ${result.solvedAt} attempts`;
    return [`I solved Pathlight’s puzzle “${name}” ${how}.`, modelWords(result), "Can you do better?"].filter(Boolean).join(" ");
  }

  /** The address of the puzzle with the challenge, without the ball. */
  get #link() {
    const { task = null, solvedAt = null } = this.#result ?? {};
    return `${location.origin}${location.pathname}#${formatFragment({ ...INITIAL_STATE, task, challenge: solvedAt })}`;
  }

  async #share() {
    if (!this.#file) return;
    const { textContent: text } = byId(document, "share-text");
    try {
      await navigator.share({ files: [this.#file], text: text ?? "", url: this.#link });
    } catch (error) {
      if (/** @type {Error} */ (error).name !== "AbortError") this.#say("This browser could not share it. Copy the text, or save the picture.");
    }
  }

  async #copy() {
    try {
      await navigator.clipboard.writeText(`${byId(document, "share-text").textContent}\n${this.#link}`);
      this.#say("The text and the link are copied.");
    } catch {
      this.#say(`This browser does not let the page copy. The link is ${this.#link}`);
    }
  }

  #save() {
    if (!this.#file) return;
    download(this.#file.name, this.#file);
    this.#say("The picture is saved.");
  }

  /** @param {string} sentence */
  #say(sentence) {
    byId(document, "share-done").textContent = sentence;
  }
}

/** @param {Result} result */
function modelWords({ model }) {
  if (!model) return "";
  if (model.solvedAt === null) return `The model did not solve it in ${model.used}.`;
  return model.solvedAt === 1 ? "The model needed one attempt." : `The model needed ${model.solvedAt}.`;
}
