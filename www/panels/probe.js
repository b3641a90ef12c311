// The probe: reads all maps at one point of the scene. The point comes from the mouse or a finger over the scene or a
// small map, or from the arrow keys on a small map. Each small map marks it and shows its value; a note in the corner
// of the scene shows the values of the maps that lie over it.

import { Component } from "../widgets/component.js";
import { CELL_SIZE, MAPS, SCENE_SIZE } from "../shell/constants.js";
import { find, setText } from "../widgets/dom.js";
import { valueAt } from "../model/map-summary.js";
import { MAP_TEXT } from "../model/map-text.js";
import { ARROW_KEYS } from "../play/gestures.js";

/** @typedef {import("../pkg/pathlight.js").MapName} MapName */

/** How far an arrow key moves the point: a cell, with Shift eight. px */
const KEY_STEP = CELL_SIZE;
const LARGE_KEY_STEP = 8 * CELL_SIZE;
/** The largest coordinate inside the scene, px. */
const LAST_COORDINATE = SCENE_SIZE - 0.01;

export class Probe extends Component {
  #imagine;
  /** @type {MapName[]} */
  #layers = [];
  /** @type {import("../state/url-state.js").Panel | null} */
  #panel = null;
  /**
   * px of the scene, or null.
   * @type {number[] | null}
   */
  #point = null;
  #rows;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("./imagine.js").Imagine} imagine
   */
  constructor(root, imagine) {
    super(root);
    this.#imagine = imagine;
    this.#rows = MAPS.map((mapName) => {
      const row = find(root, `[data-map=${mapName}]`);
      const map = find(row, ".map");
      map.setAttribute("aria-label", `${MAP_TEXT[mapName].name}: arrow keys read its values`);
      map.addEventListener("keydown", (event) => this.#onKeydown(event, mapName));
      this.#followPointer(map);
      return { mapName, map, value: find(row, ".value") };
    });
    this.#followPointer(this.byId("scene"));
    imagine.addEventListener("maps", () => this.#update());
  }

  /** @param {import("../play/session.js").Session} session */
  open(session) {
    super.open(session);
    // What a finger has left there must not lie over what runs.
    this.listen("change", ({ placing }) => !placing && this.#point && this.#clear());
  }

  close() {
    super.close();
    this.#clear();
  }

  /** @param {import("../state/view.js").View} view */
  setState({ layers, panel }) {
    this.#layers = layers;
    if (panel !== this.#panel) this.#point = null;
    this.#panel = panel;
    this.#update();
  }

  #clear() {
    this.#point = null;
    this.#update();
  }

  /** @param {HTMLElement} element */
  #followPointer(element) {
    /** @param {PointerEvent} event */
    const onPointer = (event) => this.#onPointer(event, element);
    element.addEventListener("pointerdown", onPointer);
    element.addEventListener("pointermove", onPointer);
    // A finger covers what it points at: the values stay when it is lifted.
    element.addEventListener("pointerleave", ({ pointerType }) => pointerType === "mouse" && this.#clear());
  }

  /**
   * @param {PointerEvent} event
   * @param {HTMLElement} element
   */
  #onPointer({ clientX, clientY }, element) {
    const box = element.getBoundingClientRect();
    /** @param {number} fraction */
    const toScene = (fraction) => Math.min(Math.max(fraction, 0), 1) * LAST_COORDINATE;
    this.#point = [toScene((clientX - box.left) / box.width), toScene((box.bottom - clientY) / box.height)];
    this.#update();
  }

  /**
   * @param {KeyboardEvent} event
   * @param {MapName} mapName
   */
  #onKeydown(event, mapName) {
    const direction = ARROW_KEYS[event.key];
    if (!direction || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    const distance = event.shiftKey ? LARGE_KEY_STEP : KEY_STEP;
    const from = this.#point ?? [SCENE_SIZE / 2, SCENE_SIZE / 2];
    const margin = CELL_SIZE / 2;
    this.#point = from.map((value, axis) =>
      Math.min(Math.max(value + direction[axis] * distance, margin), SCENE_SIZE - margin),
    );
    this.#update();
    this.announce(`${placeOf(this.#point)}: ${this.#valueOf(mapName, this.#point)}`);
  }

  /**
   * @param {MapName} mapName
   * @param {number[]} point
   */
  #valueOf(mapName, point) {
    const map = this.#imagine.maps?.[mapName];
    return map ? valueAt(map, point).toFixed(2) : "none";
  }

  #update() {
    const point = this.#imagine.maps && this.#point;
    for (const { mapName, map, value } of this.#rows) {
      setText(value, point ? `${this.#valueOf(mapName, point)} at ${placeOf(point)}` : "");
      map.toggleAttribute("data-probed", Boolean(point));
      if (!point) continue;
      map.style.setProperty("--x", String(point[0] / SCENE_SIZE));
      map.style.setProperty("--y", String(1 - point[1] / SCENE_SIZE));
    }
    const note = this.byId("probe");
    note.hidden = !point || this.#layers.length === 0;
    if (!point || note.hidden) return;
    // In the corner where the pointer is not.
    note.dataset.side = point[0] < SCENE_SIZE / 2 ? "right" : "left";
    const lines = this.#layers.flatMap((mapName) => [
      `${MAP_TEXT[mapName].name} ${this.#valueOf(mapName, point)}`,
      document.createElement("br"),
    ]);
    note.replaceChildren(...lines, placeOf(point));
  }
}

/** @param {number[]} point */
function placeOf(point) {
  const [x, y] = point.map(Math.round);
  return `x ${x}, y ${y}`;
}
