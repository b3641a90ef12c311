// What came of the puzzles that were played, as a chart and as a list in words.

import { ATTEMPT_LIMIT } from "../shell/constants.js";
import { text } from "../text/text.js";
import { byId } from "../widgets/dom.js";
import { learnsChart } from "./learns-chart.js";
import { playedWords } from "./learns-words.js";

/** @typedef {import("./learns-words.js").Played} Played */

export class LearnsList {
  #hrefOf;
  /** @type {Played[]} */
  #shown = [];

  /** @param {(task: string) => string | null} hrefOf the address of a task; null if the link hides it */
  constructor(hrefOf) {
    this.#hrefOf = hrefOf;
  }

  /** @param {Played[]} all */
  show(all) {
    byId(document, "learns-chart").replaceChildren(learnsChart(all, ATTEMPT_LIMIT));
    const list = byId(document, "learns-list");
    // Those that are there stay, so that a screen reader does not lose its place.
    const isLonger = this.#shown.every((played, index) => played === all[index]);
    if (!isLonger) list.replaceChildren();
    list.append(...all.slice(isLonger ? this.#shown.length : 0).map((played) => this.#item(played, all)));
    byId(document, "learns-puzzles").hidden = all.length === 0;
    this.#shown = all;
  }

  /**
   * @param {Played} played
   * @param {Played[]} all
   */
  #item(played, all) {
    const index = all.indexOf(played);
    const href = this.#hrefOf(played.task);
    const name = document.createElement(href ? "a" : "span");
    if (href) name.setAttribute("href", href);
    name.textContent = text.learns.puzzle(index + 1);
    const earlier = all.slice(0, index).map(({ task }) => task);
    const item = document.createElement("li");
    item.append(name, `: ${playedWords(played, earlier, ATTEMPT_LIMIT)}`);
    return item;
  }
}
