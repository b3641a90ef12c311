// The Imagine panel: small maps, each with a sentence, a legend and a switch that lays it over the scene.
// Maps and legends are drawn by the wasm, from one colour scale a stage.

import { STAGES } from "../shell/url-state.js";
import { SIDE, WORDS, summary } from "../model/stages.js";

/** Pixels across a canvas of lines, which is laid over the whole scene. */
const LINES = 1024;

const at = (id) => document.getElementById(id);

export class Imagine extends EventTarget {
  /** Stage -> its canvas of 64 x 64, to be laid over the scene. */
  maps = {};
  #wasm;
  #model;
  #session = null;
  #rows = {};
  #imagined = null;
  #dark = false;

  /** Fires "layers", "opacity" and "model", with { layers } and so on, when the person asks for others, and
   * "again" when a model that failed is to be started once more. */
  constructor(wasm, model) {
    super();
    this.#wasm = wasm;
    this.#model = model;
    at("stages").replaceChildren(...STAGES.map((stage) => this.#row(stage)));
    at("opacity").addEventListener("input", () => this.#ask("opacity", { opacity: Number(at("opacity").value) }));
    at("model").addEventListener("change", () => this.#ask("model", { model: at("model").value }));
    at("imagine-trouble").querySelector("button").addEventListener("click", () => this.#ask("again", {}));
    model.addEventListener("change", () => this.#progress());
  }

  /** Imagines another puzzle, as soon as the model can. */
  show(session) {
    this.#session = session;
    this.#imagined = null;
    // Asked for first: the worker imagines while the page draws.
    this.#imagine();
    this.#scenes();
    this.#paint();
  }

  set({ layers, opacity }) {
    at("opacity").value = opacity;
    for (const stage of STAGES) this.#rows[stage].box.checked = layers.includes(stage);
  }

  set dark(dark) {
    this.#dark = dark;
    for (const stage of STAGES) this.#wasm.paintLegend(this.#rows[stage].legend.getContext("2d"), stage, dark);
    this.#scenes();
    this.#paint();
  }

  /** What to draw over the scene for some stages: their maps, and lines round what is strong in them; nothing until
   * they are imagined. */
  laid(stages) {
    return this.#imagined ? stages.flatMap((stage) => [this.maps[stage], this.#rows[stage].line]) : [];
  }

  /** Stage -> its map, 64 x 64 numbers; null until they are imagined. */
  get values() {
    return this.#imagined?.maps ?? null;
  }

  /** Shows one stage alone, or all for null. */
  set alone(stage) {
    at("stages").classList.toggle("alone", stage !== null);
    for (const one of STAGES) this.#rows[one].row.hidden = stage !== null && one !== stage;
  }

  #ask(what, detail) {
    this.dispatchEvent(new CustomEvent(what, { detail }));
  }

  #row(stage) {
    const { name, means, how } = WORDS[stage];
    const row = at("stage-row").content.firstElementChild.cloneNode(true);
    const box = row.querySelector("input");
    const [scene, map] = row.querySelectorAll(".map canvas");
    const legend = row.querySelector(".legend");
    row.dataset.stage = stage;
    row.querySelector("b").textContent = name;
    row.querySelector(".means").textContent = means;
    row.querySelector("details p").textContent = how;
    map.setAttribute("aria-label", `${name}: not imagined yet`);
    box.addEventListener("change", () => {
      this.#ask("layers", { layers: STAGES.filter((stage) => this.#rows[stage].box.checked) });
    });
    this.maps[stage] = map;
    const said = row.querySelector(".summary");
    const line = document.createElement("canvas");
    line.width = line.height = LINES;
    this.#rows[stage] = { row, box, scene, map, legend, most: legend.nextElementSibling, said, line };
    return row;
  }

  #progress() {
    const { status, progress, trouble, loaded } = this.#model;
    at("imagine-trouble").hidden = status !== "failed";
    at("imagine-trouble").querySelector("p").textContent = trouble ?? "";
    at("imagine-trouble").querySelector("button").textContent = this.#model.code === "no_model" ? "Use the model that is here" : "Try again";
    at("imagine-body").hidden = status === "failed";
    at("imagine-progress").hidden = status !== "loading";
    const bar = at("imagine-progress").querySelector("progress");
    if (progress === null) bar.removeAttribute("value");
    else bar.value = progress;
    if (loaded) this.#choice(loaded);
    if (status === "ready") this.#imagine();
    else {
      this.#imagined = null;
      this.#paint();
    }
  }

  /** The models that there are, where there are several. */
  #choice({ name, names }) {
    at("models").hidden = names.length < 2;
    at("model").replaceChildren(...names.map((one) => new Option(one, one, one === name, one === name)));
  }

  async #imagine() {
    const session = this.#session;
    if (!session || this.#model.status !== "ready") return;
    try {
      const imagined = await this.#model.imagine(session.about.id);
      if (session !== this.#session) return;
      this.#imagined = imagined;
      this.#paint();
    } catch {
      // The model tells its own trouble; `#progress` shows it.
    }
  }

  /** Draws the scene that lies under each small map. */
  #scenes() {
    if (!this.#session) return;
    for (const stage of STAGES) this.#wasm.paintThumbnail(this.#rows[stage].scene.getContext("2d"), this.#session.about.id, this.#dark);
  }

  /** Draws the small maps: what is imagined. */
  #paint() {
    const imagined = this.#imagined;
    for (const stage of STAGES) {
      const { map, line, most, said } = this.#rows[stage];
      const values = imagined?.maps[stage];
      // Each map is drawn up to its own peak, which the legend names.
      const peak = values ? Math.max(...values) : 0;
      most.textContent = values ? peak.toFixed(2) : "";
      const context = map.getContext("2d");
      if (values) this.#wasm.paintMap(context, stage, values, peak, this.#dark);
      else context.clearRect(0, 0, SIDE, SIDE);
      const round = line.getContext("2d");
      round.clearRect(0, 0, LINES, LINES);
      if (values) this.#wasm.paintOutline(round, stage, values.map((value) => value / peak), this.#dark);
      // Weights may come without a judge.
      const words = values ? summary(values) : imagined ? "this model has no such map" : "not imagined yet";
      map.setAttribute("aria-label", `${WORDS[stage].name}: ${words}`);
      said.textContent = `${words[0].toUpperCase()}${words.slice(1)}.`;
    }
    at("imagined-in").textContent = imagined ? timed(imagined) : "";
    this.dispatchEvent(new Event("imagined"));
  }
}

function timed({ milliseconds, saw }) {
  const before = saw ? "The model has seen this puzzle in training." : "The model has never seen this puzzle before.";
  return `Imagined in ${Math.max(1, Math.round(milliseconds))} ms. ${before}`;
}
