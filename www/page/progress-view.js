// The person's progress: a line above the grid, a note on each of its templates, a mark on each puzzle of the picker.
// Saves it to a file, and deletes it when the person is sure.

import { byId } from "../widgets/dom.js";
import { download } from "../widgets/download.js";
import { showNotice } from "../widgets/notice.js";
import { pathlight } from "../shell/page-api.js";
import { PLAYER } from "../storage/attempts.js";
import { MOST_ATTEMPTS } from "../storage/progress.js";
import { progressJson, progressOfText } from "../storage/progress-file.js";
import { FileProblem, inSlices } from "../storage/sliced-work.js";
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
    picker.title = `Puzzle ${id}`;
  }

  #update() {
    const { player } = this.#progress;
    const all = player.sum(this.#templates.flatMap(({ tasks }) => tasks));
    const custom = sumOf(this.#progress.ofCustomScenes);
    byId(document, "progress").hidden = all.tried + custom.tried === 0;
    byId(document, "progress-words").textContent = `${totalWords(all, custom)}${unkeptWords(this.#progress.unkept)}`;
    for (const template of this.#templates)
      this.#gallery.mark(template, templateWords(player.sum(template.tasks), template.tasks.length));
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
    const { attempts, solved } = this.#progress.player.of(task);
    if (solved) return `${place} ✓ in ${solved}`;
    return attempts ? `${place} × in ${attempts}` : place;
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
      if (file.size > MAX_SIZE)
        throw new FileProblem(`${file.name} is larger than ${MAX_SIZE / 1e6} MB. Split it. Nothing was changed.`);
      const digestOf = (/** @type {any} */ scene) => pathlight.sceneDigest(scene);
      const { attempts, counts, unread } = await inSlices(progressOfText(await file.text(), digestOf), slices);
      return { ...(await inSlices(this.#progress.merging(attempts, counts), slices)), unread };
    });
    input.value = "";
    if (!read) return;
    const { failure, attempts: unkept } = this.#progress.unkept;
    showNotice(`${readWords(read)}${failure && unkept ? unkeptWords({ failure, attempts: unkept }) : ""}`, [
      ["Undo", () => this.#undo(read.undo)],
      ...(failure ? [/** @type {[string, () => void]} */ (["Save all to a file", () => this.#save()])] : []),
    ]);
  }

  /** @param {() => void} undo */
  #undo(undo) {
    undo();
    showNotice("What was read is gone again.");
  }
}

/** @typedef {{ tried: number, solved: number, attempts: number }} Sum */

/** @type {(count: number, noun: string) => string} */
const counted = (count, noun) => `${count.toLocaleString("en")} ${noun}${count === 1 ? "" : "s"}`;

/**
 * Of the player's attempts at custom scenes: how many scenes were tried, how many are solved, and how many attempts
 * there are.
 * @param {import("../storage/attempts.js").KeptAttempt[]} kept
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
  const sentences = [];
  if (all.tried)
    sentences.push(
      `So far you have tried ${counted(all.tried, "puzzle")} and solved ${all.solved}, in ${counted(all.attempts, "attempt")}.`,
    );
  if (custom.tried)
    sentences.push(
      `Of your own puzzles you have tried ${custom.tried} and solved ${custom.solved}, in ${counted(custom.attempts, "attempt")}.`,
    );
  return sentences.join(" ");
}

/** @param {import("../storage/progress.js").Merged & { unread: number }} read */
function readWords({ puzzles, attempts, added, solved, left, unread }) {
  const sentences = [
    `Read back: ${counted(puzzles, "puzzle")}, with ${counted(attempts, "attempt")}.`,
    `New here: ${counted(added, "attempt")}, ${counted(solved, "solved puzzle")}.`,
  ];
  if (left)
    sentences.push(
      `${counted(left, "attempt")} stay in the file alone: this browser keeps 100 of one player at a puzzle, 1,000 at custom puzzles, and ${MOST_ATTEMPTS.toLocaleString("en")} in all.`,
    );
  if (unread) sentences.push(`Not read: ${counted(unread, "line")} without a valid attempt.`);
  return sentences.join(" ");
}

/** @param {import("../storage/progress.js").Progress["unkept"]} unkept */
function unkeptWords({ failure, attempts }) {
  if (failure === "forbidden") return " This browser keeps nothing for the page: it is forgotten when you close it.";
  if (failure === "full")
    return ` This browser has no room left: ${counted(attempts, "attempt")} are lost when you close the page, unless you save them to a file.`;
  return "";
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
