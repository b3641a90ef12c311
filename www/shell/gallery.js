// The grid of templates, each with the scene of its first puzzle and what has been solved of it.

import { Pictures } from "./lazy-thumbnails.js";

/** Width of a picture, CSS px; the style sheet may show it smaller. */
const SIDE = 176;

export class Gallery {
  #pictures;
  #marks = {};
  #links = [];
  #dark = false;

  /** `templates`: as the wasm lists them. */
  constructor(list, wasm, templates) {
    this.#pictures = new Pictures((canvas) => wasm.paintThumbnail(canvas.getContext("2d"), canvas.dataset.task, this.#dark));
    list.replaceChildren(...templates.map((template) => this.#item(template)));
  }

  set dark(dark) {
    this.#dark = dark;
    this.#pictures.redraw();
  }

  /** Leads to the first puzzle of each template. `address`: that of a task. */
  link(address) {
    for (const link of this.#links) link.href = address(link.dataset.task);
  }

  /** Says under a template what has been solved of it. */
  mark(id, words) {
    this.#marks[id].textContent = words;
  }

  #item({ id, name, story, tasks: [first] }) {
    const link = document.createElement("a");
    link.dataset.task = first;
    this.#links.push(link);
    const canvas = this.#pictures.add(SIDE);
    canvas.dataset.task = first;
    const title = document.createElement("strong");
    title.textContent = name;
    const text = document.createElement("span");
    text.textContent = story;
    const mark = document.createElement("em");
    this.#marks[id] = mark;
    link.append(canvas, title, text, mark);
    const item = document.createElement("li");
    item.append(link);
    return item;
  }
}
