// The grid of templates, each with the scene of its first puzzle. Scenes are drawn when they come into sight,
// a few at a time, so that the page is there at once.

/** Width of a thumbnail, CSS px; the style sheet may show it smaller. */
const SIDE = 176;

export class Gallery {
  #list;
  #wasm;
  #seen = new IntersectionObserver((entries) => this.#look(entries), { rootMargin: "200px" });
  #queue = [];
  #drawing = false;
  dark = false;

  /** `templates`: as the wasm lists them. */
  constructor(list, wasm, templates) {
    this.#list = list;
    this.#wasm = wasm;
    list.replaceChildren(...templates.map((template) => this.#item(template)));
  }

  /** Draws all thumbnails afresh, as they come into sight. */
  redraw() {
    for (const canvas of this.#list.querySelectorAll("canvas")) {
      this.#seen.unobserve(canvas);
      this.#seen.observe(canvas);
    }
  }

  #item({ name, story, tasks: [first] }) {
    const link = document.createElement("a");
    link.href = `#task=${first}`;
    const canvas = document.createElement("canvas");
    canvas.dataset.task = first;
    canvas.width = canvas.height = Math.round(SIDE * Math.min(devicePixelRatio, 2));
    canvas.setAttribute("aria-hidden", "true");
    const title = document.createElement("strong");
    title.textContent = name;
    const text = document.createElement("span");
    text.textContent = story;
    link.append(canvas, title, text);
    const item = document.createElement("li");
    item.append(link);
    return item;
  }

  #look(entries) {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      this.#seen.unobserve(target);
      this.#queue.push(target);
    }
    if (!this.#drawing) this.#draw();
  }

  #draw = () => {
    const end = performance.now() + 8;
    while (this.#queue.length && performance.now() < end) {
      const canvas = this.#queue.shift();
      this.#wasm.paintThumbnail(canvas.getContext("2d"), canvas.dataset.task, this.dark);
      canvas.classList.add("drawn");
    }
    this.#drawing = this.#queue.length > 0;
    if (this.#drawing) requestAnimationFrame(this.#draw);
  };
}
