// The grid of templates, each with the scene of its first puzzle, how hard its puzzles are, and what has been solved of
// it. Under the pointer and with the focus, it shows the path that a model imagines there.

import { difficultyName, solveRateOf } from "../puzzles/difficulty.js";
import { LazyThumbnails } from "./lazy-thumbnails.js";
import { paintThumbnail } from "./scene-thumbnail.js";
import { SCENE_SIZE } from "../shell/constants.js";
import { hrefOf } from "../state/links.js";
import { text } from "../text/text.js";

/** @typedef {import("../pkg/pathlight.js").Template} Template */

/**
 * A template in the grid; `rate` is the median of its tasks' solve rates.
 * @typedef {{ element: HTMLElement, link: HTMLAnchorElement, mark: HTMLElement, rate: number }} Item
 */

/** Width of a picture, CSS px; the style sheet may show it smaller. */
const SIDE = 176;
const SVG = "http://www.w3.org/2000/svg";

export class Gallery {
  #dark = false;
  #thumbnails = new LazyThumbnails((context, { dataset }) => paintThumbnail(context, dataset.task ?? "", this.#dark));
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
   * Imagined paths by template: x, y, x, y, …
   * @type {Record<string, number[]>}
   */
  #paths = {};

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

  /** @param {Record<string, number[]>} paths by template */
  setPaths(paths) {
    if (paths === this.#paths) return;
    this.#paths = paths;
    for (const [{ id }, { link }] of this.#items) this.#addPath(link, id);
  }

  /**
   * @param {HTMLElement} link
   * @param {string} id
   */
  #addPath(link, id) {
    const path = this.#paths[id];
    if (path) link.querySelector(".picture")?.append(pathPicture(path));
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
   * @param {string} words
   */
  mark(template, words) {
    this.#marks.set(template.id, words);
    const item = this.#items.get(template);
    if (item) item.mark.textContent = words;
  }

  /**
   * @param {Template} template
   * @returns {Item}
   */
  #item({ id, name, tasks }) {
    const [first] = tasks;
    const rate = median(tasks.map(solveRateOf));
    const canvas = this.#thumbnails.add(SIDE);
    canvas.dataset.task = first;
    const title = document.createElement("strong");
    title.textContent = name;
    const picture = document.createElement("span");
    picture.className = "picture";
    picture.append(canvas);
    const mark = document.createElement("em");
    mark.textContent = this.#marks.get(id) ?? "";
    const difficulty = document.createElement("i");
    difficulty.textContent = text.page.widgets.mostly(difficultyName(rate));
    const link = document.createElement("a");
    link.href = this.#hrefOf(first) ?? "#";
    link.append(picture, title, difficulty, mark);
    this.#addPath(link, id);
    const element = document.createElement("li");
    element.append(link);
    return { element, link, mark, rate };
  }
}

/**
 * A path to lie over a picture of its scene.
 * @param {number[]} path x, y, x, y, … in px of the scene
 */
function pathPicture(path) {
  const svg = document.createElementNS(SVG, "svg");
  svg.setAttribute("viewBox", `0 0 ${SCENE_SIZE} ${SCENE_SIZE}`);
  svg.setAttribute("class", "imagined");
  svg.setAttribute("aria-hidden", "true");
  svg.dataset.hideable = "imagine";
  const line = document.createElementNS(SVG, "polyline");
  line.setAttribute("points", path.map((value, index) => (index % 2 ? SCENE_SIZE - value : value)).join(" "));
  // So that the style sheet can draw it from its start without knowing how long it is.
  line.setAttribute("pathLength", "1");
  svg.append(line);
  return svg;
}

/** @param {number[]} values */
function median(values) {
  return values.toSorted((one, other) => one - other)[values.length >> 1];
}
