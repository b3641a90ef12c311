// The scene of the open puzzle as a small picture, which lies under the maps. It is drawn once for each puzzle and
// theme, and copied from there.

import { Component } from "../widgets/component.js";
import { SCENE_SIZE } from "../shell/constants.js";
import { contextOf } from "../widgets/dom.js";

export class ScenePicture extends Component {
  #canvas = document.createElement("canvas");
  #fresh = false;

  /** @param {import("../widgets/dom.js").Root} root */
  constructor(root) {
    super(root);
    this.#canvas.width = this.#canvas.height = SCENE_SIZE;
  }

  /** @param {import("../play/session.js").Session} session */
  open(session) {
    super.open(session);
    this.#fresh = false;
  }

  /** @param {boolean} dark */
  setTheme(dark) {
    super.setTheme(dark);
    this.#fresh = false;
  }

  /**
   * Copies the picture over a whole canvas.
   * @param {HTMLCanvasElement} canvas
   */
  drawOn(canvas) {
    if (!this.session) return;
    if (!this.#fresh) {
      const context = contextOf(this.#canvas);
      context.clearRect(0, 0, SCENE_SIZE, SCENE_SIZE);
      this.session.puzzle.paintThumbnail(context, this.dark);
      this.#fresh = true;
    }
    const context = contextOf(canvas);
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.drawImage(this.#canvas, 0, 0, canvas.width, canvas.height);
  }
}
