// A small picture of the scene with a shade over it, predicted or drawn, and a line round the real path; below it what
// it is and how well the two overlap.

import { paintOutline } from "../pkg/pathlight.js";
import { contextOf, find } from "../widgets/dom.js";
import { pathlight } from "../shell/page-api.js";
import { text } from "../text/text.js";

export class OverlapCard {
  element;
  #scene;
  #scenePicture;
  #shade;
  #outline;

  /**
   * @param {HTMLElement} element a copy of the template "overlap-card"
   * @param {import("./scene-picture.js").ScenePicture} scenePicture
   */
  constructor(element, scenePicture) {
    this.element = element;
    this.#scenePicture = scenePicture;
    this.#scene = find(this.element, ".scene-layer", HTMLCanvasElement);
    this.#shade = contextOf(find(this.element, ".shade-layer", HTMLCanvasElement));
    this.#outline = contextOf(find(this.element, ".outline-layer", HTMLCanvasElement));
  }

  /**
   * Draws a map in its colours and the outline of the real path; returns their overlap, 0..1.
   * @param {object} what
   * @param {string} what.name what is shaded
   * @param {import("../pkg/pathlight.js").MapName} what.mapName
   * @param {Float32Array} what.values
   * @param {Float32Array} what.real
   * @param {boolean} what.dark
   */
  draw({ name, mapName, values, real, dark }) {
    const { canvas } = this.#outline;
    this.#scenePicture.drawOn(this.#scene);
    pathlight.paintMap(this.#shade, mapName, values, { max: Math.max(...values), dark });
    this.#outline.clearRect(0, 0, canvas.width, canvas.height);
    paintOutline(this.#outline, "real", real, dark);
    const fraction = pathlight.softIou(values, real);
    find(this.element, "b").textContent = text.format.percent(fraction);
    find(this.element, "span").textContent = name;
    canvas.setAttribute("aria-label", text.panels.overlap(name, fraction));
    return fraction;
  }
}
