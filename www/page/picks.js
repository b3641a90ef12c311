// What the grid offers above its templates: the introduction on a first visit, and the puzzle of the day.

import { byId } from "../shell/dom.js";
import { difficultyName, solveRateOf } from "../shell/difficulty.js";
import { guideOffered, rememberGuide } from "../shell/progress-store.js";
import { puzzleName } from "../shell/puzzle-name.js";
import { dayWords, taskOfDay } from "./daily.js";

/** @typedef {import("../shell/gallery.js").Template} Template */

/** The puzzle of the introduction: of all, the one that most balls solve and that does not solve itself. */
export const FIRST_TASK = "00000:088";

export class Picks {
  #tasks;

  /**
   * @param {Template[]} templates
   * @param {boolean} played has the person tried a puzzle in this browser?
   * @param {() => void} startGuide
   */
  constructor(templates, played, startGuide) {
    this.#tasks = templates.flatMap(({ tasks }) => tasks);
    const welcome = byId(document, "welcome");
    welcome.hidden = played || guideOffered();
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

  /** @param {(task: string) => string | null} hrefOf */
  update(hrefOf) {
    const today = new Date();
    const task = taskOfDay(today, this.#tasks);
    byId(document, "picks").replaceChildren(this.#item("Puzzle of the day", dayWords(today), task, hrefOf));
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
    const name = document.createElement("strong");
    name.textContent = title;
    const words = document.createElement("span");
    words.textContent = `${detail}: ${puzzleName(task)}, ${difficultyName(solveRateOf(task))}`;
    link.append(name, words);
    const item = document.createElement("li");
    item.append(link);
    return item;
  }
}
