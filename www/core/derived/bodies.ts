// The bodies of a scene as handled by a person: where a pointer hits one, where its knobs are, and what dragging a knob
// does. Lengths in px, y up, angles in radians counter-clockwise.

import {
  HALF_STICK,
  JAR_BASE,
  JAR_HEIGHT_PER_WIDTH,
  SCENE_LIMITS,
  SCENE_SIZE,
  STICK_LEAN,
} from "../../pkg/constants.ts";
import type { Body, CustomBody, CustomScene, SceneProblem } from "../../pkg/page/pathlight.js";
import type { Point } from "../change/placement.ts";

export type Shape = CustomBody["shape"];
export type Role = Body["role"];
export type Size = "radius" | "length" | "thickness" | "height";

/** The sizes of each shape; its knob changes the first. */
export const SIZES: Record<Shape, readonly [Size, ...Size[]]> = {
  ball: ["radius"],
  bar: ["length", "thickness"],
  jar: ["height"],
  standing_sticks: ["length"],
};

/** Angle of standing sticks from the horizontal. */
const LEAN = (STICK_LEAN / 180) * Math.PI;
/** Distance of the turning knob from the body. */
const TURN_DISTANCE = 14;
/** Minimum distance of a knob from the edge of the scene. */
const EDGE = 5;

/** Returns a size of a body; 0 if its shape has no such size. */
export function sizeOf(body: CustomBody, size: Size): number {
  return (body as Partial<Record<Size, number>>)[size] ?? 0;
}

/** The minimum and maximum of a size. */
export function limitsOf({ shape }: CustomBody, size: Size): readonly [least: number, most: number] {
  if (size === "radius") return SCENE_LIMITS.ball_radius;
  if (size === "thickness") return SCENE_LIMITS.bar_thickness;
  if (size === "height") return SCENE_LIMITS.jar_height;
  return shape === "bar" ? SCENE_LIMITS.bar_length : SCENE_LIMITS.stick_length;
}

/** The role of a body, which its colour shows. */
export function roleOf({ body1, body2, bodies }: CustomScene, index: number): Role {
  const dynamic = bodies[index]!.dynamic;
  if (index === body1) return "green";
  if (index === body2) return dynamic ? "blue" : "purple";
  return dynamic ? "gray" : "black";
}

/** A body in words. */
export type Named = Pick<Body, "role" | "shape">;

export function namedOf(scene: CustomScene, index: number | null): Named | null {
  const body = index === null ? undefined : scene.bodies[index];
  return body && index !== null ? { role: roleOf(scene, index), shape: body.shape } : null;
}

/** A problem of a scene, with its bodies in words. */
export interface NamedProblem {
  readonly fault: SceneProblem["fault"];
  readonly body: Named | null;
  readonly other: Named | null;
}

export function namedProblem(scene: CustomScene, { fault, body, other }: SceneProblem): NamedProblem {
  return { fault, body: namedOf(scene, body), other: namedOf(scene, other) };
}

/** The angle in degrees, from 0 up to 360. */
export function degreesOf({ angle }: CustomBody): number {
  return wrapped(Math.round((angle / Math.PI) * 18000) / 100);
}

export const wrapped = (degrees: number) => ((degrees % 360) + 360) % 360;

/** The direction from the origin of a body to a point, degrees. */
export function directionTo({ x, y }: CustomBody, point: Point): number {
  return (Math.atan2(point[1] - y, point[0] - x) / Math.PI) * 180;
}

/** Distance of a point from a body; not positive inside. A jar counts as filled. */
export function distanceTo(body: CustomBody, point: Point): number {
  const [u, v] = toBody(body, point);
  const beyond = (value: number, half: number) => Math.max(Math.abs(value) - half, 0);
  switch (body.shape) {
    case "ball":
      return Math.hypot(u, v) - body.radius;
    case "bar":
      return Math.hypot(beyond(u, body.length / 2), beyond(v, body.thickness / 2));
    case "jar": {
      const part = JAR_BASE + (1 - JAR_BASE) * Math.min(Math.max(v / body.height, 0), 1);
      return Math.hypot(beyond(u, rimOf(body) * part), Math.max(-HALF_STICK - v, v - body.height, 0));
    }
    case "standing_sticks": {
      const distances = [LEAN, -LEAN].map((angle) => {
        const [along, across] = rotated([u, v], -angle);
        return Math.hypot(beyond(along, body.length / 2), across);
      });
      return Math.min(...distances) - HALF_STICK;
    }
  }
}

