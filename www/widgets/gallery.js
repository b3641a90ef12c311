// The grid of templates, each with the scene of its first puzzle, how hard its puzzles are, and what has been solved of
// it.

import { difficultyName, solveRateOf } from "../puzzles/difficulty.js";
import { LazyThumbnails } from "./lazy-thumbnails.js";
import { pathlight } from "../shell/page-api.js";
import { hrefOf } from "../state/url-state.js";

/** @typedef {import("../pkg/pathlight.js").Template} Template */

/**
 * A template in the grid; `rate` is the median of its tasks' solve rates.
 * @typedef {{ element: HTMLElement, link: HTMLAnchorElement, mark: HTMLElement, rate: number }} Item
 */

/** Width of a picture, CSS px; the style sheet may show it smaller. */
const SIDE = 176;

export class Gallery {
  #dark = false;
  #thumbnails = new LazyThumbnails((context, { dataset }) =>
    pathlight.paintScene(context, dataset.task ?? "", { dark: this.#dark }),
  );
  #list;
  #templates;
  /**
   * The templates with their items, made when the grid is first seen.
   * @type {Map<Template, Item>}
   */
  #items = new Map();
  /**
   * What has been solved of each template, in words.
   * @type {Map<string, string>}
   */
  #marks = new Map();
  /** @type {(task: string) => string | null} */
  #hrefOf = () => null;
  #order = "";

  /**
   * @param {HTMLElement} list
   * @param {Template[]} templates
   */
  constructor(list, templates) {
    this.#list = list;
    this.#templates = templates;
  }

  /**
   * Shows the templates in an order.
   * @param {"number" | "difficulty"} order
   */
  show(order) {
    if (order === this.#order) return;
    this.#order = order;
    if (this.#items.size === 0)
      this.#items = new Map(this.#templates.map((template) => [template, this.#item(template)]));
    const items = Array.from(this.#items.values());
    this.#list.append(
      ...(order === "number" ? items : items.toSorted((one, other) => other.rate - one.rate)).map(
        ({ element }) => element,
      ),
    );
  }

  /** @param {boolean} dark */
  setTheme(dark) {
    this.#dark = dark;
    this.#thumbnails.redraw();
  }

  /** @param {import("../state/url-state.js").State} state */
  setState(state) {
    this.#hrefOf = (task) => hrefOf(state, task);
    for (const [
      {
        tasks: [first],
      },
      { link },
    ] of this.#items)
      link.href = this.#hrefOf(first) ?? "#";
  }

  /**
   * Shows under a template what has been solved of it.
   * @param {Template} template
   * @param {string} text
   */
  mark(template, text) {
    this.#marks.set(template.id, text);
    const item = this.#items.get(template);
    if (item) item.mark.textContent = text;
  }

  /**
   * @param {Template} template
   * @returns {Item}
   */
  #item({ id, name, story, tasks }) {
    const [first] = tasks;
    const rate = median(tasks.map(solveRateOf));
    const canvas = this.#thumbnails.add(SIDE);
    canvas.dataset.task = first;
    const title = document.createElement("strong");
    title.textContent = name;
    const text = document.createElement("span");
    text.textContent = story;
    const mark = document.createElement("em");
    mark.textContent = this.#marks.get(id) ?? "";
    const difficulty = document.createElement("i");
    difficulty.textContent = `mostly ${difficultyName(rate)}`;
    const link = document.createElement("a");
    link.href = this.#hrefOf(first) ?? "#";
    link.append(canvas, title, text, difficulty, mark);
    const element = document.createElement("li");
    element.append(link);
    return { element, link, mark, rate };
  }
}

/** @param {number[]} values */
function median(values) {
  return values.toSorted((one, other) => one - other)[values.length >> 1];
}
