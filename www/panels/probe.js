// The value under the pointer: one point of the scene, read from all maps at once. The point comes from the
// mouse or a finger over the scene or a small map, or from the arrow keys on a small map. Each small map marks
// it and says its value; a note in the corner of the scene says those of the maps that lie over it.

import { say } from "../shell/announce.js";
import { STAGES } from "../shell/url-state.js";
import { WORDS, valueAt } from "../model/stages.js";

const at = (id) => document.getElementById(id);
const SIZE = 256;
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

export class Reading {
  #imagine;
  #layers = [];
  /** [x, y] in px of the scene, or null. */
  #point = null;
  #rows;

  constructor(imagine) {
    this.#imagine = imagine;
    this.#rows = STAGES.map((stage) => {
      const row = document.querySelector(`[data-stage=${stage}]`);
      const map = row.querySelector(".map");
      map.setAttribute("aria-label", `${WORDS[stage].name}: arrow keys read its values`);
      map.addEventListener("keydown", (event) => this.#key(event, stage));
      this.#listen(map);
      return { stage, map, value: row.querySelector(".value") };
    });
    this.#listen(at("scene"));
    imagine.addEventListener("imagined", () => this.#show());
  }

  /** Another puzzle is on: no point is read. */
  clear() {
    this.#point = null;
    this.#show();
  }

  set({ layers }) {
    this.#layers = layers;
    this.#show();
  }

  #listen(element) {
    for (const what of ["pointerdown", "pointermove"]) element.addEventListener(what, (event) => this.#move(event, element));
    // A finger covers what it points at: its reading stays when it is lifted.
    element.addEventListener("pointerleave", ({ pointerType }) => pointerType === "mouse" && this.clear());
  }

  #move({ clientX, clientY }, element) {
    const box = element.getBoundingClientRect();
    const inside = (share) => Math.min(Math.max(share, 0), 1) * (SIZE - 0.01);
    this.#point = [inside((clientX - box.left) / box.width), inside((box.bottom - clientY) / box.height)];
    this.#show();
  }

  #key(event, stage) {
    const by = ARROWS[event.key];
    if (!by || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    const far = event.shiftKey ? 32 : 4;
    const from = this.#point ?? [SIZE / 2, SIZE / 2];
    this.#point = from.map((value, axis) => Math.min(Math.max(value + by[axis] * far, 2), SIZE - 2));
    this.#show();
    say(`${this.#place()}: ${this.#value(stage)}`);
  }

  #place() {
    const [x, y] = this.#point.map(Math.round);
    return `x ${x}, y ${y}`;
  }

  #value(stage) {
    const map = this.#imagine.values[stage];
    return map ? valueAt(map, this.#point).toFixed(2) : "none";
  }

  #show() {
    const point = this.#imagine.values && this.#point;
    for (const { stage, map, value } of this.#rows) {
      value.textContent = point ? `${this.#value(stage)} at ${this.#place()}` : "";
      map.toggleAttribute("data-read", Boolean(point));
      if (!point) continue;
      map.style.setProperty("--x", point[0] / SIZE);
      map.style.setProperty("--y", 1 - point[1] / SIZE);
    }
    const note = at("reading");
    note.hidden = !point || this.#layers.length === 0;
    if (note.hidden) return;
    // In the corner where the pointer is not.
    note.dataset.side = point[0] < SIZE / 2 ? "right" : "left";
    note.replaceChildren(...this.#layers.flatMap((stage) => [`${WORDS[stage].name} ${this.#value(stage)}`, document.createElement("br")]), this.#place());
  }
}
