// The sheet on which a person shares a puzzle: a picture or a short film, a text, and a link that challenges others.
// The page adds the link to what is seen, and the one for a lesson. Loaded when it is first needed. What is shared goes
// to the system’s share sheet where there is one, else to the clipboard or a file.

import { DARK_PALETTE, LIGHT_PALETTE } from "../pkg/constants.js";
import { byId } from "../widgets/dom.js";
import { difficultyWords } from "../puzzles/difficulty.js";
import { download, fileName } from "../widgets/download.js";
import { puzzleName } from "../puzzles/puzzle-name.js";
import { INITIAL_STATE, formatFragment } from "../state/url-state.js";
import { filmFormat } from "../attempts/film.js";
import { text } from "../text/text.js";
import { taskOfDay } from "./daily.js";
import { HEIGHT, WIDTH, paintResultCard } from "./result-card.js";
import { filmCanvas, recordResult } from "./result-film.js";

/** @typedef {import("../play/after-solving.js").Result} Result */
/** @typedef {import("../widgets/gallery.js").Template} Template */

/** More misses than these are counted, not drawn. */
const MOST_MARKS = 20;

export class ShareDialog {
  #templates;
  #dialog = byId(document, "share-dialog", HTMLDialogElement);
  #picture = byId(document, "share-picture", HTMLImageElement);
  #withBall = byId(document, "share-ball", HTMLInputElement);
  /** @type {Result | null} */
  #result = null;
  /** The address of the puzzle with the challenge, without the ball. */
  #link = "";
  #dark = false;
  /**
   * What is shared: the picture, or the film once there is one.
   * @type {File | null}
   */
  #file = null;
  #filmButton = byId(document, "share-film", HTMLButtonElement);
  #progress = byId(document, "share-progress", HTMLProgressElement);
  /**
   * The film that is being recorded.
   * @type {AbortController | null}
   */
  #recording = null;

