// A list of one agent's attempts: a button for each, with its result in words, that replays it.

export class Attempts {
  #list;
  #count;
  #agent;
  #session = null;
  #length = 0;

  /** `agent`: "player" or "model". `list`: an <ol>. `count`: where the score goes. */
  constructor(list, count, agent) {
    this.#list = list;
    this.#count = count;
    this.#agent = agent;
    list.addEventListener("click", (event) => {
      const button = event.target.closest("button");
      if (button) this.#session.replay(agent, Number(button.dataset.number));
    });
  }

  show(session) {
    this.#session = session;
    this.#clear();
    session.addEventListener("change", () => this.#update());
    this.#update();
  }

  #clear() {
    this.#length = 0;
    this.#list.replaceChildren();
  }

  #update() {
    const { puzzle, shown, phase, pair, unseen } = this.#session;
    const score = puzzle.score(this.#agent);
    // An attempt that runs for the first time is listed when it has ended.
    const used = score.used - Number(unseen && this.#agent === "player");
    const solvedAt = score.solved_at <= used ? score.solved_at : null;
    if (used < this.#length) this.#clear();
    if (used > this.#length) {
      this.#list.append(...puzzle.attempts(this.#agent).slice(this.#length, used).map(item));
      this.#length = used;
      this.#list.scrollTop = this.#list.scrollHeight;
    }
    const text = used === 0 ? "" : solvedAt ? `solved on attempt ${solvedAt}` : `${used} of 100, not solved`;
    if (this.#count.textContent !== text) this.#count.textContent = text;
    const best = pair[this.#agent === "player" ? 0 : 1]?.number;
    const current = phase === "compare" ? best : shown?.agent === this.#agent ? shown.number : undefined;
    for (const button of this.#list.querySelectorAll("[aria-current]")) button.removeAttribute("aria-current");
    this.#list.children[current - 1]?.firstElementChild.setAttribute("aria-current", "true");
  }
}

function item({ number, words, ball, ending }) {
  const button = document.createElement("button");
  button.type = "button";
  button.dataset.number = number;
  button.title = `Replay: ball at x ${ball[0]}, y ${ball[1]}, radius ${ball[2]}`;
  const label = document.createElement("b");
  label.textContent = number;
  const mark = document.createElement("span");
  mark.className = ending.solved ? "mark solved" : "mark";
  mark.textContent = ending.solved ? "✓" : "×";
  mark.setAttribute("aria-hidden", "true");
  button.append(label, mark, words);
  const entry = document.createElement("li");
  entry.append(button);
  return entry;
}
