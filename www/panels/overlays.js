// What lies over the scene: the maps that are switched on, the map of all solutions, the marks of the model's
// proposals, the paths that it imagines for a ball, and the line of a prediction. Collects them from the panels and
// hands them to the canvas of the scene.

import { Component } from "../widgets/component.js";

/** The opacity of the paths of old misses. */
const GHOST = 0.2;
/** How many of the latest misses are more opaque than that. */
const RECENT = 5;
/**
 * The panel of the editor, which comes after this folder.
 * @typedef {EventTarget & { maps: HTMLCanvasElement[], painter: import("../play/canvas.js").Painter | null, pen:
 *   import("../play/gestures.js").Pen }} Editor
 */

export class Overlays extends Component {
  #editor;
  #canvas;
  #choice;
  #forecast;
  #imagine;
  #predict;
  #proposals;
  #solveMap;
  /** @type {import("../state/view.js").View | null} */
  #view = null;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../play/canvas.js").SceneCanvas} canvas
   * @param {object} panels
   * @param {Editor} panels.editor
   * @param {import("./choice.js").Choice} panels.choice
   * @param {import("./forecast.js").Forecast} panels.forecast
   * @param {import("./imagine.js").Imagine} panels.imagine
   * @param {import("./predict.js").Predict} panels.predict
   * @param {import("./proposals.js").Proposals} panels.proposals
   * @param {import("./solve-map.js").SolveMapPanel} panels.solveMap
   */
  constructor(root, canvas, { editor, choice, forecast, imagine, predict, proposals, solveMap }) {
    super(root);
    this.#editor = editor;
    this.#canvas = canvas;
    this.#choice = choice;
    this.#forecast = forecast;
    this.#imagine = imagine;
    this.#predict = predict;
    this.#proposals = proposals;
    this.#solveMap = solveMap;
    editor.addEventListener("edit", () => this.#update());
    choice.addEventListener("choice", () => this.#update());
    forecast.addEventListener("forecast", () => this.#update());
    imagine.addEventListener("maps", () => this.#update());
    predict.addEventListener("sketch", () => this.#update());
    proposals.addEventListener("imagined", () => this.#update());
    solveMap.addEventListener("map", () => this.#update());
  }

  /** @param {import("../play/session.js").Session} session */
  open(session) {
    super.open(session);
    this.listen("change", () => this.#update());
  }

  /** @param {import("../state/view.js").View} view */
  setState(view) {
    this.#view = view;
    this.session?.edit({ tool: view.panel === "predict" ? "line" : view.panel === "make" ? "bodies" : "ball" });
    this.#update();
  }

  #update() {
    if (!this.#view) return;
    const { panel, opacity, layers } = this.#view;
    // The origin of a proposal is seen on the map that orders the proposals, if a map does.
    const source = this.#proposals.able ? [] : [this.#imagine.maps?.success ? "success" : "placement"];
    const mapNames = this.#proposals.active ? source : layers;
    const drawing = panel === "predict";
    const ghosts = this.session?.ghosts ?? [];
    const editing = panel === "make";
    const maps = editing
      ? this.#editor.maps
      : [
          ...this.#solveMap.canvases,
          ...this.#imagine.canvasesOf(/** @type {import("../pkg/pathlight.js").MapName[]} */ (mapNames)),
        ];
    this.#canvas.setOverlay(
      {
        maps,
        opacity,
        marks: [...this.#proposals.marks, ...ghosts.map(({ ball }) => ({ ball, from: null, chosen: false }))],
        sketch: drawing ? this.#predict.sketch : [],
        imagined: this.#forecast.paths ?? this.#proposals.paths,
        hints: ghosts.map(({ object }, index) => ({
          object,
          opacity: Math.max(GHOST, 1 - (ghosts.length - index) / RECENT),
          tried: true,
        })),
        painter: editing ? this.#editor.painter : null,
        ...this.#choice.overlay,
      },
      drawing ? this.#predict : editing ? this.#editor.pen : null,
    );
  }
}
