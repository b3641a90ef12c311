// The person's progress: a line above the grid, a note on each of its templates, a mark on each puzzle of the picker.
// Saves it to a file, and deletes it when the person is sure.

import { Component } from "./component.js";
import { byId } from "./dom.js";

/** @typedef {import("./gallery.js").Template} Template */

/** The browser may read a download some time after the click; its address is kept so long, ms. */
const DOWNLOAD_TIME = 60_000;

export class ProgressView extends Component {
  #store;
  #templates;
  #gallery;

  /**
   * @param {import("./progress-store.js").ProgressStore} store
   * @param {Template[]} templates
   * @param {import("./gallery.js").Gallery} gallery
   */
  constructor(store, templates, gallery) {
    super();
    this.#store = store;
    this.#templates = templates;
    this.#gallery = gallery;
    byId("progress-save").addEventListener("click", () => this.#save());
    const dialog = byId("forget-dialog", HTMLDialogElement);
    dialog.addEventListener("close", () => {
      if (dialog.returnValue === "forget") store.clear();
    });
    store.addEventListener("change", () => this.#update());
    this.#update();
  }

  /** @param {import("../play/session.js").Session} session */
  open(session) {
    super.open(session);
    const { id } = session.about;
    const tasks = this.#templates.find((template) => template.tasks.includes(id))?.tasks ?? [id];
    const picker = byId("task", HTMLSelectElement);
    picker.replaceChildren(...tasks.map((task) => new Option(this.#label(task), task, task === id, task === id)));
    picker.title = `Puzzle ${tasks.indexOf(id) + 1} of ${tasks.length}`;
  }

  #update() {
    const all = this.#store.sum(this.#templates.flatMap(({ tasks }) => tasks));
    byId("progress").hidden = all.tried === 0;
    byId("progress-words").textContent = `${totalWords(all)}${this.#store.persistent ? "" : " This browser keeps nothing for the page: it is forgotten when you close it."}`;
    for (const { id, tasks } of this.#templates) this.#gallery.mark(id, templateWords(this.#store.sum(tasks), tasks.length));
    for (const option of byId("task", HTMLSelectElement).options) option.textContent = this.#label(option.value);
  }

  /**
   * A puzzle as the picker names it, with its result.
   * @param {string} task
   */
  #label(task) {
    const { attempts, solved } = this.#store.of(task);
    if (solved) return `${task} ✓ in ${solved}`;
    return attempts ? `${task} × ${attempts}` : task;
  }

  #save() {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([this.#store.toJson()], { type: "application/json" }));
    link.download = "pathlight-progress.json";
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), DOWNLOAD_TIME);
  }
}

/** @typedef {{ tried: number, solved: number, attempts: number }} Sum */

/** @type {(count: number, noun: string) => string} */
const counted = (count, noun) => `${count} ${noun}${count === 1 ? "" : "s"}`;

/** @param {Sum} sum */
function totalWords({ tried, solved, attempts }) {
  return `So far you have tried ${counted(tried, "puzzle")} and solved ${solved}, in ${counted(attempts, "attempt")}.`;
}

/**
 * The progress on one template of `total` puzzles.
 * @param {Sum} sum
 * @param {number} total
 */
function templateWords({ tried, solved, attempts }, total) {
  if (tried === 0) return "";
  return `${solved ? "✓" : "×"} ${solved} of ${total} solved, in ${counted(attempts, "attempt")}`;
}
