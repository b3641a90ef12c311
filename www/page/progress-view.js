// The person's progress: a line above the grid, a note on each of its templates, a mark on each puzzle of the picker.
// Saves it to a file, and deletes it when the person is sure.

import { byId } from "../widgets/dom.js";
import { download } from "../widgets/download.js";
import { showNotice } from "../widgets/notice.js";
import { progressJson, takeProgress } from "../shell/progress-file.js";

/** @typedef {import("../widgets/gallery.js").Template} Template */

/** More than the progress and the attempts of a person at all puzzles, bytes. */
const MAX_SIZE = 2e7;

export class ProgressView {
  #progress;
  #store;
  #templates;
  #gallery;

  /**
   * @param {import("../shell/progress-store.js").SharedProgress} progress
   * @param {Template[]} templates
   * @param {import("../widgets/gallery.js").Gallery} gallery
   */
  constructor(progress, templates, gallery) {
    this.#progress = progress;
    const store = (this.#store = progress.player);
    this.#templates = templates;
    this.#gallery = gallery;
    byId(document, "progress-save").addEventListener("click", () => this.#save());
    const dialog = byId(document, "forget-dialog", HTMLDialogElement);
    byId(document, "progress-forget").addEventListener("click", () => dialog.showModal());
    // Its "close" waits for the next frame, which may come after another puzzle has been opened, or not at all.
    dialog.addEventListener("submit", ({ submitter }) => {
      if (submitter?.getAttribute("value") !== "forget") return;
      progress.attempts.clear();
      store.clear();
    });
    const file = byId(document, "progress-file", HTMLInputElement);
    byId(document, "progress-read").addEventListener("click", () => file.click());
    file.addEventListener("change", () => this.#take(file));
    store.addEventListener("change", () => this.#update());
    progress.attempts.addEventListener("change", () => this.#update());
    this.#update();
  }

  /**
   * Lists the puzzles of a task's template in the picker, with the task chosen.
   * @param {string} id
   */
  showTask(id) {
    const tasks = this.#templates.find((template) => template.tasks.includes(id))?.tasks ?? [id];
    const picker = byId(document, "task", HTMLSelectElement);
    const listed = Array.from(picker.options, (option) => option.value);
    if (String(listed) !== String(tasks))
      picker.replaceChildren(...tasks.map((task) => new Option(this.#label(task), task)));
    picker.value = id;
    picker.title = `Puzzle ${id}`;
  }

  #update() {
    const all = this.#store.sum(this.#templates.flatMap(({ tasks }) => tasks));
    const own = sumOf(this.#progress.attempts.ofOwnScenes);
    byId(document, "progress").hidden = all.tried + own.tried === 0;
    byId(document, "progress-words").textContent =
      `${totalWords(all, own)}${this.#store.persistent ? "" : " This browser keeps nothing for the page: it is forgotten when you close it."}`;
    for (const template of this.#templates)
      this.#gallery.mark(template, templateWords(this.#store.sum(template.tasks), template.tasks.length));
    for (const option of byId(document, "task", HTMLSelectElement).options)
      option.textContent = this.#label(option.value);
  }

  /**
   * A puzzle as the picker names it, with its result.
   * @param {string} task
   */
  #label(task) {
    const tasks = this.#templates.find((template) => template.tasks.includes(task))?.tasks ?? [task];
    const place = `${tasks.indexOf(task) + 1} of ${tasks.length}`;
    const { attempts, solved } = this.#store.of(task);
    if (solved) return `${place} ✓ in ${solved}`;
    return attempts ? `${place}, ${counted(attempts, "attempt")}` : place;
  }

  #save() {
    download("pathlight-progress.json", new Blob([progressJson(this.#progress)], { type: "application/json" }));
  }

  /**
   * Takes the file that the person has chosen.
   * @param {HTMLInputElement} input
   */
  async #take(input) {
    const [file] = input.files ?? [];
    if (!file) return;
    try {
      if (file.size > MAX_SIZE)
        throw new Error(`${file.name} is too large to be progress of Pathlight. Nothing was changed.`);
      const { puzzles, attempts } = takeProgress(this.#progress, await file.text());
      showNotice(`Read back: ${counted(puzzles, "puzzle")}, with ${counted(attempts, "attempt")}.`);
    } catch (error) {
      showNotice(/** @type {Error} */ (error).message);
    }
    input.value = "";
  }
}

/** @typedef {{ tried: number, solved: number, attempts: number }} Sum */

/** @type {(count: number, noun: string) => string} */
const counted = (count, noun) => `${count} ${noun}${count === 1 ? "" : "s"}`;

/**
 * Of the player's attempts at own scenes: how many scenes were tried, how many are solved, and how many attempts there
 * are.
 * @param {import("../shell/attempt-store.js").KeptAttempt[]} kept
 * @returns {Sum}
 */
function sumOf(kept) {
  const attempts = kept.filter(({ by }) => by === "player");
  const scenes = [...Map.groupBy(attempts, ({ puzzle }) => puzzle).values()];
  return {
    tried: scenes.length,
    solved: scenes.filter((ofScene) => ofScene.some(({ ending }) => ending.solved)).length,
    attempts: attempts.length,
  };
}

/**
 * @param {Sum} all of the templates' puzzles
 * @param {Sum} own of own puzzles
 */
function totalWords(all, own) {
  const sentences = [];
  if (all.tried)
    sentences.push(
      `So far you have tried ${counted(all.tried, "puzzle")} and solved ${all.solved}, in ${counted(all.attempts, "attempt")}.`,
    );
  if (own.tried)
    sentences.push(
      `Of your own puzzles you have tried ${own.tried} and solved ${own.solved}, in ${counted(own.attempts, "attempt")}.`,
    );
  return sentences.join(" ");
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
