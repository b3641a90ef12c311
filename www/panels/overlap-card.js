// A small picture of the scene with a shade over it, imagined or drawn, and a line round the path that was real;
// below it what it is and how well the two overlap. Drawn by the wasm.

const percent = (share) => `${Math.round(100 * share)} %`;

export class Plate {
  element;
  #wasm;
  #layers;

  constructor(wasm) {
    this.#wasm = wasm;
    this.element = document.getElementById("plate").content.firstElementChild.cloneNode(true);
    this.#layers = [...this.element.querySelectorAll("canvas")].map((canvas) => canvas.getContext("2d"));
  }

  /** Draws `values` in the colours of `stage`, with the line round `real`; returns their overlap, 0..1. `name` says
   * what is shaded. */
  draw({ task, name, stage, values, real, dark }) {
    const [scene, shade, line] = this.#layers;
    this.#wasm.paintThumbnail(scene, task, dark);
    this.#wasm.paintMap(shade, stage, values, Math.max(...values), dark);
    line.clearRect(0, 0, line.canvas.width, line.canvas.height);
    this.#wasm.paintOutline(line, "real", real, dark);
    const share = this.#wasm.overlap(values, real);
    this.element.querySelector("b").textContent = percent(share);
    this.element.querySelector("span").textContent = name;
    line.canvas.setAttribute("aria-label", `${name}, and a line round the real path: they overlap by ${percent(share)}`);
    return share;
  }
}

export { percent };