/** The body that a pointer grabs: the nearest within reach; among those around it, the smallest, as in a jar. */
export function bodyAt(bodies: readonly CustomBody[], point: Point, reach: number): number | null {
  const near = bodies.map((body, index) => ({ index, extent: circleOf(body).radius, far: distanceTo(body, point) }));
  const order = near
    .map((one) => ({ ...one, far: Math.max(one.far, 0) }))
    .filter(({ far }) => far <= reach)
    .sort((one, other) => one.far - other.far || one.extent - other.extent);
  return order[0]?.index ?? null;
}

/** A circle that contains a body. */
export function circleOf(body: CustomBody): { centre: Point; radius: number } {
  switch (body.shape) {
    case "ball":
      return { centre: [body.x, body.y], radius: body.radius };
    case "bar":
      return { centre: [body.x, body.y], radius: Math.hypot(body.length, body.thickness) / 2 };
    case "jar":
      return { centre: toScene(body, [0, body.height / 2]), radius: Math.hypot(body.height / 2, rimOf(body)) };
    case "standing_sticks":
      return { centre: [body.x, body.y], radius: body.length / 2 + HALF_STICK };
  }
}

/** The resizing and turning knobs of a body. A knob that would be outside the scene moves to the other side. */
export function knobsOf(body: CustomBody): { size: Point; turn: Point | null } {
  switch (body.shape) {
    case "ball":
      return { size: inside(body, [body.radius, 0]), turn: null };
    case "bar":
      return { size: inside(body, [body.length / 2, 0]), turn: inside(body, [0, body.thickness / 2 + TURN_DISTANCE]) };
    case "jar":
      return {
        size: inside(body, [0, body.height]),
        turn: inside(body, [rimOf(body) + TURN_DISTANCE, body.height / 2]),
      };
    case "standing_sticks":
      return {
        size: inside(body, [0, (body.length / 2) * Math.sin(LEAN)]),
        turn: inside(body, [body.length / 4 + TURN_DISTANCE, 0]),
      };
  }
}

/** The first size of a body whose knob is dragged to a point. */
export function sizeAt(body: CustomBody, point: Point): number {
  const [u, v] = toBody(body, point);
  switch (body.shape) {
    case "ball":
      return Math.hypot(u, v);
    case "bar":
      return 2 * Math.abs(u);
    case "jar":
      return v;
    case "standing_sticks":
      return (2 * Math.abs(v)) / Math.sin(LEAN);
  }
}

/** Half the width of a jar's rim. */
function rimOf({ height }: { height: number }): number {
  return height / JAR_HEIGHT_PER_WIDTH / 2;
}

function inside(body: CustomBody, [u, v]: Point): Point {
  const fits = (point: Point) => point.every((value) => value >= EDGE && value <= SCENE_SIZE - EDGE);
  const [here, there] = [toScene(body, [u, v]), toScene(body, body.shape === "jar" ? [-u, v] : [-u, -v])];
  if (fits(here)) return here;
  if (fits(there)) return there;
  const clamped = (value: number) => Math.min(Math.max(value, EDGE), SCENE_SIZE - EDGE);
  return [clamped(here[0]), clamped(here[1])];
}

function toBody({ x, y, angle }: CustomBody, point: Point): Point {
  return rotated([point[0] - x, point[1] - y], -angle);
}

function toScene({ x, y, angle }: CustomBody, point: Point): Point {
  const [u, v] = rotated(point, angle);
  return [x + u, y + v];
}

function rotated([u, v]: Point, angle: number): Point {
  const [sin, cos] = [Math.sin(angle), Math.cos(angle)];
  return [u * cos - v * sin, u * sin + v * cos];
}
