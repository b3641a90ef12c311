// Small canvases that are drawn when they scroll into sight, a few in each frame, so that a long list is there at once.
// What a canvas shows is up to whoever adds it.

import { contextOf } from "./dom.js";

/** How long one frame may draw, ms. */
const FRAME_BUDGET = 8;
/** More device pixels per CSS px than this cannot be told apart in a small picture. */
const MAX_PIXEL_RATIO = 3;

export class LazyThumbnails {
  #draw;
  /** @type {Set<HTMLCanvasElement>} */
  #canvases = new Set();
  #observer = new IntersectionObserver((entries) => this.#onVisible(entries), { rootMargin: "200px" });
  /** @type {Set<HTMLCanvasElement>} */
  #queue = new Set();
  #scheduled = false;

  /** @param {(context: CanvasRenderingContext2D, canvas: HTMLCanvasElement) => void} draw */
  constructor(draw) {
    this.#draw = draw;
  }

  /**
   * A canvas of `side` CSS px as sharp as the screen, which is drawn as soon as it can be seen.
   * @param {number} side
   */
  add(side) {
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = Math.round(side * Math.min(devicePixelRatio, MAX_PIXEL_RATIO));
    canvas.setAttribute("aria-hidden", "true");
    this.#canvases.add(canvas);
    this.#observer.observe(canvas);
    return canvas;
  }

  /**
   * Forgets a canvas: it is not drawn any more.
   * @param {HTMLCanvasElement} canvas
   */
  remove(canvas) {
    this.#observer.unobserve(canvas);
    this.#queue.delete(canvas);
    this.#canvases.delete(canvas);
  }

  /** Forgets all canvases: none of them is drawn any more. */
  clear() {
    this.#observer.disconnect();
    this.#queue.clear();
    this.#canvases.clear();
  }

  /** Draws all canvases again, as they come into sight. */
  redraw() {
    for (const canvas of this.#canvases) {
      this.#observer.unobserve(canvas);
      this.#observer.observe(canvas);
    }
  }

  /** @param {IntersectionObserverEntry[]} entries */
  #onVisible(entries) {
    for (const { isIntersecting, target } of entries) {
      const canvas = /** @type {HTMLCanvasElement} */ (target);
      // An entry may be delivered after `clear`.
      if (!isIntersecting || !this.#canvases.has(canvas)) continue;
      this.#observer.unobserve(canvas);
      this.#queue.add(canvas);
    }
    this.#schedule();
  }

  #schedule() {
    if (this.#scheduled || this.#queue.size === 0) return;
    this.#scheduled = true;
    requestAnimationFrame(() => {
      this.#scheduled = false;
      this.#drawSome();
    });
  }

  #drawSome() {
    const end = performance.now() + FRAME_BUDGET;
    try {
      for (const canvas of this.#queue) {
        this.#queue.delete(canvas);
        this.#draw(contextOf(canvas), canvas);
        canvas.classList.add("drawn");
        if (performance.now() > end) break;
      }
    } finally {
      // If one cannot be drawn, the others are.
      this.#schedule();
    }
  }
}
