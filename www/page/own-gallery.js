// The person's own puzzles in the grid, beside the templates: each with a picture, its name, how it went, and a button
// that deletes it with its attempts; files are opened by a button or dropped anywhere in the page, and all puzzles are
// saved in one.

import { puzzleKey } from "../shell/attempt-store.js";
import { LazyThumbnails } from "../shell/lazy-thumbnails.js";
import { byId, createButton } from "../shell/dom.js";
import { showNotice } from "../shell/notice.js";
import { pathlight } from "../shell/page-api.js";
import { sceneName } from "../shell/puzzle-name.js";
import { INITIAL_STATE, formatFragment } from "../shell/url-state.js";
import { ownPuzzles } from "../workshop/own-puzzles.js";
import { readPuzzles, savePuzzles } from "../workshop/puzzle-file.js";
import { textOfScene } from "../workshop/scene-link.js";

/** @typedef {import("../pkg/pathlight.js").OwnScene} OwnScene */
/** @typedef {import("../shell/url-state.js").State} State */

/** Width of a picture, CSS px. */
const SIDE = 176;

export class OwnGallery {
  #store = ownPuzzles();
  #list = byId(document, "own-puzzles");
  #attempts;
  #navigate;
  #dark = false;
  /** @type {Pick<State, "model" | "hide">} */
  #state = INITIAL_STATE;
  /** @type {WeakMap<HTMLCanvasElement, OwnScene>} */
  #sceneOf = new WeakMap();
  /**
   * What says how a puzzle went, with what its attempts are kept under.
   * @type {{ mark: HTMLElement, key: string }[]}
   */
  #marks = [];
  #thumbnails = new LazyThumbnails((context, canvas) => {
    const scene = this.#sceneOf.get(canvas);
    if (scene) pathlight.paintScene(context, scene, { dark: this.#dark });
  });

  /**
   * @param {import("../shell/attempt-store.js").AttemptStore} attempts
   * @param {(scene: string) => void} navigate shows the own puzzle of a link's text
   */
  constructor(attempts, navigate) {
    this.#attempts = attempts;
    this.#navigate = navigate;
    const input = byId(document, "own-file", HTMLInputElement);
    byId(document, "own-open").addEventListener("click", () => input.click());
    byId(document, "own-save").addEventListener("click", () => savePuzzles(this.#store.scenes));
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
    attempts.addEventListener("change", () => this.#mark());
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
    if (this.#state.hide.includes("puzzles"))
      return showNotice("This link shows one puzzle alone, so no file is opened here.");
    try {
      const scenes = (await Promise.all(files.map(readPuzzles))).flat();
      const [first, ...others] = scenes;
      if (first && others.length === 0) return this.#navigate(await textOfScene(first));
      const failure = this.#store.add(scenes);
      showNotice(failure ?? `${scenes.length} puzzles are kept: they are in the grid, after the benchmark’s.`);
    } catch (error) {
      showNotice(/** @type {Error} */ (error).message);
    }
  }

  #update() {
    this.#thumbnails.clear();
    const { scenes } = this.#store;
    this.#marks = [];
    this.#list.replaceChildren(...scenes.map((scene) => this.#item(scene)));
    byId(document, "own-empty").hidden = scenes.length > 0;
    byId(document, "own-save").hidden = scenes.length === 0;
    this.#mark();
  }

  /** Says under each puzzle how it went. */
  #mark() {
    if (this.#marks.length === 0) return;
    const made = Map.groupBy(
      this.#attempts.ofOwnScenes.filter(({ by }) => by === "player"),
      ({ puzzle }) => puzzle,
    );
    for (const { mark, key } of this.#marks) mark.textContent = wordsOf(made.get(key) ?? []);
  }

  /** @param {HTMLAnchorElement} link whose scene's text is known */
  #setHref(link) {
    link.href = `#${formatFragment({ ...INITIAL_STATE, ...this.#state, scene: link.dataset.scene ?? null })}`;
  }

  /** @param {OwnScene} scene */
  #item(scene) {
    const canvas = this.#thumbnails.add(SIDE);
    this.#sceneOf.set(canvas, scene);
    const title = document.createElement("strong");
    title.textContent = sceneName(scene);
    const mark = document.createElement("em");
    this.#marks.push({ mark, key: puzzleKey(scene) });
    const link = document.createElement("a");
    link.append(canvas, title, mark);
    textOfScene(scene).then((text) => {
      link.dataset.scene = text;
      this.#setHref(link);
    });
    const remove = createButton("Delete", () => this.#remove(scene));
    remove.setAttribute("aria-label", `Delete ${sceneName(scene)}`);
    const item = document.createElement("li");
    item.append(link, remove);
    return item;
  }

  /** @param {OwnScene} scene */
  #remove(scene) {
    const failure = this.#store.remove(scene);
    if (failure) return showNotice(failure);
    const key = puzzleKey(scene);
    const attempts = this.#attempts.of(key);
    // One that is the same but for its name has the same attempts.
    if (!this.#store.scenes.some((one) => puzzleKey(one) === key)) this.#attempts.forget(key);
    showNotice(`“${sceneName(scene)}” is deleted.`, [["Undo", () => this.#bringBack(scene, attempts)]]);
  }

  /**
   * @param {OwnScene} scene
   * @param {import("../shell/attempt-store.js").KeptAttempt[]} attempts
   */
  #bringBack(scene, attempts) {
    const failure = this.#store.add([scene]);
    if (failure) return showNotice(failure);
    this.#attempts.take(attempts);
    showNotice(`“${sceneName(scene)}” is back.`);
  }
}

/**
 * How a puzzle went for the player; nothing if it was not tried.
 * @param {import("../shell/attempt-store.js").KeptAttempt[]} attempts
 */
function wordsOf(attempts) {
  if (attempts.length === 0) return "";
  const solved = attempts.some(({ ending }) => ending.solved);
  return `${solved ? "✓ solved" : "× not solved"}, in ${attempts.length} attempt${attempts.length === 1 ? "" : "s"}`;
}

/** @param {DragEvent} event */
function holdsFiles({ dataTransfer }) {
  return dataTransfer?.types.includes("Files") ?? false;
}
