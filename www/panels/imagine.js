// The Imagine panel: the maps of the open puzzle, each with a sentence, a legend and a switch that lays it over the
// scene. Other components read the maps here; "maps" is fired when they have come or gone, "switch" when the person
// switches one on or off.

import { paintLegend } from "../pkg/pathlight.js";
import { pauseIfLong } from "../loading/next-task.js";
import { Component } from "../widgets/component.js";
import { GRID_SIDE, MAPS, PAPER_MAPS } from "../shell/constants.js";
import { contextOf, find, setText } from "../widgets/dom.js";
import { pathlight } from "../shell/page-api.js";
import { summary } from "../model/map-summary.js";
import { mapWords } from "../model/place-words.js";
import { ballNetOf } from "../model/ball-net.js";
import { sentence } from "../text/sentence.js";
import { text } from "../text/text.js";
import { MapOutline } from "./map-outline.js";
import { TroubleBox } from "./trouble-box.js";

/** @typedef {import("../pkg/pathlight.js").MapName} MapName */
/** @typedef {import("../model/worker.js").Imagined} Imagined */

/**
 * How many maps are shaded over the scene; of more only the outlines can be told apart. A person switches on no more: a
 * third replaces the oldest.
 */
const MAX_SHADED = 2;

export class Imagine extends Component {
  #client;
  #scenePicture;
  /** @type {Record<MapName, ReturnType<Imagine["createRow"]>>} */
  #rows;
  /**
   * The maps that are switched on, the oldest first.
   * @type {MapName[]}
   */
  #checked = [];
  /**
   * The maps that lie over the scene.
   * @type {MapName[]}
   */
  #layers = [];
  /** @type {Imagined | null} */
  #imagined = null;
  #trouble = new TroubleBox(this.byId("imagine-trouble"));
  /**
   * The call to the worker that counts.
   * @type {AbortController | null}
   */
  #call = null;
  /** @type {string | null} */
  failure = null;
  /** Is the panel seen? */
  #shown = false;
  /** Do the pictures under the maps show the open puzzle? They are drawn when the panel is seen. */
  #scenesDrawn = false;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../model/shared-client.js").SharedClient} client
   * @param {import("./scene-picture.js").ScenePicture} scenePicture
   */
  constructor(root, client, scenePicture) {
    super(root);
    this.#client = client;
    this.#scenePicture = scenePicture;
    const rows = MAPS.map((mapName) => /** @type {const} */ ([mapName, this.createRow(mapName)]));
    this.#rows = /** @type {Record<MapName, ReturnType<Imagine["createRow"]>>} */ (Object.fromEntries(rows));
    this.byId("maps").replaceChildren(...MAPS.map((mapName) => this.#rows[mapName].element));
    client.addEventListener("change", () => this.#onClientChange());
  }

  /** @param {import("../play/session.js").Session} session */
  open(session) {
    super.open(session);
    // Asked for first: the worker imagines while the page draws.
    this.request();
    this.#scenesDrawn = false;
  }

  close() {
    super.close();
    this.#call?.abort();
    this.#setImagined(null);
  }

  /** @param {import("../state/view.js").View} view */
  setState(view) {
    this.#shown = view.panel === "imagine";
    this.#layers = view.layers;
    this.#paintScenes();
    const added = view.checkedLayers.filter((mapName) => !this.#checked.includes(mapName));
    this.#checked = [...this.#checked.filter((mapName) => view.checkedLayers.includes(mapName)), ...added];
    for (const mapName of MAPS) {
      const { box, element } = this.#rows[mapName];
      box.checked = this.#checked.includes(mapName);
      element.classList.toggle("on", box.checked);
    }
    this.byId("outlines-note").hidden = view.checkedLayers.length <= MAX_SHADED;
  }

  /** @param {boolean} dark */
  setTheme(dark) {
    super.setTheme(dark);
    for (const mapName of MAPS) paintLegend(this.#rows[mapName].legend, mapName, dark);
    this.#scenesDrawn = false;
    this.#paintScenes();
    for (const mapName of MAPS) this.#paintMap(mapName);
    this.#tellTime();
  }

  get overlay() {
    return { maps: this.canvasesOf(this.#layers) };
  }

  /** The maps of the open puzzle; null until they have been imagined. */
  get maps() {
    return this.#imagined?.maps ?? null;
  }

  /** Was the model trained on the open puzzle? Null until it is known. */
  get seen() {
    return this.#imagined?.seen ?? null;
  }

  /**
   * What a map shows, in words of the scene; empty if there is no such map.
   * @param {MapName} mapName
   */
  words(mapName) {
    const map = this.#imagined?.maps[mapName];
    return map && this.session ? mapWords(map, pathlight.scene(this.session.puzzle)) : "";
  }

  /**
   * The canvases to lay over the scene for some maps: the first ones shaded, and outlines of what is strong in all.
   * @param {MapName[]} mapNames
   */
  canvasesOf(mapNames) {
    if (!this.#imagined) return [];
    return mapNames.flatMap((mapName, index) => {
      const { map, outline } = this.#rows[mapName];
      return index < MAX_SHADED ? [map.canvas, outline.canvas] : [outline.canvas];
    });
  }

  /**
   * Leaves only some maps in the panel; for null all.
   * @param {MapName[] | null} mapNames
   */
  showOnly(mapNames) {
    const maps = this.byId("maps");
    maps.hidden = mapNames?.length === 0;
    maps.classList.toggle("alone", mapNames !== null);
    for (const mapName of MAPS) this.#rows[mapName].element.hidden = mapNames?.includes(mapName) === false;
  }

  /**
   * The person switches a map on or off.
   * @param {MapName} mapName
   * @param {boolean} on
   */
  #toggle(mapName, on) {
    const others = this.#checked.filter((other) => other !== mapName);
    const checked = on ? [...others.slice(-(MAX_SHADED - 1)), mapName] : others;
    this.dispatchEvent(new Event("switch"));
    this.requestState({ layers: MAPS.filter((one) => checked.includes(one)) });
  }

  /** @param {MapName} mapName */
  createRow(mapName) {
    const words = text.model.steps[mapName];
    const element = this.fromTemplate("map-row");
    element.dataset.map = mapName;
    find(element, "b").textContent = words.name;
    find(element, ".meaning").textContent = words.meaning;
    const how = find(element, ".how");
    how.textContent = words.how;
    const box = find(element, "input", HTMLInputElement);
    box.addEventListener("change", () => this.#toggle(mapName, box.checked));
    // The small map is its switch too; keys have the box.
    find(element, ".map").addEventListener("click", () => this.#toggle(mapName, !box.checked));
    return {
      element,
      box,
      scene: find(element, ".scene-layer", HTMLCanvasElement),
      map: contextOf(find(element, ".shade-layer", HTMLCanvasElement)),
      outline: new MapOutline(mapName),
      legend: contextOf(find(element, ".legend", HTMLCanvasElement)),
      how,
      peak: find(element, ".peak"),
      summary: find(element, ".summary"),
      numbers: find(element, ".numbers"),
    };
  }

  #onClientChange() {
    const { status, progress, loaded } = this.#client;
    this.byId("imagine-body").hidden = status === "failed";
    this.byId("imagine-loading").hidden = status !== "loading";
    const bar = find(this.byId("imagine-loading"), "progress", HTMLProgressElement);
    if (progress === null) bar.removeAttribute("value");
    else bar.value = progress;
    if (status === "ready") {
      if (loaded) this.#onLoaded(loaded);
      this.request();
    } else {
      this.#call?.abort();
      this.failure = null;
      this.#setImagined(null);
      this.#updateTrouble();
    }
  }

  /**
   * Says how the model makes its maps.
   * @param {import("../model/worker.js").LoadedModel} loaded
   */
  #onLoaded({ card }) {
    const ballNet = ballNetOf(card);
    for (const mapName of MAPS) {
      if (PAPER_MAPS.includes(mapName)) continue;
      const { how } = text.model.steps[mapName];
      setText(this.#rows[mapName].how, ballNet ? `${how} ${text.model.nets.how[ballNet]}` : how);
    }
  }

  /** Asks for the maps again, as after a failure. */
  async request() {
    this.#call?.abort();
    if (!this.session || this.#client.status !== "ready") return;
    const call = (this.#call = new AbortController());
    this.failure = null;
    this.#updateTrouble();
    try {
      const imagined = await this.#client.call("imagine", [this.session.puzzle], call.signal);
      if (!call.signal.aborted) this.#setImagined(imagined);
    } catch (error) {
      if (call.signal.aborted) return;
      this.failure = /** @type {Error} */ (error).message;
      this.dispatchEvent(new Event("failure"));
      this.#updateTrouble();
    }
  }

  #updateTrouble() {
    this.#trouble.update(this.#client, this.failure, {
      restartModel: () => this.requestModel(),
      repeatCall: () => this.request(),
    });
  }

  /**
   * Shows new maps one by one, so that the page answers meanwhile; what is taken away goes at once.
   * @param {Imagined | null} imagined
   */
  async #setImagined(imagined) {
    if (imagined === this.#imagined) return;
    this.#imagined = imagined;
    for (const mapName of MAPS) {
      if (imagined) await pauseIfLong();
      if (imagined !== this.#imagined) return;
      this.#paintMap(mapName);
    }
    this.#tellTime();
    this.dispatchEvent(new Event("maps"));
    this.changeOverlay();
  }

  /** Draws the scene that lies under each map. */
  #paintScenes() {
    if (!this.#shown || this.#scenesDrawn || !this.session) return;
    this.#scenesDrawn = true;
    for (const mapName of MAPS) this.#scenePicture.drawOn(this.#rows[mapName].scene);
  }

  /** @param {MapName} mapName */
  #paintMap(mapName) {
    const { noMap, notYet, described, inNumbers } = text.panels.imagine;
    const { map, outline, peak, summary: said, numbers } = this.#rows[mapName];
    const values = this.#imagined?.maps[mapName];
    map.clearRect(0, 0, GRID_SIDE, GRID_SIDE);
    // Each map is drawn up to its own peak, which the legend names.
    const most = values ? Math.max(...values) : 0;
    if (values) pathlight.paintMap(map, mapName, values, { max: most, dark: this.dark });
    outline.draw(values, this.dark);
    setText(peak, values ? text.format.number(most, 2) : "");
    // Weights may come without a net that scores balls.
    const words = this.words(mapName) || (this.#imagined ? noMap : notYet);
    map.canvas.setAttribute("aria-label", described(text.model.steps[mapName].name, words));
    setText(said, sentence(words));
    setText(numbers, values ? inNumbers(summary(values)) : "");
  }

  #tellTime() {
    const { took } = text.panels.imagine;
    setText(this.byId("imagined-in"), this.#imagined ? took(Math.max(1, this.#imagined.milliseconds)) : "");
  }
}
