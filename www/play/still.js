// One frame of what the scene shows, on another canvas: for pictures and films that are saved.

import { namesOf } from "./ball-names.js";

/**
 * @param {import("./session.js").Session} session
 * @param {CanvasRenderingContext2D} context of a square canvas
 * @param {number} step
 * @param {boolean} dark
 */
export function paintStill(session, context, step, dark) {
  const { ball, invalidReason, phase, game } = session;
  const view = { step, ball, valid: invalidReason === null, knob: 0, whole: phase === "compare", opacity: 1, dark };
  game.paint(context, { ...view, names: namesOf(session) }, []);
}
