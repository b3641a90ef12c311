// Imagined against real: after a run, the real paths of the green object and of the ball over those that the nets
// imagined, with their overlap. The last run of the player, of the model and of the scene alone stay beside each
// other, so that their numbers can be compared.

import { Plate, percent } from "./overlap-card.js";

const at = (id) => document.getElementById(id);

/** Whose runs there are, in the order in which they stand, and the stage that the green object's path is held against. */
const RUNS = { player: "target", model: "target", alone: "base" };

export class Actual {
  #wasm;
  #imagine;
  #session = null;
  /** Whose -> { title, number, object, ball }: the real paths. */
  #runs = {};
  /** What the session showed when the runs were last read. */
  #read = null;
  #dark = false;

  constructor(wasm, imagine) {
    this.#wasm = wasm;
    this.#imagine = imagine;
    imagine.addEventListener("imagined", () => this.#paint());
  }

  show(session) {
    this.#session = session;
    this.#runs = {};
    this.#read = null;
    session.addEventListener("change", () => this.#update());
    this.#paint();
  }

  set dark(dark) {
    this.#dark = dark;
    this.#paint();
  }

  #update() {
    const { puzzle, phase, finished, placing, shown, pair } = this.#session;
    if (placing) this.#read = null;
    const gone = Object.keys(this.#runs).filter((who) => who !== "alone" && this.#runs[who].number > puzzle.score(who).used);
    for (const who of gone) delete this.#runs[who];
    const what = phase === "compare" ? pair : (shown ?? phase);
    const fresh = finished && !placing && what !== this.#read;
    if (fresh) {
      this.#read = what;
      const paths = puzzle.paths();
      const whose = phase === "watch" ? [{ agent: "alone" }] : phase === "compare" ? pair : [shown];
      whose.forEach((attempt, index) => (this.#runs[attempt.agent] = { ...paths[index], ...titled(attempt) }));
    }
    if (fresh || gone.length) this.#paint();
  }

  #paint() {
    const maps = this.#imagine.values;
    const whose = maps && this.#session ? Object.keys(RUNS).filter((who) => this.#runs[who]) : [];
    at("actual-empty").hidden = whose.length > 0;
    at("actual-how").hidden = whose.length === 0;
    const words = [];
    at("runs").replaceChildren(...whose.map((who) => {
      const { title, object, ball } = this.#runs[who];
      const row = at("run-row").content.firstElementChild.cloneNode(true);
      row.dataset.who = who;
      row.querySelector("h3").textContent = title;
      const plate = (name, stage, real) => {
        const one = new Plate(this.#wasm);
        row.querySelector(".plates").append(one.element);
        return one.draw({ task: this.#session.about.id, name, stage, values: maps[stage], real, dark: this.#dark });
      };
      const green = plate("Green object", RUNS[who], object);
      const red = ball && plate("Red ball", "action", ball);
      words.push(`${title}: green object ${percent(green)}${ball ? `, red ball ${percent(red)}` : ""}`);
      return row;
    }));
    const said = words.length ? `As imagined – ${words.join("; ")}.` : "";
    if (at("actual-words").textContent !== said) at("actual-words").textContent = said;
  }
}

function titled({ agent, number, rehearsed }) {
  if (agent === "alone") return { title: "Without a ball" };
  if (agent === "player") return { title: `Your attempt ${number}`, number };
  return rehearsed ? { title: `The model’s ball ${number}` } : { title: `The model’s attempt ${number}`, number };
}
