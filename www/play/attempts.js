// A list of one agent's attempts: for each a small picture and its result in words, a button that replays it, one
// that lays it over another, and, for the player's own, one that deletes it.

import { Pictures } from "../shell/lazy-thumbnails.js";

/** Width of a picture, CSS px. */
const SIDE = 48;

export class Attempts {
  #list;
  #count;
  #agent;
  #session = null;
  #length = 0;
  #dark = false;
  #pictures = new Pictures((canvas) => this.#paint(canvas));

  /** `agent`: "player" or "model". `list`: an <ol>. `count`: where the score goes. */
  constructor(list, count, agent) {
    this.#list = list;
    this.#count = count;
    this.#agent = agent;
    list.addEventListener("click", ({ target }) => {
      const button = target.closest("button");
      if (button) this.#do(button.dataset.act, Number(button.closest("li").dataset.number));
    });
  }

  show(session) {
    this.#session = session;
    this.#clear();
    session.addEventListener("change", () => this.#update());
    this.#update();
  }

  set dark(dark) {
    this.#dark = dark;
    this.#pictures.redraw();
  }

  #do(act, number) {
    if (act === "replay") this.#session.replay(this.#agent, number);
    if (act === "lay") this.#session.overlay(this.#agent, number);
    if (act === "remove") {
      this.#session.remove(this.#agent, number);
      // The focus goes on to the attempt that has moved up, or to the one before.
      const next = this.#list.children[Math.min(number, this.#length) - 1];
      next?.querySelector("[data-act=remove]").focus();
    }
  }

  #clear() {
    this.#length = 0;
    this.#pictures.clear();
    this.#list.replaceChildren();
  }

  #update() {
    const { puzzle, onShow, unseen } = this.#session;
    const score = puzzle.score(this.#agent);
    // An attempt that runs for the first time is listed when it has ended.
    const used = score.used - Number(unseen && this.#agent === "player");
    const solvedAt = score.solved_at <= used ? score.solved_at : null;
    if (used < this.#length) this.#clear();
    if (used > this.#length) {
      this.#list.append(...puzzle.attempts(this.#agent).slice(this.#length, used).map((attempt) => this.#row(attempt)));
      this.#length = used;
      this.#list.scrollTop = this.#list.scrollHeight;
    }
    const text = used === 0 ? "" : solvedAt ? `solved on attempt ${solvedAt}` : `${used} of 100, not solved`;
    if (this.#count.textContent !== text) this.#count.textContent = text;
    const current = onShow.filter(({ agent }) => agent === this.#agent).map(({ number }) => number);
    for (const button of this.#list.querySelectorAll("[data-act=replay]")) {
      if (current.includes(Number(button.closest("li").dataset.number))) button.setAttribute("aria-current", "true");
      else button.removeAttribute("aria-current");
    }
  }

  #row({ number, words, ball, ending }) {
    const row = document.getElementById("attempt-row").content.firstElementChild.cloneNode(true);
    row.dataset.number = number;
    row.querySelector("b").textContent = number;
    row.querySelector(".mark").textContent = ending.solved ? "✓" : "×";
    row.querySelector(".mark").classList.toggle("solved", ending.solved);
    row.querySelector(".words").textContent = words;
    const [replay, lay, remove] = row.querySelectorAll("button");
    replay.title = `Replay: ball at x ${ball[0]}, y ${ball[1]}, radius ${ball[2]}`;
    replay.prepend(this.#pictures.add(SIDE));
    name(lay, `Compare attempt ${number}`);
    name(remove, `Delete attempt ${number}`);
    if (this.#agent !== "player") remove.remove();
    return row;
  }

  #paint(canvas) {
    this.#session.puzzle.paintAttempt(canvas.getContext("2d"), this.#agent, Number(canvas.closest("li").dataset.number), this.#dark);
  }
}

/** Names a button that has an icon only, for the ear and the tooltip. */
function name(button, words) {
  button.title = words;
  button.setAttribute("aria-label", words);
}
