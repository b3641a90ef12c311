// What the home page offers above the kinds of puzzles: the puzzle of the day, one that the model does not solve,
// watching it learn, and making one.

import { find } from "../widgets/dom.js";
import { LazyThumbnails } from "../widgets/lazy-thumbnails.js";
import { paintThumbnail } from "../widgets/scene-thumbnail.js";
import { difficultyName, solveRateOf } from "../puzzles/difficulty.js";
import { puzzleName } from "../puzzles/puzzle-name.js";
import { hrefOf, pageViewHref } from "../state/links.js";
import { LEARNT_TASK, MADE_FROM } from "../home/home-tasks.js";
import { text } from "../text/text.js";
import { taskOfDay } from "./daily.js";

/** @typedef {import("../widgets/gallery.js").Template} Template */

/** Width of a picture, CSS px. */
const SIDE = 96;

export class Picks {
  #tasks;
  #progress;
  #dark = false;
  #thumbnails = new LazyThumbnails((context, { dataset }) => paintThumbnail(context, dataset.task ?? "", this.#dark));
  /**
   * By model, the puzzles that it does not solve, the easiest first.
   * @type {Record<string, string[]>}
   */
  #unsolved = {};

  /**
   * @param {Template[]} templates
   * @param {import("../storage/author-progress.js").AuthorProgress} progress the person’s
   */
  constructor(templates, progress) {
    this.#progress = progress;
    this.#tasks = templates.flatMap(({ tasks }) => tasks);
  }

  /** @param {boolean} dark */
  setTheme(dark) {
    this.#dark = dark;
    this.#thumbnails.redraw();
  }

  /** @param {Record<string, string[]>} unsolved */
  setUnsolved(unsolved) {
    this.#unsolved = unsolved;
  }

  /** @param {import("../state/url-state.js").State} state */
  update(state) {
    const words = text.home.picks;
    const today = new Date();
    const daily = taskOfDay(today, this.#tasks);
    const facts = words.dayFacts(text.page.day(today), factsOf(daily));
    this.#show("day", words.day, facts, daily, hrefOf(state, daily));
    const unsolved = this.#unsolvedBy(state.model);
    if (unsolved)
      this.#show("unsolved", words.unsolved, words.canYou(factsOf(unsolved)), unsolved, hrefOf(state, unsolved));
    this.#show("learns", words.learns, words.learnsFacts, LEARNT_TASK, pageViewHref("learns", state));
    this.#show("make", words.make, words.makeFacts, MADE_FROM, hrefOf(state, MADE_FROM, "make"));
  }

  /**
   * The easiest puzzle that neither the model nor the person has solved; undefined if none is known.
   * @param {string | null} model null for the first
   */
  #unsolvedBy(model) {
    const known = model !== null && Object.hasOwn(this.#unsolved, model) ? this.#unsolved[model] : null;
    const unsolved = known ?? Object.values(this.#unsolved)[0] ?? [];
    return unsolved.find((task) => this.#progress.of(task).solved === null) ?? unsolved[0];
  }

  /**
   * Shows a puzzle on its card.
   * @param {string} name the card’s
   * @param {string} title
   * @param {string} detail
   * @param {string} task
   * @param {string | null} href
   */
  #show(name, title, detail, task, href) {
    const link = find(document, `#picks [data-pick=${name}] a`, HTMLAnchorElement);
    link.href = href ?? "#";
    if (link.dataset.task !== task) {
      link.dataset.task = task;
      const old = link.querySelector("canvas");
      if (old) this.#thumbnails.remove(old);
      const canvas = this.#thumbnails.add(SIDE);
      canvas.dataset.task = task;
      const words = document.createElement("span");
      words.append(line("strong", title), line("span", detail));
      link.replaceChildren(canvas, words);
    }
    find(document, `#picks [data-pick=${name}]`, HTMLElement).hidden = href === null;
  }
}

/**
 * A puzzle’s name and how hard it is.
 * @param {string} task
 */
function factsOf(task) {
  return text.home.picks.facts(puzzleName(task), difficultyName(solveRateOf(task)));
}

/**
 * @param {string} tag
 * @param {string} words
 */
function line(tag, words) {
  const element = document.createElement(tag);
  element.textContent = words;
  return element;
}
