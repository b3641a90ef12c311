// The custom puzzles in the grid, beside the templates: each with a picture, its name, how it went, and a button
// that deletes it with its attempts; files are opened by a button or dropped anywhere in the page, and all puzzles are
// saved in one.

import { LazyThumbnails } from "../widgets/lazy-thumbnails.js";
import { paintThumbnail } from "../widgets/scene-thumbnail.js";
import { byId, createButton, find, passFocus } from "../widgets/dom.js";
import { showNotice } from "../widgets/notice.js";
import { pathlight } from "../shell/page-api.js";
import { puzzleKey } from "../shell/puzzle-key.js";
import { sceneName } from "../puzzles/puzzle-name.js";
import { INITIAL_STATE, formatFragment } from "../state/url-state.js";
import { PLAYER, grouped } from "../storage/attempt-lines.js";
import { MOST_PUZZLES, customPuzzles } from "../storage/puzzle-store.js";
import { atOnce, inSlices } from "../storage/sliced-work.js";
import { readPuzzles, savePuzzles } from "../editor/puzzle-file.js";
import { textOfScene } from "../editor/scene-link.js";
import { text } from "../text/text.js";
import { readChosen } from "./file-reading.js";

/** @typedef {import("../pkg/pathlight.js").CustomScene} CustomScene */
/** @typedef {import("../state/url-state.js").State} State */

/** Width of a picture, CSS px. */
const SIDE = 176;

