// The person's own puzzles in the grid, beside the templates: each with a picture, its name and a button that deletes it; files
// are opened by a button or dropped anywhere in the page, and all puzzles are saved in one.

import { LazyThumbnails } from "../shell/lazy-thumbnails.js";
import { byId, createButton } from "../shell/dom.js";
import { showNotice } from "../shell/notice.js";
import { pathlight } from "../shell/pathlight.js";
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
  #navigate;
  #dark = false;
  /** @type {Pick<State, "model" | "hide">} */
  #state = INITIAL_STATE;
  /** @type {WeakMap<HTMLCanvasElement, OwnScene>} */
  #sceneOf = new WeakMap();
  #thumbnails = new LazyThumbnails((context, canvas) => {
    const scene = this.#sceneOf.get(canvas);
    if (scene) pathlight.paintScene(context, scene, { dark: this.#dark });
  });

  /** @param {(scene: string) => void} navigate shows the own puzzle of a link's text */
  constructor(navigate) {
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
    if (this.#state.hide.includes("puzzles")) return showNotice("This link shows one puzzle alone, so no file is opened here.");
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
    this.#list.replaceChildren(...scenes.map((scene) => this.#item(scene)));
    byId(document, "own-empty").hidden = scenes.length > 0;
    byId(document, "own-save").hidden = scenes.length === 0;
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
    const link = document.createElement("a");
    link.append(canvas, title);
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
    if (failure) showNotice(failure);
    else showNotice(`“${sceneName(scene)}” is deleted.`, [["Undo", () => showNotice(this.#store.add([scene]) ?? `“${sceneName(scene)}” is back.`)]]);
  }
}

/** @param {DragEvent} event */
function holdsFiles({ dataTransfer }) {
  return dataTransfer?.types.includes("Files") ?? false;
}
