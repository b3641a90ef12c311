// What the grid offers above its templates: the introduction on a first visit, the puzzle of the day, and the puzzles
// that the model does not solve.

import { readResults } from "../model/results.js";
import { byId, createButton } from "../widgets/dom.js";
import { difficultyName, solveRateOf } from "../puzzles/difficulty.js";
import { showNotice } from "../widgets/notice.js";
import { puzzleName } from "../puzzles/puzzle-name.js";
import { guideOffered, rememberGuide } from "../storage/guide.js";
import { dayWords, taskOfDay } from "./daily.js";

/** @typedef {import("../widgets/gallery.js").Template} Template */

/** The puzzle of the introduction: of all, the one that most balls solve and that does not solve itself. */
export const FIRST_TASK = "00000:088";

export class Picks {
  #tasks;
  #progress;
  #open;
  #stump = createButton("", () => this.#openUnsolved());
  /** @type {string | null} */
  #model = null;

  /**
   * @param {Template[]} templates
   * @param {import("../storage/author.js").Author} progress the person’s
   * @param {(task: string) => void} open goes to a puzzle
   * @param {() => void} startGuide
   */
  constructor(templates, progress, open, startGuide) {
    this.#progress = progress;
    this.#open = open;
    this.#stump.append(
      line("strong", "Stump the model"),
      line("span", "A puzzle that it does not solve in a hundred attempts"),
    );
    this.#tasks = templates.flatMap(({ tasks }) => tasks);
    const welcome = byId(document, "welcome");
    welcome.hidden = progress.tasks.length > 0 || guideOffered();
    const answer = () => {
      rememberGuide();
      welcome.hidden = true;
    };
    byId(document, "welcome-start").addEventListener("click", () => {
      answer();
      startGuide();
    });
    byId(document, "welcome-skip").addEventListener("click", answer);
  }

  /**
   * @param {string | null} model the one that is to be stumped; null for the first
   * @param {(task: string) => string | null} hrefOf
   */
  update(model, hrefOf) {
    this.#model = model;
    const today = new Date();
    const stump = document.createElement("li");
    stump.dataset.hideable = "imagine compare";
    stump.append(this.#stump);
    byId(document, "picks").replaceChildren(
      this.#item("Puzzle of the day", dayWords(today), taskOfDay(today, this.#tasks), hrefOf),
      stump,
    );
  }

  /** Opens the easiest puzzle that neither the model nor the person has solved. */
  async #openUnsolved() {
    try {
      const models = await readResults();
      // The person has gone on meanwhile.
      if (byId(document, "gallery").hidden) return;
      const {
        tasks,
        first_solved: { online },
      } = models.find(({ name }) => name === this.#model) ?? models[0];
      const unsolved = tasks
        .filter((_, index) => online[index] === null)
        .toSorted((one, other) => solveRateOf(other) - solveRateOf(one));
      this.#open(unsolved.find((task) => this.#progress.of(task).solved === null) ?? unsolved[0]);
    } catch (error) {
      showNotice(/** @type {Error} */ (error).message);
    }
  }

  /**
   * @param {string} title
   * @param {string} detail
   * @param {string} task
   * @param {(task: string) => string | null} hrefOf
   */
  #item(title, detail, task, hrefOf) {
    const link = document.createElement("a");
    link.href = hrefOf(task) ?? "#";
    link.append(
      line("strong", title),
      line("span", `${detail}: ${puzzleName(task)}, ${difficultyName(solveRateOf(task))}`),
    );
    const item = document.createElement("li");
    item.append(link);
    return item;
  }
}

/**
 * @param {string} tag
 * @param {string} text
 */
function line(tag, text) {
  const element = document.createElement(tag);
  element.textContent = text;
  return element;
}
