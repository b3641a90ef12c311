// The person's progress: a line above the grid, a note on each of its templates, a mark on each puzzle of the picker.
// Saves it to a file, and deletes it when the person is sure.

import { byId, passFocus } from "../widgets/dom.js";
import { download } from "../widgets/download.js";
import { showNotice } from "../widgets/notice.js";
import { pathlight } from "../shell/page-api.js";
import { PLAYER } from "../storage/attempt-lines.js";
import { MOST_ATTEMPTS } from "../storage/progress.js";
import { progressJson, progressOfText } from "../storage/progress-file.js";
import { FileProblem, inSlices } from "../storage/sliced-work.js";
import { text } from "../text/text.js";
import { readChosen } from "./file-reading.js";

/** @typedef {import("../widgets/gallery.js").Template} Template */

/** More than the progress and the attempts of a person at all puzzles, bytes. */
const MAX_SIZE = 2e7;

export class ProgressView {
  #progress;
  #templates;
  #gallery;

  /**
   * @param {import("../storage/progress.js").Progress} progress
   * @param {Template[]} templates
   * @param {import("../widgets/gallery.js").Gallery} gallery
   */
  constructor(progress, templates, gallery) {
    this.#progress = progress;
    this.#templates = templates;
    this.#gallery = gallery;
    byId(document, "progress-save").addEventListener("click", () => this.#save());
    const dialog = byId(document, "forget-dialog", HTMLDialogElement);
    byId(document, "progress-forget").addEventListener("click", () => dialog.showModal());
    // Its "close" waits for the next frame, which may come after another puzzle has been opened, or not at all.
    dialog.addEventListener("submit", ({ submitter }) => {
      // First, so that the focus is where the dialog was opened, and goes on when that is hidden.
      dialog.close();
      if (submitter?.getAttribute("value") === "forget") progress.clear();
    });
    const file = byId(document, "progress-file", HTMLInputElement);
    byId(document, "progress-read").addEventListener("click", () => file.click());
    file.addEventListener("change", () => this.#take(file));
    progress.addEventListener("change", () => this.#update());
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
    picker.title = text.page.picker.puzzle(id);
  }

  #update() {
    const { player } = this.#progress;
    // Asked one by one, the 2,500 take longer than all else that a page does first.
    const tried = new Set(player.tasks);
    const sumOfTried = (/** @type {string[]} */ tasks) => player.sum(tasks.filter((task) => tried.has(task)));
    const all = sumOfTried(this.#templates.flatMap(({ tasks }) => tasks));
    const custom = sumOf(this.#progress.ofCustomScenes);
    const section = byId(document, "progress");
    const none = all.tried + custom.tried === 0;
    if (none) passFocus(section, byId(document, "gallery-order"));
    section.hidden = none;
    byId(document, "progress-words").textContent = [
      ...totalWords(all, custom),
      ...unkeptWords(this.#progress.unkept),
    ].join(" ");
    for (const template of this.#templates)
      this.#gallery.mark(template, templateWords(sumOfTried(template.tasks), template.tasks.length));
    for (const option of byId(document, "task", HTMLSelectElement).options)
      option.textContent = this.#label(option.value);
  }

  /**
   * A puzzle as the picker names it, with its result.
   * @param {string} task
   */
  #label(task) {
    const tasks = this.#templates.find((template) => template.tasks.includes(task))?.tasks ?? [task];
    const words = text.page.picker;
    const place = tasks.indexOf(task) + 1;
    const { attempts, solved } = this.#progress.player.of(task);
    if (solved) return words.solved(place, solved);
    return attempts ? words.tried(place, attempts) : words.place(place, tasks.length);
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
    const read = await readChosen(file.name, async (slices) => {
      if (file.size > MAX_SIZE) throw new FileProblem(text.page.files.tooLarge(file.name, MAX_SIZE / 1e6));
      const digestOf = (/** @type {any} */ scene) => pathlight.sceneDigest(scene);
      const { attempts, counts, unread } = await inSlices(progressOfText(await file.text(), digestOf), slices);
      return { ...(await inSlices(this.#progress.merging(attempts, counts), slices)), unread };
    });
    input.value = "";
    if (!read) return;
    const { failure, attempts: unkept } = this.#progress.unkept;
    const sentences = [...readWords(read), ...(unkept ? unkeptWords({ failure, attempts: unkept }) : [])];
    const words = text.page.progress;
    showNotice(sentences.join(" "), [
      [words.undo, () => this.#undo(read.undo)],
      ...(failure ? [/** @type {[string, () => void]} */ ([words.saveAll, () => this.#save()])] : []),
    ]);
  }

  /** @param {() => void} undo */
  #undo(undo) {
    undo();
    showNotice(text.page.progress.gone);
  }
}

/** @typedef {{ tried: number, solved: number, attempts: number }} Sum */

/**
 * Of the player's attempts at custom scenes: how many scenes were tried, how many are solved, and how many attempts
 * there are.
 * @param {import("../storage/attempt-lines.js").KeptAttempt[]} kept
 * @returns {Sum}
 */
function sumOf(kept) {
  const attempts = kept.filter(({ by }) => by === PLAYER);
  const solving = attempts.filter(({ ending }) => ending.solved);
  const scenes = (/** @type {typeof kept} */ some) => new Set(some.map(({ puzzle }) => puzzle)).size;
  return { tried: scenes(attempts), solved: scenes(solving), attempts: attempts.length };
}

/**
 * @param {Sum} all of the templates' puzzles
 * @param {Sum} custom of custom puzzles
 */
function totalWords(all, custom) {
  const words = text.page.progress;
  const sentences = [];
  if (all.tried) sentences.push(words.soFar(all.tried, all.solved, all.attempts));
  if (custom.tried) sentences.push(words.custom(custom.tried, custom.solved, custom.attempts));
  return sentences;
}

/** @param {import("../storage/progress.js").Merged & { unread: number }} read */
function readWords({ puzzles, attempts, added, solved, left, unread }) {
  const words = text.page.progress;
  const sentences = [words.readBack(puzzles, attempts), words.added(added, solved)];
  if (left) sentences.push(words.left(left, MOST_ATTEMPTS));
  if (unread) sentences.push(words.unread(unread));
  return sentences;
}

/** @param {import("../storage/progress.js").Progress["unkept"]} unkept */
function unkeptWords({ failure, attempts }) {
  const words = text.page.progress;
  if (failure === "forbidden") return [words.forbidden];
  return failure === "full" ? [words.full(attempts)] : [];
}

/**
 * The progress on one template of `total` puzzles.
 * @param {Sum} sum
 * @param {number} total
 */
function templateWords({ tried, solved, attempts }, total) {
  return tried === 0 ? "" : text.page.progress.ofKind(solved, total, attempts);
}
