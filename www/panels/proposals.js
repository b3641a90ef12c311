// The model's hundred balls as a stack, one by one, tried in its turn or not: what came of each, whether it may be
// placed, and where on the placement map it comes from. The one that is looked at runs to its end at once, with its
// paths over the scene and the balls before it marked. Which one it is stands in the link.

import { sentence } from "../play/session.js";
import { valueAt } from "../model/stages.js";

const at = (id) => document.getElementById(id);

export class Stack extends EventTarget {
  #model;
  #imagine;
  #session = null;
  /** The model's balls, [{ ball, origin, rejected }, …], or null until it has proposed them. */
  #proposals = null;
  /** The number of the ball that is asked for, from 1, or null. */
  #number = null;
  /** Is this panel on? */
  #on = false;
  /** The number of the ball that runs in the scene, or null. */
  #shown = null;

  /** Fires "set" to ask for another ball. */
  constructor(model, imagine) {
    super();
    this.#model = model;
    this.#imagine = imagine;
    at("stack").addEventListener("input", () => this.#ask(Number(at("stack").value)));
    at("stack-back").addEventListener("click", () => this.#ask((this.#number ?? 2) - 1));
    at("stack-next").addEventListener("click", () => this.#ask((this.#number ?? 0) + 1));
    at("stack-close").addEventListener("click", () => this.#session.reset());
    // The placement map is there as soon as the model can propose.
    imagine.addEventListener("imagined", () => this.#propose());
  }

  show(session) {
    this.#session = session;
    this.#proposals = null;
    this.#shown = null;
    session.addEventListener("change", () => this.#follow());
    this.#update();
  }

  set({ panel, proposal }) {
    this.#on = panel === "compare";
    this.#number = proposal;
    this.#propose();
    this.#update();
  }

  /** Is one of the balls being looked at? */
  get open() {
    return this.#on && this.#shown !== null;
  }

  /** The balls to mark over the scene. */
  get marks() {
    if (!this.open) return [];
    return this.#proposals.slice(0, this.#shown).map((proposal, index) => {
      const chosen = index + 1 === this.#shown;
      return { ball: proposal.ball, from: chosen ? this.#source(proposal) : null, chosen };
    });
  }

  #ask(number) {
    const most = this.#proposals?.length ?? 0;
    if (number >= 1 && number <= most) this.#set(number);
  }

  #set(proposal) {
    this.dispatchEvent(new CustomEvent("set", { detail: { proposal } }));
  }

  async #propose() {
    const session = this.#session;
    if (!this.#on || this.#proposals || !session || !this.#imagine.values) return;
    try {
      const proposals = await this.#model.propose(session.about.id);
      if (session !== this.#session || this.#proposals) return;
      this.#proposals = proposals;
      this.#update();
    } catch {
      // The model tells its own trouble; the panel shows it.
    }
  }

  /** Runs the ball that is asked for, if it does not run yet. */
  #update() {
    const here = this.#session && this.#proposals;
    const most = this.#proposals?.length ?? 0;
    at("stack-part").hidden = !here;
    if (!here) return;
    at("stack").max = most;
    const proposal = this.#on && this.#number !== null ? this.#proposals[this.#number - 1] : null;
    if (proposal && this.#shown !== this.#number) {
      this.#shown = this.#number;
      const tried = this.#session.puzzle.attempts("model").some(({ ball }) => String(ball) === String(proposal.ball));
      this.#session.rehearse(this.#number, proposal.ball, tried);
    }
    this.#tell();
  }

  /** Something else is shown than the ball that was asked for: it is no longer looked at. */
  #follow() {
    if (this.#shown === null || this.#session.shown?.rehearsed === this.#shown) return;
    this.#shown = null;
    this.#tell();
    this.#set(null);
  }

  #tell() {
    const number = this.#shown;
    at("stack-facts").hidden = number === null;
    at("stack-close").hidden = number === null;
    at("stack-hint").hidden = number !== null;
    at("stack-number").textContent = number === null ? "–" : `${number} of ${this.#proposals.length}`;
    at("stack").value = number ?? 1;
    at("stack").setAttribute("aria-valuetext", number === null ? "none" : `${number}`);
    if (number === null) return;
    const proposal = this.#proposals[number - 1];
    const { ending, words, tried } = this.#session.shown;
    const [x, y, r] = proposal.ball;
    at("stack-ball").textContent = `x ${x}, y ${y}, radius ${r}`;
    at("stack-valid").textContent = rejected(proposal);
    at("stack-outcome").textContent = `${ending.solved ? "✓" : "×"} ${sentence(words)} ${tried ? "" : "It was not tried in its turn."}`;
    at("stack-origin").textContent = this.#origin(proposal);
  }

  #origin({ origin }) {
    if (origin.kind === "perturbed") return `Ball ${origin.number}, moved by chance.`;
    if (origin.kind === "judge") return `The judge, a fifth net: after what was tried before, it gives this ball the best chance, ${Math.round(100 * origin.probability)} %.`;
    if (origin.kind === "uniform") return "Chance: the placement map shows no place where a ball may be.";
    const value = valueAt(this.#imagine.values.placement, [origin.x, origin.y]).toFixed(2);
    return `The placement map: it is ${value} at x ${origin.x}, y ${origin.y}. From there the ball was moved to cover more of the map.`;
  }

  /** The place that a ball comes from, px, or null. */
  #source({ origin }) {
    if (origin.kind === "map") return [origin.x, origin.y];
    if (origin.kind === "perturbed") return this.#proposals[origin.number - 1].ball.slice(0, 2);
    return null;
  }
}

function rejected({ rejected }) {
  if (rejected === 0) return "Yes.";
  return `Yes. ${rejected} ${rejected === 1 ? "draw" : "draws"} before it ${rejected === 1 ? "was" : "were"} passed over: not allowed, or a ball that it had already. They do not count.`;
}
