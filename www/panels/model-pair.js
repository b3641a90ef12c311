// Two models side by side on the open puzzle: for each whether it has seen the puzzle, a map, the balls that it tries
// by their outcome, and when it solves. The second model has a worker of its own while they are shown.

import { Component } from "../widgets/component.js";
import { MAPS } from "../shell/constants.js";
import { contextOf, find, setText } from "../widgets/dom.js";
import { pathlight } from "../shell/page-api.js";
import { chanceWords } from "../model/chance-words.js";
import { mapWords } from "../model/place-words.js";
import { practice } from "../model/practice.js";
import { SharedClient } from "../model/shared-client.js";
import { sentence } from "../text/sentence.js";
import { text } from "../text/text.js";

/** @typedef {import("../pkg/pathlight.js").MapName} MapName */
/** @typedef {import("../pkg/pathlight.js").TriedProposal} TriedProposal */
/** @typedef {import("../model/worker.js").Imagined} Imagined */
/** @typedef {import("../model/worker.js").LoadedModel} LoadedModel */
/**
 * What one model imagines and tries.
 * @typedef {{ name: string, card: LoadedModel["card"], imagined: Imagined, tried: TriedProposal[] }} Side
 */

export class ModelPair extends Component {
  #client;
  #other;
  #scenePicture;
  #name = this.byId("pair-model", HTMLSelectElement);
  #mapName = this.byId("pair-map-name", HTMLSelectElement);
  /** @type {Side[]} */
  #sides = [];
  /**
   * Runs while the models are asked.
   * @type {AbortController | null}
   */
  #call = null;
  /**
   * The name of the model beside which the other one is asked.
   * @type {string | null}
   */
  #asked = null;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {WebAssembly.Module} module
   * @param {SharedClient} client of the model that is chosen
   * @param {import("./scene-picture.js").ScenePicture} scenePicture
   */
  constructor(root, module, client, scenePicture) {
    super(root);
    this.#client = client;
    this.#other = new SharedClient(module);
    this.#scenePicture = scenePicture;
    this.#mapName.append(
      ...MAPS.map(
        (mapName) => new Option(text.model.steps[mapName].name, mapName, mapName === "target", mapName === "target"),
      ),
    );
    this.#mapName.addEventListener("change", () => this.#paint());
    this.#name.addEventListener("change", () => this.#clear());
    this.byId("pair-run").addEventListener("click", () => this.#run());
    client.addEventListener("change", () => this.#onClientChange());
  }

  close() {
    super.close();
    this.#clear();
  }

  /** @param {boolean} dark */
  setTheme(dark) {
    super.setTheme(dark);
    this.#paint();
  }

  #onClientChange() {
    const { loaded } = this.#client;
    // What stands there, or is on its way, belongs to the model that goes.
    if (this.#asked !== null && loaded?.name !== this.#asked) this.#clear();
    const others = (loaded?.names ?? []).filter((name) => name !== loaded?.name);
    this.byId("model-pair").hidden = others.length === 0;
    if (String(others) !== String(Array.from(this.#name.options, ({ value }) => value)))
      this.#name.replaceChildren(...others.map((name) => new Option(name)));
  }

  #clear() {
    this.#call?.abort();
    this.#call = null;
    this.#asked = null;
    this.#sides = [];
    this.#other.stop();
    this.#say("");
    this.#paint();
  }

  /** @param {string} words */
  #say(words) {
    setText(this.byId("pair-words"), words);
    if (words) this.announce(words);
  }

  async #run() {
    const { loaded } = this.#client;
    if (!this.session || !loaded || this.#call) return;
    const { puzzle } = this.session;
    const call = (this.#call = new AbortController());
    const names = [loaded.name, this.#name.value];
    this.#asked = loaded.name;
    this.#say(text.panels.modelPair.playing);
    try {
      await this.#other.ready(names[1], call.signal);
      const ask = async (/** @type {SharedClient} */ client, /** @type {string} */ name) => {
        const [imagined, tried] = await Promise.all([
          client.call("imagine", [puzzle], call.signal),
          client.call("propose", [puzzle], call.signal),
        ]);
        const card = /** @type {LoadedModel} */ (client.loaded).card;
        return { name, card, imagined, tried };
      };
      const sides = await Promise.all([ask(this.#client, names[0]), ask(this.#other, names[1])]);
      if (call.signal.aborted) return;
      this.#sides = sides;
      this.#say(verdictOf(sides));
      this.#paint();
    } catch (error) {
      if (!call.signal.aborted) this.#say(/** @type {Error} */ (error).message);
    } finally {
      if (this.#call === call) this.#call = null;
    }
  }

  #paint() {
    this.byId("pair-columns").replaceChildren(...this.#sides.map((side) => this.#column(side)));
    this.byId("pair-map").hidden = this.#sides.length === 0;
  }

  /** @param {Side} side */
  #column({ name, card, imagined: { maps, seen }, tried }) {
    const column = this.fromTemplate("pair-column");
    const { noMap, watch } = text.panels.modelPair;
    find(column, "h3").textContent = name;
    find(column, ".model-words").textContent = sentence(text.model.knows[card.setup]);
    const badge = find(column, ".model-badge span");
    badge.dataset.seen = String(seen);
    badge.textContent = practice(card, seen);
    const mapName = /** @type {MapName} */ (this.#mapName.value);
    const map = maps[mapName];
    this.#scenePicture.drawOn(find(column, ".scene-layer", HTMLCanvasElement));
    const shade = find(column, ".shade-layer", HTMLCanvasElement);
    if (map) pathlight.paintMap(contextOf(shade), mapName, map, { max: Math.max(...map), dark: this.dark });
    const words = map && this.session ? mapWords(map, pathlight.scene(this.session.puzzle)) : noMap;
    shade.setAttribute("aria-label", text.panels.imagine.described(text.model.steps[mapName].name, words));
    find(column, ".pair-place").textContent = sentence(words);
    find(column, ".pair-outcome").textContent = outcomeWords(tried);
    const button = find(column, "button");
    const last = tried.length;
    button.textContent = watch(last);
    button.hidden = last === 0;
    button.addEventListener("click", () => this.#show(tried, last));
    return column;
  }

  /**
   * Plays a ball of a model's in the scene.
   * @param {TriedProposal[]} tried
   * @param {number} number
   */
  #show(tried, number) {
    this.byId("more").hidePopover();
    this.session?.preview(number, tried[number - 1].ball, true, true);
  }
}

/** @param {TriedProposal[]} tried */
function solvedAt(tried) {
  const index = tried.findIndex(({ ending }) => ending.solved);
  return index < 0 ? null : index + 1;
}

/** @param {TriedProposal[]} tried */
function outcomeWords(tried) {
  const solved = solvedAt(tried);
  const words = text.panels.modelPair;
  const ended = solved ? words.solved(solved) : words.missed(tried.length);
  const origin = tried[0]?.origin;
  return origin?.kind === "imagined" ? `${ended} ${words.guess(chanceWords(origin.probability))}` : ended;
}

/** @param {Side[]} sides */
function verdictOf(sides) {
  const attempts = sides.map(({ tried }) => solvedAt(tried) ?? Infinity);
  const [fewer, more] = attempts.toSorted((one, other) => one - other);
  const { name } = sides[attempts.indexOf(fewer)];
  const words = text.panels.modelPair;
  if (fewer === Infinity) return words.neither;
  if (more === Infinity) return words.only(name);
  return fewer === more ? words.both(fewer) : words.quicker(name, fewer, more);
}
