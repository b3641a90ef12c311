// A scene as a picture 48 to 176 CSS px wide: bolder than where it is played, so that its bodies can be made out.

import { DARK_PALETTE, LIGHT_PALETTE } from "../pkg/constants.js";
import { pathlight } from "../shell/page-api.js";
import { BOLD, ScenePainter } from "./scene-painter.js";

/**
 * @param {CanvasRenderingContext2D} context of a square canvas
 * @param {import("../pkg/pathlight.js").Puzzle} puzzle
 * @param {boolean} dark
 */
export function paintThumbnail(context, puzzle, dark) {
  const { bodies, body2 } = pathlight.scene(puzzle);
  const painter = new ScenePainter(context, dark ? DARK_PALETTE : LIGHT_PALETTE, BOLD);
  bodies.forEach((body, index) => painter.body(body, [body.x, body.y, body.angle], index === body2));
}
