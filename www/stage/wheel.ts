// Computes by how many px the wheel changes the radius. Small movements add up, so that a trackpad is as slow as a
// wheel.

export type WheelFacts = Pick<WheelEvent, "deltaY" | "deltaMode">;

/** One notch of a wheel in pixels, lines and pages, by `deltaMode`. */
const NOTCH = [100, 3, 1];

/** Returns the whole steps, positive for a larger ball, and the remaining fraction of a step. */
export function wheelSteps(rest: number, { deltaY, deltaMode }: WheelFacts): [steps: number, rest: number] {
  const turned = -deltaY / (NOTCH[deltaMode] ?? 100);
  // Start over when the direction changes.
  const sum = Math.sign(turned) === -Math.sign(rest) ? turned : rest + turned;
  const steps = Math.trunc(sum + Math.sign(sum) * 1e-9);
  return [steps, sum - steps];
}
