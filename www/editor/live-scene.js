// What follows a scene while it is being edited: the maps that the nets imagine, and the path of the green object
// alone. The worker answers the newest scene and leaves out those in between. Fires "live" when there is something else
// to show.

import { Component } from "../widgets/component.js";
import { GRID_SIDE, MAPS } from "../shell/constants.js";
import { contextOf, setText } from "../widgets/dom.js";
import { pathlight } from "../shell/page-api.js";
import { text } from "../text/text.js";
import { LatestCall } from "../model/latest-call.js";
import { summary } from "../model/map-summary.js";

/** @typedef {import("../pkg/pathlight.js").CustomScene} CustomScene */
/** @typedef {import("../pkg/pathlight.js").MapName} MapName */
/** @typedef {import("../model/worker.js").Watched} Watched */

export class LiveScene extends Component {
  /** May what the nets imagine be shown? */
  imagines = true;
  #client;
  /** @type {CustomScene | null} */
  #scene = null;
  /** @type {import("../pkg/pathlight.js").Maps | null} */
  #maps = null;
  /**
   * What the scene does without a ball.
   * @type {Watched | null}
   */
  #watched = null;
  /** @type {string | null} */
  #failure = null;
  #rows;
  #imagining;
  #watching;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../model/shared-client.js").SharedClient} client
   */
  constructor(root, client) {
    super(root);
    this.#client = client;
    this.#rows = MAPS.map((mapName) => this.#row(mapName));
    this.byId("make-maps").append(...this.#rows.map(({ element }) => element));
    /** @param {string} message */
    const onFailure = (message) => {
      this.#failure = message;
      this.#show();
    };
    this.#imagining = new LatestCall(
      (/** @type {CustomScene} */ scene, signal) => client.call("imagine", [scene], signal),
      ({ maps }) => {
        this.#maps = maps;
        this.#failure = null;
        this.#show();
      },
      onFailure,
    );
    this.#watching = new LatestCall(
      (/** @type {CustomScene} */ scene, signal) => client.call("watch", [scene], signal),
      (watched) => {
        this.#showWatched(watched);
      },
      onFailure,
    );
    client.addEventListener("change", () => this.#onClientChange());
  }

  /** The positions of the green object in the scene alone, x, y, x, y, … in px, or null. */
  get path() {
    return this.#watched?.path ?? null;
  }

  /** The canvases of the maps that are switched on. */
  get canvases() {
    return this.#maps && this.imagines ? this.#rows.flatMap(({ box, map }) => (box.checked ? [map.canvas] : [])) : [];
  }

  /**
   * Follows a scene.
   * @param {CustomScene} scene
   * @param {boolean} playable else there is nothing to simulate
   */
  follow(scene, playable) {
    this.#scene = playable ? scene : null;
    if (playable) {
      this.#ask();
    } else {
      this.#watching.stop();
      this.#showWatched(null);
    }
  }

  /** Forgets the scene, and what was imagined of it. */
  clear() {
    this.#imagining.stop();
    this.#watching.stop();
    this.#scene = null;
    this.#maps = null;
    this.#failure = null;
    this.#show();
    this.#showWatched(null);
  }

  /** @param {boolean} dark */
  setTheme(dark) {
    super.setTheme(dark);
    this.#show();
  }

  #ask() {
    if (!this.#scene) return;
    if (this.imagines && this.#client.status === "ready") this.#imagining.ask(this.#scene);
    if (this.#client.alive) this.#watching.ask(this.#scene);
  }

  #onClientChange() {
    if (this.#client.status !== "ready") {
      this.#imagining.stop();
      this.#maps = null;
    }
    if (!this.#client.alive) this.#watching.stop();
    this.#ask();
    this.#show();
  }

  /** @param {MapName} mapName */
  #row(mapName) {
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = GRID_SIDE;
    canvas.setAttribute("role", "img");
    const box = document.createElement("input");
    box.type = "checkbox";
    // What the nets expect of the scene alone, to compare with the line that it really takes.
    box.checked = mapName === "base";
    box.addEventListener("change", () => this.dispatchEvent(new Event("live")));
    const label = document.createElement("label");
    label.append(canvas, box, ` ${text.model.steps[mapName].name}`);
    const element = document.createElement("li");
    element.append(label);
    return { mapName, element, box, map: contextOf(canvas) };
  }

  /** @param {Watched | null} watched */
  #showWatched(watched) {
    this.#watched = watched;
    setText(this.byId("make-alone"), watched ? aloneWords(watched) : "");
    this.dispatchEvent(new Event("live"));
  }

  #show() {
    for (const { mapName, map, element } of this.#rows) {
      map.clearRect(0, 0, GRID_SIDE, GRID_SIDE);
      const values = this.#maps?.[mapName];
      element.hidden = this.#maps !== null && !values;
      if (values) pathlight.paintMap(map, mapName, values, { max: Math.max(...values), dark: this.dark });
      map.canvas.setAttribute(
        "aria-label",
        `${text.model.steps[mapName].name}: ${values ? summary(values) : text.editor.live.notYet}`,
      );
    }
    const { status, failure } = this.#client;
    const words = failure?.message ?? this.#failure ?? (status === "loading" ? text.panels.forecast.loading : "");
    setText(this.byId("make-maps-words"), words);
    this.dispatchEvent(new Event("live"));
  }
}

/** @param {Watched} watched */
function aloneWords({ path, solved }) {
  const { solvesItself, ends } = text.editor.live;
  const [x, y] = path.slice(-2);
  return solved ? solvesItself : ends(x, y);
}
