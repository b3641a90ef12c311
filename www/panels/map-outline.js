// The outline of what is strong in a map, to lie over the whole scene. Its canvas is made when it is first asked for,
// because it is large and most are not asked for.

import { paintOutline } from "../pkg/pathlight.js";
import { contextOf } from "../widgets/dom.js";

/** Width of the canvas. */
const SIDE = 1024;

export class MapOutline {
  #mapName;
  /** @type {CanvasRenderingContext2D | null} */
  #context = null;
  /** @type {Float32Array | undefined} */
  #values;
  #dark = false;

  /** @param {import("../pkg/pathlight.js").MapName} mapName */
  constructor(mapName) {
    this.#mapName = mapName;
  }

  /**
   * @param {Float32Array | undefined} values undefined if there is no such map
   * @param {boolean} dark
   */
  draw(values, dark) {
    this.#values = values;
    this.#dark = dark;
    if (this.#context) this.#paint(this.#context);
  }

  get canvas() {
    if (!this.#context) {
      const canvas = document.createElement("canvas");
      canvas.width = canvas.height = SIDE;
      this.#context = contextOf(canvas);
      this.#paint(this.#context);
    }
    return this.#context.canvas;
  }

  /** @param {CanvasRenderingContext2D} context */
  #paint(context) {
    context.clearRect(0, 0, SIDE, SIDE);
    if (!this.#values) return;
    const most = Math.max(...this.#values);
    const shares = this.#values.map((value) => value / most);
    paintOutline(context, this.#mapName, shares, this.#dark);
  }
}
