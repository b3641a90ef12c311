// What lies over the scene: what each component lays there, the later ones in place of the earlier, and the misses of
// the model's turn. Collects it and hands it to the canvas of the scene.

import { Component } from "../widgets/component.js";
import { find, setText } from "../widgets/dom.js";
import { factsOf } from "../state/panels.js";
import { text } from "../text/text.js";

/** The opacity of the paths of old misses. */
const GHOST = 0.2;
/** How many of the latest misses are more opaque than that. */
const RECENT = 5;

export class Overlays extends Component {
  #canvas;
  #components;
  /** @type {number | null} */
  #opacity = null;

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

  /** @param {import("../state/view.js").View} view */
  setState({ panel, tab, opacity, layers }) {
    // In Play nothing else says which maps they are.
    const laid = tab === "play" ? layers : [];
    this.byId("laid").hidden = laid.length === 0;
    const names = laid.map((mapName) => text.model.steps[mapName].name);
    setText(find(this.byId("laid"), "span"), text.panels.laid(names));
    this.#opacity = opacity;
    this.session?.edit({ tool: factsOf(panel).tool ?? "ball" });
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
    if (this.#opacity === null) return;
    const overlays = [...this.#components, this].map((component) => component.overlay);
    this.#canvas.setOverlay(Object.assign({ opacity: this.#opacity }, ...overlays));
  }
}
