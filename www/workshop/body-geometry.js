// The bodies of an own scene as a person handles them: where a pointer meets one, where its knobs are, and what
// dragging a knob makes of it. Lengths in px, y up, angles in radians counter-clockwise. Draws nothing.

import { HALF_STICK, JAR_BASE, JAR_HEIGHT_PER_WIDTH, STICK_LEAN } from "../shell/constants.js";

/** @typedef {import("../pkg/pathlight.js").OwnBody} OwnBody */
/** @typedef {OwnBody["shape"]} ShapeType */
/** @typedef {"radius" | "length" | "thickness" | "height"} Size */
/** @typedef {[x: number, y: number]} Point px of the scene, from its lower left corner */

/** How far standing sticks lean from the horizontal, radians. */
const STICK_ANGLE = (STICK_LEAN / 180) * Math.PI;
/** Width of a jar's rim in heights of the jar. */
const JAR_WIDTH = 1 / JAR_HEIGHT_PER_WIDTH;
/** How far the knob that turns a body is from it, px. */
const TURN_DISTANCE = 14;
/** The least distance of a knob from the edge of the scene, px. */
const EDGE = 5;

/**
 * The sizes of each shape; the first is the one that its knob changes.
 * @type {Record<ShapeType, Size[]>}
 */
export const SIZES = { ball: ["radius"], bar: ["length", "thickness"], jar: ["height"], standing_sticks: ["length"] };

/**
 * A size of a body; 0 if its shape has no such size.
 * @param {OwnBody} body
 * @param {Size} size
 */
export function sizeOf(body, size) {
  return /** @type {Partial<Record<Size, number>>} */ (body)[size] ?? 0;
}

/**
 * Returns how far a point is from a body, px; not positive inside. A jar counts as filled.
 * @param {OwnBody} body
 * @param {Point} point
 */
export function distanceTo(body, point) {
  const [u, v] = toBody(body, point);
  switch (body.shape) {
    case "ball":
      return Math.hypot(u, v) - body.radius;
    case "bar":
      return Math.hypot(Math.max(Math.abs(u) - body.length / 2, 0), Math.max(Math.abs(v) - body.thickness / 2, 0));
    case "jar": {
      const width = body.height * JAR_WIDTH * (JAR_BASE + (1 - JAR_BASE) * Math.min(Math.max(v / body.height, 0), 1));
      return Math.hypot(Math.max(Math.abs(u) - width / 2, 0), Math.max(-HALF_STICK - v, v - body.height, 0));
    }
    case "standing_sticks": {
      const distances = [STICK_ANGLE, -STICK_ANGLE].map((angle) => {
        const [along, across] = rotated([u, v], -angle);
        return Math.hypot(Math.max(Math.abs(along) - body.length / 2, 0), across);
      });
      return Math.min(...distances) - HALF_STICK;
    }
  }
}

/**
 * Returns the index of the body that a pointer at a point grabs, or null: of those within reach the one that it is in,
 * of those the smallest, so that what lies in a jar can be grabbed.
 * @param {OwnBody[]} bodies
 * @param {Point} point
 * @param {number} reach px
 */
export function bodyAt(bodies, point, reach) {
  const near = bodies.map((body, index) => ({
    index,
    distance: Math.max(distanceTo(body, point), 0),
    extent: extentOf(body),
  }));
  const hit = near.filter(({ distance }) => distance <= reach);
  return hit.sort((one, other) => one.distance - other.distance || one.extent - other.extent)[0]?.index ?? null;
}

/**
 * The radius of a circle around the origin of a body that the body lies in, px.
 * @param {OwnBody} body
 */
export function extentOf(body) {
  switch (body.shape) {
    case "ball":
      return body.radius;
    case "bar":
      return Math.hypot(body.length, body.thickness) / 2;
    case "jar":
      return Math.hypot(body.height, (body.height * JAR_WIDTH) / 2);
    case "standing_sticks":
      return body.length / 2 + HALF_STICK;
  }
}

/**
 * The knobs of a body in the scene: one that resizes it and, except for a ball, one that turns it. A knob that would
 * lie outside of the scene goes to the other side of the body.
 * @param {OwnBody} body
 * @param {number} side width and height of the scene, px
 * @returns {{ size: Point, turn: Point | null }}
 */
export function knobsOf(body, side) {
  /** @param {Point} place */
  const inside = ([u, v]) => {
    const both = [toScene(body, [u, v]), toScene(body, body.shape === "jar" ? [-u, v] : [-u, -v])];
    const fits = both.find((point) => point.every((value) => value >= EDGE && value <= side - EDGE));
    const clamped = /** @type {Point} */ (both[0].map((value) => Math.min(Math.max(value, EDGE), side - EDGE)));
    return fits ?? clamped;
  };
  switch (body.shape) {
    case "ball":
      return { size: inside([body.radius, 0]), turn: null };
    case "bar":
      return { size: inside([body.length / 2, 0]), turn: inside([0, body.thickness / 2 + TURN_DISTANCE]) };
    case "jar":
      return {
        size: inside([0, body.height]),
        turn: inside([(body.height * JAR_WIDTH) / 2 + TURN_DISTANCE, body.height / 2]),
      };
    case "standing_sticks":
      return {
        size: inside([0, (body.length / 2) * Math.sin(STICK_ANGLE)]),
        turn: inside([body.length / 4 + TURN_DISTANCE, 0]),
      };
  }
}

/**
 * Returns the first size of a body whose knob is dragged to a point.
 * @param {OwnBody} body
 * @param {Point} point
 */
export function sizeTo(body, point) {
  const [u, v] = toBody(body, point);
  switch (body.shape) {
    case "ball":
      return Math.hypot(u, v);
    case "bar":
      return 2 * Math.abs(u);
    case "jar":
      return v;
    case "standing_sticks":
      return (2 * Math.abs(v)) / Math.sin(STICK_ANGLE);
  }
}

/**
 * Returns the direction from the origin of a body to a point, degrees.
 * @param {OwnBody} body
 * @param {Point} point
 */
export function directionTo({ x, y }, [pointX, pointY]) {
  return (Math.atan2(pointY - y, pointX - x) / Math.PI) * 180;
}

/**
 * @param {OwnBody} body
 * @param {Point} point
 */
function toBody({ x, y, angle }, [pointX, pointY]) {
  return rotated([pointX - x, pointY - y], -angle);
}

/**
 * @param {OwnBody} body
 * @param {Point} point
 * @returns {Point}
 */
function toScene({ x, y, angle }, point) {
  const [u, v] = rotated(point, angle);
  return [x + u, y + v];
}

/**
 * @param {Point} point
 * @param {number} angle
 * @returns {Point}
 */
function rotated([u, v], angle) {
  const [sin, cos] = [Math.sin(angle), Math.cos(angle)];
  return [u * cos - v * sin, u * sin + v * cos];
}
