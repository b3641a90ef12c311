// Small pictures that are drawn when they come into sight, a few at a time, so that a long list is there at once.
// What a picture shows is up to whoever adds it.

/** How long one frame may draw, ms. */
const SLICE = 8;

export class Pictures {
  #draw;
  #all = new Set();
  #seen = new IntersectionObserver((entries) => this.#look(entries), { rootMargin: "200px" });
  #queue = new Set();

  /** `draw`: draws what belongs on a canvas. */
  constructor(draw) {
    this.#draw = draw;
  }

  /** A canvas as sharp as the screen, `side` CSS px wide, which is drawn as soon as it can be seen. */
  add(side) {
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = Math.round(side * Math.min(devicePixelRatio, 3));
    canvas.setAttribute("aria-hidden", "true");
    this.#all.add(canvas);
    this.#seen.observe(canvas);
    return canvas;
  }

  /** Forgets all pictures. */
  clear() {
    this.#seen.disconnect();
    this.#queue.clear();
    this.#all.clear();
  }

  /** Draws all afresh, as they come into sight. */
  redraw() {
    for (const canvas of this.#all) {
      this.#seen.unobserve(canvas);
      this.#seen.observe(canvas);
    }
  }

  #look(entries) {
    const waiting = this.#queue.size > 0;
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      this.#seen.unobserve(target);
      this.#queue.add(target);
    }
    if (!waiting && this.#queue.size > 0) this.#some();
  }

  #some = () => {
    const end = performance.now() + SLICE;
    for (const canvas of this.#queue) {
      this.#queue.delete(canvas);
      this.#draw(canvas);
      canvas.classList.add("drawn");
      if (performance.now() > end) break;
    }
    if (this.#queue.size > 0) requestAnimationFrame(this.#some);
  };
}