  /** @param {Template[]} templates */
  constructor(templates) {
    this.#templates = templates;
    this.#withBall.addEventListener("change", () => {
      this.#recording?.abort();
      this.#draw();
    });
    this.#filmButton.addEventListener("click", () => (this.#recording ? this.#recording.abort() : this.#film()));
    this.#dialog.addEventListener("close", () => this.#recording?.abort());
    byId(document, "share-copy").addEventListener("click", () => this.#copy());
    byId(document, "share-save").addEventListener("click", () => this.#save());
    byId(document, "share-system").addEventListener("click", () => this.#share());
    // The result can be drawn only while its puzzle is open.
    addEventListener("popstate", () => this.#dialog.close());
  }

  /**
   * @param {Result} result
   * @param {import("../state/url-state.js").State} state
   * @param {boolean} dark
   */
  async show(result, { task, scene }, dark) {
    this.#result = result;
    const challenge = task === null ? null : result.solvedAt;
    this.#link = `${location.origin}${location.pathname}#${formatFragment({ ...INITIAL_STATE, task, scene, challenge })}`;
    this.#dark = dark;
    this.#withBall.checked = false;
    byId(document, "share-ball-words").textContent = solvedByBoth(result)
      ? text.sharing.showPaths
      : text.sharing.showBall;
    this.#say("");
    byId(document, "share-text").textContent = this.#words(result);
    await this.#draw();
    this.#filmButton.hidden = !filmFormat() || !result.openRun;
    if (result.isOpen()) this.#dialog.showModal();
  }

  get #palette() {
    return this.#dark ? DARK_PALETTE : LIGHT_PALETTE;
  }

  async #draw() {
    const result = this.#result;
    if (!result?.isOpen()) return;
    const canvas = Object.assign(document.createElement("canvas"), { width: WIDTH, height: HEIGHT });
    const lines = linesOf(result);
    if (this.#withBall.checked && solvedByBoth(result)) lines.model += ` ${text.sharing.card.dashed}`;
    paintResultCard(canvas, this.#palette, lines, (context) =>
      result.paint(context, this.#dark, this.#withBall.checked),
    );
    this.#picture.alt = text.sharing.card.alt(lines.name, lines.solved, lines.model);
    /** @type {Blob | null} */
    const blob = await new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
    if (!blob) return;
    this.#offer(blob, "png");
    URL.revokeObjectURL(this.#picture.src);
    this.#picture.src = URL.createObjectURL(blob);
  }

  /** Records the film, which is then shared instead of the picture. */
  async #film() {
    const result = this.#result;
    const format = filmFormat();
    if (!result?.openRun || !result.isOpen() || !format) return;
    const recording = (this.#recording = new AbortController());
    const canvas = filmCanvas();
    canvas.setAttribute("aria-hidden", "true");
    this.#picture.before(canvas);
    this.#picture.hidden = true;
    this.#filmButton.textContent = text.sharing.stop;
    this.#say("");
    this.#progress.value = 0;
    this.#progress.hidden = false;
    const { done } = text.sharing;
    let words = done.filmStopped;
    try {
      const film = await recordResult(
        {
          canvas,
          type: format.type,
          run: result.openRun(),
          lines: linesOf(result),
          palette: this.#palette,
          dark: this.#dark,
          onProgress: (fraction) => (this.#progress.value = fraction),
        },
        recording,
      );
      if (film) {
        this.#offer(film, format.extension);
        words = done.film(result.solvedAt !== null);
      }
    } catch {
      words = done.filmFailed;
    }
    canvas.remove();
    this.#progress.hidden = true;
    this.#picture.hidden = false;
    this.#recording = null;
    this.#filmButton.textContent = text.sharing.film;
    this.#say(words);
  }

  /**
   * Takes a file as the one that is saved and shared.
   * @param {Blob} blob
   * @param {string} extension
   */
  #offer(blob, extension) {
    // Browsers refuse to share a media type with parameters.
    const { task, name } = this.#result ?? {};
    this.#file = new File([blob], fileName(`pathlight ${task ?? name}`, extension), { type: blob.type.split(";")[0] });
    const { savePicture, saveFilm } = text.sharing;
    byId(document, "share-save").textContent = extension === "png" ? savePicture : saveFilm;
    const system = byId(document, "share-system");
    system.hidden = !navigator.canShare?.({ files: [this.#file] });
    byId(document, "share-copy").classList.toggle("primary", system.hidden);
  }

  /** @param {Result} result */
  #words(result) {
    const today = new Date();
    const name = nameOf(result);
    const words = text.sharing;
    if (result.solvedAt === null) return [words.ask(name), modelWords(result)].filter(Boolean).join(" ");
    if (
      result.task ===
      taskOfDay(
        today,
        this.#templates.flatMap(({ tasks }) => tasks),
      )
    ) {
      const misses = result.solvedAt - 1;
      const marks = misses > MOST_MARKS ? `${misses} × 🔴 ` : "🔴".repeat(misses);
      return `${words.day(text.page.day(today), name)}\n${marks}🟢\n${modelWords(result)}`.trim();
    }
    const challenge = result.solvedAt === 1 ? words.match : words.better;
    return [words.solved(name, result.solvedAt), modelWords(result), challenge].filter(Boolean).join(" ");
  }

  async #share() {
    if (!this.#file) return;
    const { textContent } = byId(document, "share-text");
    try {
      await navigator.share({ files: [this.#file], text: textContent ?? "", url: this.#link });
    } catch (error) {
      if (/** @type {Error} */ (error).name !== "AbortError") this.#say(text.sharing.done.shareFailed);
    }
  }

  async #copy() {
    try {
      await navigator.clipboard.writeText(`${byId(document, "share-text").textContent}\n${this.#link}`);
      this.#say(text.sharing.done.copied);
    } catch {
      this.#say(text.page.links.notCopied(this.#link));
    }
  }

  #save() {
    if (!this.#file) return;
    download(this.#file.name, this.#file);
    const { pictureSaved, filmSaved } = text.sharing.done;
    this.#say(this.#file.type.startsWith("image") ? pictureSaved : filmSaved);
  }

  /** @param {string} sentence */
  #say(sentence) {
    byId(document, "share-done").textContent = sentence;
  }
}

/**
 * The words of a card.
 * @param {Result} result
 */
function linesOf(result) {
  const { task, solvedAt } = result;
  const { solved, ask } = text.sharing.card;
  return {
    name: nameOf(result),
    solved: solvedAt ? solved(solvedAt) : ask,
    model: modelWords(result),
    difficulty: task ? difficultyWords(task) : "",
  };
}

/** @param {Result} result */
function solvedByBoth({ solvedAt, model }) {
  return Boolean(solvedAt && model?.solvedAt);
}

/** @param {Result} result */
function nameOf({ task, name }) {
  return task ? puzzleName(task) : name;
}

/** @param {Result} result */
function modelWords({ model }) {
  if (!model) return "";
  const { modelSolved, modelMissed } = text.sharing;
  const { used, solvedAt, remembers } = model;
  return solvedAt === null ? modelMissed(used, remembers) : modelSolved(solvedAt, remembers);
}
