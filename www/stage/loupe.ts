// A magnifier next to a dragging finger: shows what the finger covers, twice as large.

import { SCENE_SIZE } from "../pkg/constants.ts";
import type { Point } from "../core/change/placement.ts";

const MAGNIFIED = 2;
/** Width of the magnifier, and distance of its middle from the finger, CSS px: a finger is about 50 wide. */
const SIDE = 104;
const AWAY = 96;

/** Shows a point of the scene; null hides it. */
export function magnify(loupe: HTMLCanvasElement, scene: HTMLCanvasElement, point: Point | null): void {
  loupe.hidden = point === null;
  if (!point) return;
  const width = scene.clientWidth;
  const [x, y] = [(point[0] / SCENE_SIZE) * width, (1 - point[1] / SCENE_SIZE) * width];
  const half = SIDE / 2;
  // Above the finger; near the upper edge, on the side that has room.
  const above = y - AWAY >= half;
  const beside = x > width / 2 ? x - AWAY : x + AWAY;
  const within = (middle: number) => Math.min(Math.max(middle, half), width - half) - half;
  loupe.style.left = `${scene.offsetLeft + within(above ? x : beside)}px`;
  loupe.style.top = `${scene.offsetTop + within(above ? y - AWAY : y)}px`;
  const perPx = scene.width / width;
  const size = Math.round(SIDE * perPx);
  if (loupe.width !== size) loupe.width = loupe.height = size;
  const seen = size / MAGNIFIED;
  const context = loupe.getContext("2d")!;
  context.clearRect(0, 0, size, size);
  context.drawImage(scene, x * perPx - seen / 2, y * perPx - seen / 2, seen, seen, 0, 0, size, size);
}
