// Imagined against real: after a run, the real paths of the green object and of the ball over those that the nets
// imagined, with their overlap. The last run of the player, of the model and of the scene alone stay beside each other,
// so that their numbers can be compared.

import { Component } from "../widgets/component.js";
import { sameBall } from "../puzzles/ball.js";
import { text } from "../text/text.js";
import { find, setText } from "../widgets/dom.js";
import { OverlapCard } from "./overlap-card.js";

/** @typedef {import("../pkg/pathlight.js").Ball} Ball */
/** @typedef {import("../pkg/pathlight.js").MapName} MapName */
/** @typedef {import("../play/session.js").Session} Session */
/** @typedef {"player" | "model" | "alone"} Runner */
/**
 * `number` and `placed`: of the attempt and its ball, if it is one.
 * @typedef {import("../pkg/pathlight.js").PathMasks & { title: string, number?: number, placed?: Ball }} Run
 */

/**
 * Who runs, in the order shown, with the map that imagines the green object's path.
 * @type {[Runner, MapName][]}
 */
const RUNNERS = [
  ["player", "target"],
  ["model", "target"],
  ["alone", "base"],
];

export class ImaginedVsReal extends Component {
  #imagine;
  #scenePicture;
  /** @type {Map<Runner, Run>} */
  #runs = new Map();
  /**
   * What the session showed when its paths were last read.
   * @type {unknown}
   */
  #lastRead = null;
  /**
   * @type {Map<import("../pkg/pathlight.js").Author, number>} how many attempts there were when the runs were last
   *   looked up
   */
  #used = new Map();

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("./imagine.js").Imagine} imagine
   * @param {import("./scene-picture.js").ScenePicture} scenePicture
   */
  constructor(root, imagine, scenePicture) {
    super(root);
    this.#imagine = imagine;
    this.#scenePicture = scenePicture;
    imagine.addEventListener("maps", () => {
      // The maps go when another model is loaded, and with them the runs of the old one.
      if (!imagine.maps) this.#runs.delete("model");
      this.#paint();
    });
  }

  /** @param {Session} session */
  open(session) {
    super.open(session);
    this.listen("change", () => this.#update(session));
  }

  close() {
    super.close();
    this.#runs.clear();
    this.#used.clear();
    this.#lastRead = null;
    this.#paint();
  }

  /** @param {boolean} dark */
  setTheme(dark) {
    super.setTheme(dark);
    this.#paint();
  }

  /** @param {Session} session */
  #update(session) {
    const { game, state, finished, placing } = session;
    if (placing) this.#lastRead = null;
    let changed = false;
    for (const author of /** @type {const} */ (["player", "model"])) {
      // The attempt may have been deleted meanwhile, or have another number now.
      const run = this.#runs.get(author);
      const { used } = session.attempts.standing(author);
      if (run?.number === undefined || used === this.#used.get(author)) continue;
      this.#used.set(author, used);
      const number = 1 + session.attempts.of(author).findIndex(({ ball }) => sameBall(ball, run.placed));
      if (number === run.number) continue;
      changed = true;
      if (number === 0) this.#runs.delete(author);
      else this.#runs.set(author, { ...run, number, title: text.panels.imaginedVsReal.attempt(author, number) });
    }
    const current = state.kind === "compare" ? state.pair : (session.shown ?? state.kind);
    if (finished && !placing && current !== this.#lastRead) {
      this.#lastRead = current;
      const runs = (state.kind === "compare" ? state.pair : [session.shown]).map(runOf);
      const paths = game.pathMasks();
      runs.forEach(({ runner, ...run }, index) => this.#runs.set(runner, { ...run, ...paths[index] }));
      changed = true;
    }
    if (changed) this.#paint();
  }

  #paint() {
    const maps = this.session && this.#imagine.maps;
    const words = text.panels.imaginedVsReal;
    const runs = [];
    const rows = [];
    for (const [runner, mapName] of RUNNERS) {
      const run = this.#runs.get(runner);
      if (!maps || !run) continue;
      const { title, object, ball } = run;
      const row = this.fromTemplate("run-row");
      row.dataset.runner = runner;
      find(row, "h3").textContent = title;
      const green = this.#addCard(row, words.green, mapName, maps[mapName], object);
      const red = ball ? this.#addCard(row, words.red, "action", maps.action, ball) : null;
      runs.push(words.run(title, green, red));
      rows.push(row);
    }
    this.byId("runs").replaceChildren(...rows);
    this.byId("overlap-empty").hidden = rows.length > 0;
    this.byId("overlap-how").hidden = rows.length === 0;
    setText(this.byId("overlap-words"), runs.length ? words.all(runs) : "");
  }

  /**
   * Returns the overlap in words.
   * @param {HTMLElement} row
   * @param {string} name
   * @param {MapName} mapName
   * @param {Float32Array | undefined} values
   * @param {Float32Array} real
   */
  #addCard(row, name, mapName, values, real) {
    if (!values) return text.panels.imaginedVsReal.unknown;
    const card = new OverlapCard(this.fromTemplate("overlap-card"), this.#scenePicture);
    find(row, ".overlap-cards").append(card.element);
    return text.format.percent(card.draw({ name, mapName, values, real, dark: this.dark }));
  }
}

/**
 * @param {import("../play/shown.js").ShownAttempt | null} attempt
 * @returns {{ runner: Runner, title: string, number?: number, placed?: Ball }}
 */
function runOf(attempt) {
  const words = text.panels.imaginedVsReal;
  if (!attempt) return { runner: "alone", title: words.alone };
  const { author, number, ball, preview, opened } = attempt;
  if (opened) return { runner: author, title: words.opened };
  if (preview) return { runner: author, title: words.ball(number) };
  return { runner: author, title: words.attempt(author, number), number, placed: ball };
}
