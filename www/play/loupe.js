// A loupe beside the finger that drags the ball: what the finger covers, twice as large.

import { SCENE_SIZE } from "../shell/constants.js";
import { contextOf } from "../widgets/dom.js";

/** @typedef {import("./canvas.js").Point} Point */

/** How many times as large as in the scene. */
const MAGNIFIED = 2;
/** How far its middle is from the finger, CSS px: a finger is some 50 wide. */
const AWAY = 96;

export class Loupe {
  #canvas;
  #scene;
  /**
   * What it shows, or null if it is put away.
   * @type {Point | null}
   */
  #point = null;

  /**
   * @param {HTMLCanvasElement} canvas its own, in the same place as that of the scene
   * @param {HTMLCanvasElement} scene
   */
  constructor(canvas, scene) {
    this.#canvas = canvas;
    this.#scene = scene;
  }

  /**
   * Shows a point of the scene; null puts it away.
   * @param {Point | null} point
   */
  show(point) {
    this.#point = point;
    this.#canvas.hidden = point === null;
    if (!point) return;
    const { clientWidth: width, clientHeight: height } = this.#scene;
    const [x, y] = [(point[0] / SCENE_SIZE) * width, (1 - point[1] / SCENE_SIZE) * height];
    const half = this.#canvas.clientWidth / 2;
    // Above the finger; near the upper edge beside it, on the side where there is room.
    const above = y - AWAY >= half;
    const beside = x > width / 2 ? x - AWAY : x + AWAY;
    this.#canvas.style.left = `${Math.min(Math.max(above ? x : beside, half), width - half) - half}px`;
    this.#canvas.style.top = `${Math.max(above ? y - AWAY : y, half) - half}px`;
    this.draw();
  }

  /** Draws again what the scene shows there. */
  draw() {
    if (!this.#point) return;
    const side = this.#scene.width;
    const perPx = side / SCENE_SIZE;
    const size = Math.round((this.#canvas.clientWidth * side) / this.#scene.clientWidth);
    if (this.#canvas.width !== size) this.#canvas.width = this.#canvas.height = size;
    const [x, y] = [this.#point[0] * perPx, (SCENE_SIZE - this.#point[1]) * perPx];
    const seen = size / MAGNIFIED;
    const context = contextOf(this.#canvas);
    context.clearRect(0, 0, size, size);
    context.drawImage(this.#scene, x - seen / 2, y - seen / 2, seen, seen, 0, 0, size, size);
  }
}
