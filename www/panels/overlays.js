// What lies over the scene: what each component lays there, the later ones in place of the earlier, and the misses of
// the model's turn. Collects it and hands it to the canvas of the scene, and keeps the legend of it in Play.

import { paintLegend } from "../pkg/pathlight.js";
import { MAPS } from "../shell/constants.js";
import { Component } from "../widgets/component.js";
import { contextOf, find } from "../widgets/dom.js";
import { factsOf } from "../state/panels.js";

/** The opacity of the paths of old misses. */
const GHOST = 0.2;
/** How many of the latest misses are more opaque than that. */
const RECENT = 5;

export class Overlays extends Component {
  #canvas;
  #components;
  /** @type {import("../state/view.js").View | null} */
  #view = null;
  #legend = this.byId("laid");
  /** Does the legend name the paths that are imagined for a ball? */
  #guess = false;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../play/canvas.js").SceneCanvas} canvas
   * @param {Component[]} components
   */
  constructor(root, canvas, components) {
    super(root);
    this.#canvas = canvas;
    this.#components = components;
    for (const component of components) component.addEventListener("overlay", () => this.#update());
    this.byId("laid-off").addEventListener("click", () => {
      this.requestState({ layers: null });
      this.byId("scene").focus({ preventScroll: true });
    });
  }

  /** @param {import("../play/session.js").Session} session */
  open(session) {
    super.open(session);
    this.listen("change", () => this.#update());
  }

  /** @param {boolean} dark */
  setTheme(dark) {
    super.setTheme(dark);
    for (const mapName of MAPS)
      paintLegend(contextOf(find(this.#legend, `[data-of=${mapName}] canvas`, HTMLCanvasElement)), mapName, dark);
  }

  /** @param {import("../state/view.js").View} view */
  setState(view) {
    this.#view = view;
    this.session?.edit({ tool: factsOf(view.panel).tool ?? "ball" });
    this.#update();
  }

  /** The misses before the one that the model tries now. */
  get overlay() {
    const ghosts = this.session?.ghosts;
    if (!ghosts) return null;
    return {
      marks: ghosts.map(({ ball }) => ({ ball, from: null, chosen: false })),
      hints: ghosts.map(({ object }, index) => ({
        object,
        opacity: Math.max(GHOST, 1 - (ghosts.length - index) / RECENT),
        tried: true,
      })),
    };
  }

  #update() {
    if (!this.#view) return;
    const { opacity, tab, layers, forecast } = this.#view;
    const overlays = [...this.#components, this].map((component) => component.overlay);
    /** @type {Partial<import("../play/canvas.js").Overlay>} */
    const overlay = Object.assign({ opacity }, ...overlays);
    this.#canvas.setOverlay(overlay);
    // It stays while the ball is dragged over where it may not be: what is below must not jump.
    const isDragged = forecast && this.session?.placing && this.session.ball;
    this.#guess = Boolean(overlay.imagined || (this.#guess && isDragged));
    /** @type {(string | undefined)[]} */
    const shown = [...layers, ...(this.#guess ? ["guess"] : [])];
    // The other panels say themselves which maps they are. With the guess switched on it is there from the beginning,
    // empty: the tabs below must not jump when the first guess comes.
    this.#legend.hidden = tab !== "play" || !(forecast || shown.length > 0);
    this.byId("laid-off").hidden = layers.length === 0;
    for (const entry of this.#legend.querySelectorAll("li")) entry.hidden = !shown.includes(entry.dataset.of);
  }
}
