// The part Check the answer of Imagine: where a ball of this radius solves the puzzle, found by simulating it at every
// place, coarsely at first and then finer. The worker does it, sends its progress, and can be stopped. The model's
// placement map can be laid over it.

import { paintOutcomes } from "../pkg/pathlight.js";
import { Component } from "../widgets/component.js";
import { FIRST_RADIUS, GRID_SIDE, SCENE_SIZE } from "../shell/constants.js";
import { contextOf, find, setText } from "../widgets/dom.js";
import { sides } from "../model/map-summary.js";
import { Search } from "../model/search.js";
import { text } from "../text/text.js";

/** The outcomes of a place that are counted, as the wasm numbers them. */
const [INVALID, SOLVED] = [1, 3];

export class SolveMapPanel extends Component {
  #client;
  #imagine;
  #placementBox = this.byId("solve-map-placement", HTMLInputElement);
  #context;
  #visible = false;
  /** Does a link leave out what the model imagines? */
  #hidesModel = false;
  /** @type {import("../pkg/pathlight.js").MapName[]} */
  #checkedLayers = [];
  /**
   * Outcomes of GRID_SIDE x GRID_SIDE places, row 0 at the bottom.
   * @type {Uint8Array | null}
   */
  #outcomes = null;
  /** The radius of the map, px. */
  #radius = FIRST_RADIUS;
  /** The fraction of the places that has been tried. */
  #progress = 0;
  #search = new Search(() => this.#onEnd());

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../model/shared-client.js").SharedClient} client
   * @param {import("./imagine.js").Imagine} imagine
   */
  constructor(root, client, imagine) {
    super(root);
    this.#client = client;
    this.#imagine = imagine;
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = SCENE_SIZE;
    this.#context = contextOf(canvas);
    this.byId("solve-map-search").addEventListener("click", () =>
      this.#search.running ? this.#search.stop() : this.#start(),
    );
    this.#placementBox.addEventListener("change", () => {
      const others = this.#checkedLayers.filter((mapName) => mapName !== "placement");
      const layers = this.#placementBox.checked ? [...others, "placement"] : others;
      this.requestState({ layers: layers.length > 0 ? /** @type {typeof others} */ (layers) : null });
    });
    imagine.addEventListener("maps", () => this.#update());
  }

  /** @param {import("../play/session.js").Session} session */
  open(session) {
    super.open(session);
    this.listen("change", () => this.#update());
    this.#update();
  }

  close() {
    super.close();
    this.#search.forget();
    this.#outcomes = null;
  }

  /** @param {import("../state/view.js").View} view */
  setState({ panel, checkedLayers, hide }) {
    this.#hidesModel = hide.includes("imagine");
    this.#visible = panel === "map";
    this.#checkedLayers = checkedLayers;
    this.#placementBox.checked = checkedLayers.includes("placement");
  }

  /** @param {boolean} dark */
  setTheme(dark) {
    super.setTheme(dark);
    for (const sample of this.byId("map").querySelectorAll("canvas")) {
      paintOutcomes(
        contextOf(sample),
        new Uint8Array(GRID_SIDE * GRID_SIDE).fill(Number(sample.dataset.outcome)),
        dark,
      );
    }
    this.#paint();
  }

  get overlay() {
    if (!this.#visible || !this.#outcomes) return null;
    return { maps: [this.#context.canvas, ...(this.#imagine.overlay?.maps ?? [])] };
  }

  /** The radius that the next search is for, px. */
  get #nextRadius() {
    return this.session?.ball?.[2] ?? FIRST_RADIUS;
  }

  #start() {
    const { session } = this;
    if (!session) return;
    // A search needs a worker but no weights: it goes on without a model, but not after a crash.
    if (!this.#client.alive) this.requestModel();
    this.#radius = this.#nextRadius;
    this.#outcomes = null;
    this.#progress = 0;
    this.#search.start((signal) =>
      this.#client.call("solve", [session.puzzle, this.#radius], signal, ({ outcomes, progress }) => {
        this.#outcomes = outcomes;
        this.#progress = progress;
        this.#paint();
      }),
    );
    this.#paint();
  }

  #onEnd() {
    this.#update();
    // Announced only now: during the search each announcement would replace the one before.
    this.announce(this.byId("solve-map-words").textContent ?? "");
  }

  #paint() {
    if (this.#outcomes) paintOutcomes(this.#context, this.#outcomes, this.dark);
    this.#update();
    this.changeOverlay();
  }

  #update() {
    if (!this.session) return;
    setText(
      this.byId("solve-map-search"),
      this.#search.running ? text.panels.solveMap.stop : text.panels.solveMap.start(this.#nextRadius),
    );
    this.byId("solve-map-progress").hidden = !this.#search.running;
    find(this.byId("solve-map-progress"), "progress", HTMLProgressElement).value = this.#progress;
    setText(this.byId("solve-map-words"), this.#search.failure ?? (this.#outcomes ? this.#words(this.#outcomes) : ""));
  }

  /** @param {Uint8Array} outcomes */
  #words(outcomes) {
    const solved = Float32Array.from(outcomes, (outcome) => Number(outcome === SOLVED));
    /** @param {number} which */
    const count = (which) => outcomes.reduce((sum, outcome) => sum + Number(outcome === which), 0);
    const [solving, invalid] = [count(SOLVED), count(INVALID)].map((places) => places / outcomes.length);
    const all = text.panels.solveMap.tried(this.#progress, solving, invalid, this.#radius);
    if (solving === 0) return all;
    return [all, text.panels.solveMap.sides(sides(solved)), this.#agreement(solved)].join(" ").trim();
  }

  /**
   * How much of the placement map lies where a ball solves the puzzle.
   * @param {Float32Array} solved
   */
  #agreement(solved) {
    const map = this.#imagine.maps?.placement;
    if (!map || this.#hidesModel) return "";
    const total = map.reduce((sum, value) => sum + value, 0);
    const right = map.reduce((sum, value, cell) => sum + value * solved[cell], 0);
    return total ? text.panels.solveMap.agrees(right / total) : "";
  }
}

/** @type {import("./panel-module.js").PanelModule} */
export const MAP = {
  markup() {
    const words = text.panels.solveMap;
    return `
<p>${words.intro}</p>
<p class="actions"><button type="button" id="solve-map-search" class="primary"></button></p>
<p class="loading" id="solve-map-progress" hidden><label>${words.trying} <progress max="1" value="0"></progress></label></p>
<p id="solve-map-words"></p>
<ul class="samples">
  <li><canvas width="256" height="256" data-outcome="3" aria-hidden="true"></canvas> ${words.solves}</li>
  <li><canvas width="256" height="256" data-outcome="2" aria-hidden="true"></canvas> ${words.doesNot}</li>
  <li><canvas width="256" height="256" data-outcome="1" aria-hidden="true"></canvas> ${words.noRoom}</li>
</ul>
<label class="check" data-hideable="imagine"><input type="checkbox" id="solve-map-placement"> ${words.compare}</label>
<p class="hint">${words.hint}</p>
`;
  },
  create: ({ root, client, imagine }) => [new SolveMapPanel(root, client, imagine)],
};
