// A strip with a mark for each ball of a model's: the higher, the longer the green object touched its goal. A click
// chooses the ball under the pointer; keys use the slider beside it.

import { GOAL_SECONDS, STEPS_PER_SECOND } from "../shell/constants.js";
import { outcomeOf } from "../model/outcomes.js";

/** @typedef {import("../pkg/pathlight.js").TriedProposal} TriedProposal */

/** The height of a mark without a touch, and of the shortest touch, percent. */
const LEAST = { missed: 18, touched: 34 };

export class OutcomeStrip {
  #element;
  /** @type {TriedProposal[]} */
  #shown = [];

  /**
   * @param {HTMLElement} element
   * @param {(number: number) => void} onChoose called with the number of a ball, from 1
   */
  constructor(element, onChoose) {
    this.#element = element;
    const choose = (/** @type {PointerEvent} */ { clientX }) => {
      const { left, width } = element.getBoundingClientRect();
      const index = Math.floor(((clientX - left) / width) * this.#shown.length);
      onChoose(Math.min(Math.max(index, 0), this.#shown.length - 1) + 1);
    };
    element.addEventListener("pointerdown", (event) => {
      element.setPointerCapture(event.pointerId);
      choose(event);
    });
    element.addEventListener("pointermove", (event) => element.hasPointerCapture(event.pointerId) && choose(event));
  }

  /** @param {TriedProposal[]} tried */
  show(tried) {
    if (tried === this.#shown) return;
    this.#shown = tried;
    this.#element.replaceChildren(...tried.map(markOf));
  }

  /** @param {number | null} number of the ball that is looked at, from 1 */
  select(number) {
    for (const mark of this.#element.querySelectorAll("[data-current]")) mark.removeAttribute("data-current");
    if (number !== null) this.#element.children[number - 1]?.setAttribute("data-current", "");
  }
}

/** @param {TriedProposal} tried */
function markOf(tried) {
  const outcome = outcomeOf(tried);
  const touched = Math.min(tried.ending.longest_touch / (GOAL_SECONDS * STEPS_PER_SECOND), 1);
  const height =
    outcome === "solved" ? 100 : outcome === "touched" ? LEAST.touched + (80 - LEAST.touched) * touched : LEAST.missed;
  const mark = document.createElement("span");
  mark.dataset.outcome = outcome;
  mark.style.setProperty("--height", `${height.toFixed(0)}%`);
  return mark;
}
