// The grid of templates, each with the scene of its first puzzle, how hard its puzzles are, and what has been solved of it.

import { difficultyName, solveRateOf } from "./difficulty.js";
import { LazyThumbnails } from "./lazy-thumbnails.js";
import { pathlight } from "./pathlight.js";
import { hrefOf } from "./url-state.js";

/** @typedef {import("../pkg/pathlight.js").Template} Template */

/** Width of a picture, CSS px; the style sheet may show it smaller. */
const SIDE = 176;

export class Gallery {
  #dark = false;
  #thumbnails = new LazyThumbnails((context, { dataset }) => pathlight.paintScene(context, dataset.task ?? "", { dark: this.#dark }));
  /** @type {Map<string, HTMLElement>} */
  #marks = new Map();
  /** @type {{ link: HTMLAnchorElement, task: string }[]} */
  #links = [];
  #list;
  #templates;
  /**
   * The templates from the easiest to the hardest; null until the grid is seen.
   * @type {Template[] | null}
   */
  #easiestFirst = null;
  #order = "";

  /**
   * @param {HTMLElement} list
   * @param {Template[]} templates
   */
  constructor(list, templates) {
    this.#list = list;
    this.#templates = templates;
    list.replaceChildren(...templates.map((template) => this.#item(template)));
  }

  /**
   * Orders the templates. Also says how hard their puzzles are, for which it asks once: the first puzzle of a page that begins
   * with one need not wait for that.
   * @param {"number" | "difficulty"} order
   */
  order(order) {
    if (order === this.#order) return;
    this.#order = order;
    if (!this.#easiestFirst) {
      const medians = new Map(this.#templates.map(({ id, tasks }) => [id, median(tasks.map(solveRateOf))]));
      const rate = (/** @type {Template} */ { id }) => medians.get(id) ?? 0;
      this.#easiestFirst = this.#templates.toSorted((one, other) => rate(other) - rate(one));
      for (const template of this.#templates) this.#itemOf(template).querySelector("i")?.replaceChildren(`mostly ${difficultyName(rate(template))}`);
    }
    this.#list.append(...(order === "number" ? this.#templates : this.#easiestFirst).map((template) => this.#itemOf(template)));
  }

  /** @param {Template} template */
  #itemOf({ id }) {
    return /** @type {HTMLElement} */ (this.#marks.get(id)?.closest("li"));
  }

  /** @param {boolean} dark */
  setTheme(dark) {
    this.#dark = dark;
    this.#thumbnails.redraw();
  }

  /** @param {import("./url-state.js").State} state */
  setState(state) {
    for (const { link, task } of this.#links) link.href = hrefOf(state, task) ?? "#";
  }

  /**
   * Shows under a template what has been solved of it.
   * @param {string} id
   * @param {string} text
   */
  mark(id, text) {
    const mark = this.#marks.get(id);
    if (mark) mark.textContent = text;
  }

  /** @param {Template} template */
  #item({ id, name, story, tasks: [first] }) {
    const canvas = this.#thumbnails.add(SIDE);
    canvas.dataset.task = first;
    const title = document.createElement("strong");
    title.textContent = name;
    const text = document.createElement("span");
    text.textContent = story;
    const mark = document.createElement("em");
    this.#marks.set(id, mark);
    const difficulty = document.createElement("i");
    const link = document.createElement("a");
    link.append(canvas, title, text, difficulty, mark);
    this.#links.push({ link, task: first });
    const item = document.createElement("li");
    item.append(link);
    return item;
  }
}

/** @param {number[]} values */
function median(values) {
  return values.toSorted((one, other) => one - other)[values.length >> 1];
}
