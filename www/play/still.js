// One frame of what the scene shows, on another canvas: for pictures and films that are saved.

/**
 * @param {import("./session.js").Session} session
 * @param {CanvasRenderingContext2D} context of a square canvas
 * @param {number} step
 * @param {boolean} dark
 */
export function paintStill(session, context, step, dark) {
  const whole = session.phase === "compare";
  session.puzzle.paint(context, { step, ball: session.ball, knob: 0, whole, opacity: 1, dark }, []);
}
