// A list of one author's attempts: for each a small picture and its result in words, a button that replays it, one
// that shows it over another, and, for the player's own, one that deletes it.

import { Component } from "../widgets/component.js";
import { ATTEMPT_LIMIT } from "../shell/constants.js";
import { find, setText } from "../widgets/dom.js";
import { text } from "../text/text.js";
import { LazyThumbnails } from "../widgets/lazy-thumbnails.js";
import { endingWords } from "./ending-words.js";
import { visibleAttempts } from "./shown.js";

/** @typedef {import("./session.js").Session} Session */

/** Width of a picture, CSS px. */
const SIDE = 48;

export class AttemptList extends Component {
  #list;
  #count;
  #author;
  #length = 0;
  #thumbnails = new LazyThumbnails((context, canvas) => {
    this.session?.game.paintAttempt(context, this.#author, numberOf(canvas), this.dark);
  });

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {HTMLElement} list an <ol>
   * @param {HTMLElement} count where the score is shown
   * @param {import("./session.js").Author} author
   */
  constructor(root, list, count, author) {
    super(root);
    this.#list = list;
    this.#count = count;
    this.#author = author;
    list.addEventListener("click", ({ target }) => {
      const button = target instanceof Element && target.closest("button");
      if (button) this.#onAction(button.dataset.act, numberOf(button));
    });
  }

  /** @param {Session} session */
  open(session) {
    super.open(session);
    this.#clear();
    // What has run is listed before another is deleted.
    for (const event of /** @type {const} */ (["attempted", "change"])) this.listen(event, () => this.#update(session));
    this.#update(session);
  }

  close() {
    super.close();
    this.#clear();
  }

  /** @param {boolean} dark */
  setTheme(dark) {
    super.setTheme(dark);
    this.#thumbnails.redraw();
  }

  /**
   * @param {string | undefined} act
   * @param {number} number
   */
  #onAction(act, number) {
    if (act === "replay") this.session?.replay(this.#author, number);
    if (act === "overlay") this.session?.overlay(this.#author, number);
    if (act === "remove") {
      this.session?.remove(this.#author, number);
      // The focus goes to the attempt that has moved up, or to the one before, or where another attempt begins.
      const next = this.#list.children[Math.min(number, this.#length) - 1];
      if (next) find(next, "[data-act=remove]").focus();
      else this.byId("scene").focus({ preventScroll: true });
    }
  }

  #clear() {
    this.#length = 0;
    this.#thumbnails.clear();
    this.#list.replaceChildren();
  }

  /** @param {Session} session */
  #update(session) {
    const standing = session.attempts.standing(this.#author);
    // An attempt that runs for the first time is listed when it has ended.
    const used = standing.used - Number(session.hiddenAuthor === this.#author);
    const isSolved = standing.solved_at !== null && standing.solved_at <= used;
    const solvedAt = isSolved && (this.#author === "player" ? session.attempts.playerTotal : standing).solved_at;
    if (used < this.#length) this.#clear();
    if (used > this.#length) {
      this.#list.append(
        ...session.attempts
          .of(this.#author)
          .slice(this.#length, used)
          .map((attempt) => this.#row(attempt)),
      );
      this.#length = used;
      this.#list.scrollTop = this.#list.scrollHeight;
    }
    setText(
      this.#count,
      used === 0 ? "" : solvedAt ? text.play.attempts.solved(solvedAt) : text.play.attempts.missed(used, ATTEMPT_LIMIT),
    );
    const current = visibleAttempts(session.state)
      .filter(({ author }) => author === this.#author)
      .map(({ number }) => number);
    for (const button of this.#list.querySelectorAll("[data-act=replay]")) {
      if (current.includes(numberOf(button))) button.setAttribute("aria-current", "true");
      else button.removeAttribute("aria-current");
    }
  }

  /** @param {import("./session.js").ListedAttempt} attempt */
  #row({ number, ball: [x, y, r], ending }) {
    const row = this.fromTemplate("attempt-row");
    row.dataset.number = String(number);
    find(row, "b").textContent = String(number);
    const mark = find(row, ".mark");
    mark.textContent = ending.solved ? "✓" : "×";
    mark.classList.toggle("solved", ending.solved);
    find(row, ".words").textContent = endingWords(ending);
    const replay = find(row, "[data-act=replay]");
    replay.title = text.play.attempts.replay(x, y, r);
    replay.prepend(this.#thumbnails.add(SIDE));
    setLabel(find(row, "[data-act=overlay]"), text.play.attempts.compare(number));
    const remove = find(row, "[data-act=remove]");
    setLabel(remove, text.play.attempts.remove(number));
    if (this.#author !== "player") remove.remove();
    return row;
  }
}

/**
 * The number of the attempt whose row an element is in.
 * @param {Element} element
 */
function numberOf(element) {
  return Number(/** @type {HTMLElement | null} */ (element.closest("li"))?.dataset.number);
}

/**
 * Names a button that has an icon only, for screen readers and the tooltip.
 * @param {HTMLElement} button
 * @param {string} words
 */
function setLabel(button, words) {
  button.title = words;
  button.setAttribute("aria-label", words);
}