export class CustomGallery {
  #store = customPuzzles();
  #list = byId(document, "custom-puzzles");
  #progress;
  #navigate;
  #dark = false;
  /** @type {Pick<State, "model" | "hide">} */
  #state = INITIAL_STATE;
  /** @type {WeakMap<HTMLCanvasElement, CustomScene>} */
  #sceneOf = new WeakMap();
  /**
   * What is shown of each puzzle, by its JSON, with what its attempts are kept under.
   * @type {Map<string, { scene: CustomScene, item: HTMLElement, canvas: HTMLCanvasElement, mark: HTMLElement, key:
   * string }>}
   */
  #shown = new Map();
  /** Ends the showing of what was kept before. */
  #stop = new AbortController();
  #thumbnails = new LazyThumbnails((context, canvas) => {
    const scene = this.#sceneOf.get(canvas);
    if (scene) paintThumbnail(context, scene, this.#dark);
  });

  /**
   * @param {import("../storage/progress.js").Progress} progress
   * @param {(scene: string) => void} navigate shows the custom puzzle of a link's text
   */
  constructor(progress, navigate) {
    this.#progress = progress;
    this.#navigate = navigate;
    const input = byId(document, "custom-file", HTMLInputElement);
    byId(document, "custom-open").addEventListener("click", () => input.click());
    byId(document, "custom-save").addEventListener("click", () =>
      savePuzzles(this.#store.scenes.filter((scene) => pathlight.sceneProblems(scene).length === 0)),
    );
    input.addEventListener("change", () => {
      this.#open(Array.from(input.files ?? []));
      input.value = "";
    });
    document.addEventListener("dragover", (event) => holdsFiles(event) && event.preventDefault());
    document.addEventListener("drop", (event) => {
      if (!holdsFiles(event) || event.defaultPrevented) return;
      event.preventDefault();
      this.#open(Array.from(event.dataTransfer?.files ?? []));
    });
    this.#store.addEventListener("change", () => this.#update());
    progress.addEventListener("change", () => this.#mark());
    this.#update();
  }

  /** @param {boolean} dark */
  setTheme(dark) {
    this.#dark = dark;
    this.#thumbnails.redraw();
  }

  /** @param {State} state */
  setState({ model, hide }) {
    this.#state = { model, hide };
    for (const link of this.#list.querySelectorAll("a")) if (link.dataset.scene) this.#setHref(link);
  }

  /**
   * Opens the puzzle of a file; several go to the grid.
   * @param {File[]} files
   */
  async #open(files) {
    if (this.#state.hide.includes("puzzles")) return showNotice(text.page.custom.hidden);
    const name = files.length === 1 ? files[0].name : text.page.files.several(files.length);
    const read = await readChosen(name, async (slices) => {
      const scenes = [];
      for (const file of files) scenes.push(await readPuzzles(file, slices));
      return scenes.flat();
    });
    if (!read) return;
    if (read.length === 1) return this.#navigate(await textOfScene(read[0]));
    const { added, left, failure } = this.#store.add(read);
    showNotice(failure ?? keptWords(added, read.length - added - left, left));
  }

  /** Shows the puzzles that are kept; those that are new in slices, as many may have come from a file. */
  async #update() {
    this.#stop.abort();
    const { signal } = (this.#stop = new AbortController());
    const kept = new Map(this.#store.scenes.map((scene) => [JSON.stringify(scene), scene]));
    for (const [json, { item, canvas }] of this.#shown) {
      if (kept.has(json)) continue;
      const beside = item.nextElementSibling ?? item.previousElementSibling;
      passFocus(item, beside ? find(beside, "button") : byId(document, "custom-open"));
      item.remove();
      this.#thumbnails.remove(canvas);
      this.#shown.delete(json);
    }
    byId(document, "custom-empty").hidden = kept.size > 0;
    byId(document, "custom-save").hidden = kept.size === 0;
    try {
      await inSlices(this.#showing(kept), { signal });
    } catch (error) {
      if (!signal.aborted) throw error;
    }
  }

  /** @param {Map<string, CustomScene>} kept */
  *#showing(kept) {
    for (const [json, scene] of kept) {
      if (!this.#shown.has(json) && pathlight.sceneProblems(scene).length === 0)
        this.#shown.set(json, this.#show(scene));
      yield this.#shown.size / kept.size;
    }
    this.#mark();
  }

  /** Says under each puzzle how it went. */
  #mark() {
    if (this.#shown.size === 0) return;
    const made = grouped(
      this.#progress.ofCustomScenes.filter(({ by }) => by === PLAYER),
      ({ puzzle }) => puzzle,
    );
    for (const { mark, key } of this.#shown.values()) mark.textContent = wordsOf(made.get(key) ?? []);
  }

  /** @param {HTMLAnchorElement} link whose scene's text is known */
  #setHref(link) {
    link.href = `#${formatFragment({ ...INITIAL_STATE, ...this.#state, scene: link.dataset.scene ?? null })}`;
  }

  /**
   * Adds a puzzle to the grid.
   * @param {CustomScene} scene
   */
  #show(scene) {
    const canvas = this.#thumbnails.add(SIDE);
    this.#sceneOf.set(canvas, scene);
    const title = document.createElement("strong");
    title.textContent = sceneName(scene);
    const mark = document.createElement("em");
    const link = document.createElement("a");
    link.append(canvas, title, mark);
    textOfScene(scene).then((linked) => {
      link.dataset.scene = linked;
      this.#setHref(link);
    });
    const remove = createButton(text.page.custom.remove, () => this.#remove(scene));
    remove.setAttribute("aria-label", text.page.custom.removeNamed(sceneName(scene)));
    const item = document.createElement("li");
    item.append(link, remove);
    this.#list.append(item);
    return { scene, item, canvas, mark, key: puzzleKey(scene) };
  }

  /** @param {CustomScene} scene */
  #remove(scene) {
    const failure = this.#store.remove(scene);
    if (failure) return showNotice(failure);
    const key = puzzleKey(scene);
    const attempts = this.#progress.attemptsAt(key);
    // One that is the same but for its name has the same attempts.
    if (![...this.#shown.values()].some((shown) => shown.key === key)) this.#progress.forget(key);
    const { removed, undo } = text.page.custom;
    showNotice(removed(sceneName(scene)), [[undo, () => this.#bringBack(scene, attempts)]]);
  }

  /**
   * @param {CustomScene} scene
   * @param {import("../storage/attempt-lines.js").KeptAttempt[]} attempts
   */
  #bringBack(scene, attempts) {
    const { failure } = this.#store.add([scene]);
    if (failure) return showNotice(failure);
    atOnce(this.#progress.merging(attempts));
    showNotice(text.page.custom.back(sceneName(scene)));
  }
}

/**
 * What became of the puzzles of a file.
 * @param {number} added
 * @param {number} known those that were there already
 * @param {number} left those for which there is no room
 */
function keptWords(added, known, left) {
  const words = text.page.custom;
  const sentences = [];
  if (added > 0) sentences.push(words.kept(added));
  if (known > 0) sentences.push(words.known(known));
  if (left > 0) sentences.push(words.left(left, MOST_PUZZLES));
  return sentences.join(" ");
}

/**
 * How a puzzle went for the player; nothing if it was not tried.
 * @param {import("../storage/attempt-lines.js").KeptAttempt[]} attempts
 */
function wordsOf(attempts) {
  if (attempts.length === 0) return "";
  const { solved, missed } = text.page.custom;
  return (attempts.some(({ ending }) => ending.solved) ? solved : missed)(attempts.length);
}

/** @param {DragEvent} event */
function holdsFiles({ dataTransfer }) {
  return dataTransfer?.types.includes("Files") ?? false;
}
