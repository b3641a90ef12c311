// The Map panel: where a ball of this radius solves the puzzle, found by simulating it at every place, roughly at
// first and then finer. The worker does it, tells how far it is, and can be stopped. The model's placement map can
// be laid over it.

import { CELL, SIDE, sides } from "../model/stages.js";
import { percent } from "./overlap-card.js";
import { say } from "../shell/announce.js";

const at = (id) => document.getElementById(id);

/** The radius for which a map is made while there is no ball, px. */
const FIRST_RADIUS = 12;
const [INVALID, SOLVED] = [1, 3];

export class SolveMap extends EventTarget {
  #wasm;
  #model;
  #imagine;
  #session = null;
  #canvas = document.createElement("canvas");
  #dark = false;
  /** Is this panel on? */
  #on = false;
  #layers = [];
  /** Outcomes of 64 x 64 places, or null. */
  #picture = null;
  /** The radius that the map is for, and the share of the places that has been tried. */
  #radius = null;
  #progress = 0;
  /** The session for which a search is on, or null. */
  #searching = null;
  #trouble = null;

  /** Fires "lay" when there is more to see, "set" when the placement map is to be laid over it or not. */
  constructor(wasm, model, imagine) {
    super();
    this.#wasm = wasm;
    this.#model = model;
    this.#imagine = imagine;
    this.#canvas.width = this.#canvas.height = SIDE * CELL;
    at("search").addEventListener("click", () => (this.#searching ? this.#stop() : this.#search()));
    at("map-placement").addEventListener("change", () => {
      const others = this.#layers.filter((stage) => stage !== "placement");
      const layers = at("map-placement").checked ? [...others, "placement"] : others;
      this.dispatchEvent(new CustomEvent("set", { detail: { layers } }));
    });
    imagine.addEventListener("imagined", () => this.#tell());
  }

  show(session) {
    this.leave();
    this.#session = session;
    session.addEventListener("change", () => this.#tell());
    this.#tell();
  }

  /** The puzzle is being left. */
  leave() {
    this.#stop();
    this.#picture = null;
    this.#trouble = null;
    this.#session = null;
  }

  set({ panel, layers }) {
    this.#on = panel === "map";
    this.#layers = layers;
    at("map-placement").checked = layers.includes("placement");
  }

  set dark(dark) {
    this.#dark = dark;
    for (const sample of document.querySelectorAll("#map canvas[data-outcome]")) {
      this.#wasm.paintOutcomes(sample.getContext("2d"), new Uint8Array(SIDE * SIDE).fill(sample.dataset.outcome), dark);
    }
    this.#paint();
  }

  /** The map to lay over the scene, if there is one. */
  get maps() {
    return this.#on && this.#picture ? [this.#canvas] : [];
  }

  get #wanted() {
    return this.#session?.ball?.[2] ?? FIRST_RADIUS;
  }

  async #search() {
    const session = this.#session;
    this.#searching = session;
    this.#radius = this.#wanted;
    this.#picture = null;
    this.#trouble = null;
    this.#progress = 0;
    this.#paint();
    try {
      await this.#model.solve(session.about.id, this.#radius, ({ picture, progress }) => {
        if (session !== this.#searching) return;
        this.#picture = picture;
        this.#progress = progress;
        this.#paint();
      });
    } catch (error) {
      if (session === this.#searching) this.#trouble = error.message;
    } finally {
      if (session === this.#searching) this.#searching = null;
      this.#tell();
      // Not on the way: who listens would never hear the end.
      if (session === this.#session) say(at("map-words").textContent);
    }
  }

  #stop() {
    if (!this.#searching) return;
    this.#searching = null;
    this.#model.stop("solve");
    this.#tell();
  }

  #paint() {
    if (this.#picture) this.#wasm.paintOutcomes(this.#canvas.getContext("2d"), this.#picture, this.#dark);
    this.#tell();
    this.dispatchEvent(new Event("lay"));
  }

  #tell() {
    if (!this.#session) return;
    const label = this.#searching ? "Stop" : `Try every place with radius ${this.#wanted}`;
    if (at("search").textContent !== label) at("search").textContent = label;
    at("search-progress").hidden = !this.#searching;
    at("search-progress").querySelector("progress").value = this.#progress;
    const words = this.#trouble ?? (this.#picture ? this.#words() : "");
    if (at("map-words").textContent !== words) at("map-words").textContent = words;
  }

  #words() {
    const places = this.#picture.length;
    const solved = Float32Array.from(this.#picture, (outcome) => Number(outcome === SOLVED));
    const count = (which) => this.#picture.reduce((sum, outcome) => sum + Number(outcome === which), 0);
    const [yes, no] = [count(SOLVED), count(INVALID)];
    const tried = this.#progress < 1 ? `${percent(this.#progress)} tried so far: about ` : "Every place tried: ";
    const all = `${tried}${share(yes / places)} of the places solve it with radius ${this.#radius}, and at ${share(no / places)} no ball may be.`;
    if (yes === 0) return all;
    return `${all} Those that solve it: ${sides(solved)}.${this.#agreement(solved)}`;
  }

  /** How much of the placement map lies where a ball solves the puzzle. */
  #agreement(solved) {
    const map = this.#imagine.values?.placement;
    if (!map) return "";
    const [all, right] = [map.reduce((sum, value) => sum + value, 0), map.reduce((sum, value, cell) => sum + value * solved[cell], 0)];
    return all ? ` The model lays ${percent(right / all)} of its placement map on such places.` : "";
  }
}

function share(value) {
  return value > 0 && value < 0.01 ? "less than 1 %" : percent(value);
}
