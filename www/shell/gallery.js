// The grid of templates, each with the scene of its first puzzle and what has been solved of it.

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

  /**
   * @param {HTMLElement} list
   * @param {Template[]} templates
   */
  constructor(list, templates) {
    list.replaceChildren(...templates.map((template) => this.#item(template)));
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
    const link = document.createElement("a");
    link.append(canvas, title, text, mark);
    this.#links.push({ link, task: first });
    const item = document.createElement("li");
    item.append(link);
    return item;
  }
}
