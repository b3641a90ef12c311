// Saves the strip of a puzzle as a picture: the task, what the nets imagine, and what the scene shows, side by side.

import { palette } from "../pkg/pathlight.js";
import { Component } from "../widgets/component.js";
import { GRID_SIDE, MAPS } from "../shell/constants.js";
import { contextOf } from "../widgets/dom.js";
import { download, fileName } from "../widgets/download.js";
import { pathlight } from "../shell/page-api.js";
import { text } from "../text/text.js";
import { paintStill } from "../play/still.js";

/** Width and height of one picture, the space around it, and the height of the title and of a name, pixels. */
const SIDE = 320;
const GAP = 16;
const HEAD = 60;
const FOOT = 44;
/** Opacity of the scene below a map. */
const BELOW = 0.35;

/** @typedef {import("../play/session.js").Session} Session */
/** @typedef {{ name: string, paint: (context: CanvasRenderingContext2D) => void }} Cell */

export class StripPicture extends Component {
  #imagine;
  #scenePicture;
  #button = this.byId("save-strip", HTMLButtonElement);

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("./imagine.js").Imagine} imagine
   * @param {import("./scene-picture.js").ScenePicture} scenePicture
   */
  constructor(root, imagine, scenePicture) {
    super(root);
    this.#imagine = imagine;
    this.#scenePicture = scenePicture;
    this.#button.addEventListener("click", () => this.#save());
  }

  /** @param {Session} session */
  open(session) {
    super.open(session);
    this.listenTo(this.#imagine, "maps", () => this.#update());
    this.#update();
  }

  #update() {
    this.#button.disabled = this.#imagine.maps === null;
  }

  #save() {
    const { session } = this;
    if (!session) return;
    const { name } = session;
    const { id } = session.about;
    const canvas = strip(this.#cells(session), `${name} ${id ?? ""}`, this.dark);
    canvas.toBlob((blob) => {
      if (blob) download(fileName(`${name} ${id ?? ""} strip`, "png"), blob);
      this.announce(blob ? text.panels.strip.saved : text.panels.strip.failed);
    }, "image/png");
  }

  /**
   * @param {Session} session
   * @returns {Cell[]}
   */
  #cells(session) {
    const { maps } = this.#imagine;
    const words = text.panels.strip;
    // Weights may come without a net that scores balls.
    const imagined = MAPS.flatMap((mapName) => {
      const values = maps?.[mapName];
      return values
        ? [
            {
              name: text.model.steps[mapName].name,
              paint: (/** @type {CanvasRenderingContext2D} */ context) => this.#paintMap(context, mapName, values),
            },
          ]
        : [];
    });
    return [
      { name: words.puzzle, paint: ({ canvas }) => this.#scenePicture.drawOn(canvas) },
      ...imagined,
      {
        name: session.placing ? words.ball : words.result,
        paint: (context) => paintStill(session, context, session.playback.step, this.dark),
      },
    ];
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {import("../pkg/pathlight.js").MapName} mapName
   * @param {Float32Array} values
   */
  #paintMap(context, mapName, values) {
    const [scene, map] = [newContext(SIDE, SIDE), newContext(GRID_SIDE, GRID_SIDE)];
    this.#scenePicture.drawOn(scene.canvas);
    context.globalAlpha = BELOW;
    context.drawImage(scene.canvas, 0, 0);
    context.globalAlpha = 1;
    pathlight.paintMap(map, mapName, values, { max: Math.max(...values), dark: this.dark });
    context.imageSmoothingEnabled = false;
    context.drawImage(map.canvas, 0, 0, SIDE, SIDE);
  }
}

/**
 * Draws pictures side by side, each with its name below, and a title above.
 * @param {Cell[]} cells
 * @param {string} title
 * @param {boolean} dark
 */
function strip(cells, title, dark) {
  const { paper, ink } = palette(dark);
  const context = newContext(GAP + cells.length * (SIDE + GAP), HEAD + SIDE + FOOT);
  const { canvas } = context;
  context.fillStyle = paper;
  context.fillRect(0, 0, canvas.width, canvas.height);
  const write = (/** @type {string} */ words, /** @type {number} */ x, /** @type {number} */ y) => {
    context.fillStyle = ink;
    context.fillText(words, x, y);
  };
  context.font = "600 26px system-ui, sans-serif";
  write(title, GAP, 40);
  context.font = "20px system-ui, sans-serif";
  context.textAlign = "center";
  cells.forEach(({ name, paint }, index) => {
    const picture = newContext(SIDE, SIDE);
    paint(picture);
    const x = GAP + index * (SIDE + GAP);
    context.drawImage(picture.canvas, x, HEAD);
    context.globalAlpha = 0.25;
    context.strokeStyle = ink;
    context.strokeRect(x + 0.5, HEAD + 0.5, SIDE - 1, SIDE - 1);
    context.globalAlpha = 1;
    write(name, x + SIDE / 2, HEAD + SIDE + 28);
  });
  return canvas;
}

/**
 * @param {number} width
 * @param {number} height
 */
function newContext(width, height) {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [width, height];
  return contextOf(canvas);
}
