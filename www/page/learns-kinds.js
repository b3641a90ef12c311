// The kinds of puzzles that are new to the model, as pictures to choose from.

import { LazyThumbnails } from "../widgets/lazy-thumbnails.js";
import { paintThumbnail } from "../widgets/scene-thumbnail.js";

/**
 * A template, and those of its tasks that the model has never seen.
 * @typedef {{ id: string, name: string, tasks: string[] }} Kind
 */

const darkScheme = matchMedia("(prefers-color-scheme: dark)");
/** Width of a picture, CSS px. */
const SIDE = 72;

export class LearnsKinds {
  #list;
  #onChange;
  /** @type {Kind[]} */
  #kinds = [];
  #chosen = 0;
  #thumbnails = new LazyThumbnails((context, { dataset }) =>
    paintThumbnail(context, dataset.task ?? "", darkScheme.matches),
  );

  /**
   * @param {HTMLElement} list
   * @param {() => void} onChange another was chosen
   */
  constructor(list, onChange) {
    this.#list = list;
    this.#onChange = onChange;
    darkScheme.addEventListener("change", () => this.#thumbnails.redraw());
  }

  get chosen() {
    return this.#kinds[this.#chosen];
  }

  /**
   * @param {Kind[]} kinds those without tasks are left out
   * @param {string} first a task of the one that is chosen at first
   */
  show(kinds, first) {
    this.#kinds = kinds.filter(({ tasks }) => tasks.length > 0);
    this.#chosen = Math.max(
      this.#kinds.findIndex(({ id }) => first.startsWith(id)),
      0,
    );
    this.#thumbnails.clear();
    this.#list.replaceChildren(...this.#kinds.map((kind, index) => this.#choice(kind, index)));
  }

  /**
   * @param {Kind} kind
   * @param {number} index
   */
  #choice({ name, tasks: [task] }, index) {
    const input = document.createElement("input");
    Object.assign(input, { type: "radio", name: "learns-kind", checked: index === this.#chosen });
    input.addEventListener("change", () => {
      this.#chosen = index;
      this.#onChange();
    });
    const canvas = this.#thumbnails.add(SIDE);
    canvas.dataset.task = task;
    const [label, words] = ["label", "span"].map((tag) => document.createElement(tag));
    words.textContent = label.title = name;
    label.append(input, canvas, words);
    return label;
  }
}
