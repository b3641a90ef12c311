// Loads the puzzle of an element into its shadow tree. Until it is there, and when it cannot be loaded, a placeholder
// stands in its place.

import { afterFrame } from "../loading/after-frame.js";
import { loadWasm } from "../loading/load-wasm.js";
import { nextTask } from "../loading/next-task.js";
import { useLanguage } from "../text/text.js";
import { puzzleMarkup } from "./markup.js";
import { Placeholder, placeholderSheet } from "./placeholder.js";
import { loadStyleSheets } from "./style-sheets.js";

/** @typedef {import("./controller.js").PuzzleController} PuzzleController */
/** @typedef {import("./pathlight-puzzle.js").HrefOf} HrefOf */

/**
 * Frames that a page has for itself before a puzzle with nothing to show is made: its first pictures are in the
 * second.
 */
const FRAMES_FOR_THE_PAGE = 3;

export class PuzzleLoader {
  #root;
  #options;
  #placeholder = new Placeholder();
  /** Is the puzzle on its way, there, or failed? */
  #begun = false;
  #failed = false;

  /**
   * @param {ShadowRoot} root
   * @param {object} options
   * @param {() => boolean} options.remembers are the attempts kept in this browser?
   * @param {() => HrefOf | null} options.hrefOf
   * @param {(controller: PuzzleController) => void} options.onLoad
   */
  constructor(root, options) {
    this.#root = root;
    this.#options = options;
    root.adoptedStyleSheets = [placeholderSheet];
    root.append(this.#placeholder.element);
  }

  /**
   * Starts what the puzzle waits for longest. One with nothing to show leaves the page some frames for its own first
   * picture.
   * @param {() => boolean} isWanted
   */
  async prepare(isWanted) {
    const sheets = loadStyleSheets();
    // `#load` handles what becomes of them.
    sheets.catch(() => {});
    await Promise.allSettled([loadWasm(), sheets]);
    for (let frame = 0; frame < FRAMES_FOR_THE_PAGE; frame += 1) await afterFrame();
    if (isWanted()) this.load();
  }

  /** Loads the puzzle, unless that has begun. */
  load() {
    if (!this.#begun) this.#load();
  }

  /** A puzzle that has failed may be loaded again. */
  forgetFailure() {
    if (this.#failed) this.#begun = this.#failed = false;
  }

  async #load() {
    this.#begun = true;
    let controller;
    try {
      // A page has one language: its own, or else the browser's.
      const words = useLanguage(document.documentElement.lang || null, ...navigator.languages);
      const [module, sheets] = await Promise.all([loadWasm(), loadStyleSheets(), words]);
      const [{ PuzzleController }, { sharedProgress }] = await Promise.all([
        import("./controller.js"),
        import("../storage/progress.js"),
      ]);
      this.#root.adoptedStyleSheets = [placeholderSheet, ...sheets];
      this.#root.append(puzzleMarkup());
      await nextTask();
      const progress = sharedProgress(this.#options.remembers() ? "kept" : "forgotten");
      controller = new PuzzleController(this.#root, module, progress, this.#options.hrefOf);
    } catch (error) {
      const { code, message } = /** @type {Error & { code?: string }} */ (error);
      this.#failed = true;
      this.#placeholder.showFailure(message, () => this.#loadAgain());
      this.#root.replaceChildren(this.#placeholder.element);
      // An error without a code is a bug of ours.
      if (!code) reportError(error);
      return false;
    }
    this.#placeholder.element.remove();
    this.#options.onLoad(controller);
    return true;
  }

  async #loadAgain() {
    this.#placeholder.showLoading();
    // The focus was on the button that has gone.
    if (await this.#load()) this.#root.getElementById("scene")?.focus();
    else this.#placeholder.focus();
  }
}
