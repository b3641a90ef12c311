// The page's wasm: simulates and paints, without nets. The only user of pkg/page.

import init, {
  OpenPuzzle,
  attemptLine,
  customScene,
  paintEditedScene,
  paintMap,
  paintOutcomes,
  paintThumbnail,
  sceneDigest,
  sceneProblems,
  solveRates,
} from "./pkg/page/pathlight.js";
import { GRID_SIDE, SCENE_SIZE, TEMPLATES, UNSEEN } from "./pkg/constants.ts";
import { loadError } from "./model/loading.ts";
import type { Puzzle } from "./core/puzzle.ts";
import type { Benchmark } from "./core/derived/next.ts";
import type {
  AttemptLine,
  Ball,
  CustomScene,
  MapName,
  Puzzle as Source,
  SceneProblem,
  Setup,
  ShownRollout,
  View,
} from "./pkg/page/pathlight.js";

/** Wasm objects, freed with the puzzles that they belong to. */
const handles = new WeakMap<Puzzle, OpenPuzzle>();

let loading: Promise<void> | null = null;

/** Loads the wasm, once for all puzzles of a page. Throws if it cannot be loaded; loading can then be retried. */
export function loadSimulator(url: string): Promise<void> {
  loading ??= load(url).catch((error) => {
    loading = null;
    throw error;
  });
  return loading;
}

async function load(url: string): Promise<void> {
  try {
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${response.status} ${response.statusText}`);
    await init({ module_or_path: response });
  } catch (error) {
    throw await loadError(url, error, "damaged");
  }
}

/** Opens a puzzle. Throws if there is no such task, or if the scene is not playable. */
export function openPuzzle(source: Source): Puzzle {
  const open = new OpenPuzzle(source);
  const about = open.about();
  // Converting it drops anything else in its JSON.
  const custom = customScene(source);
  const puzzle: Puzzle = {
    source: typeof source === "string" ? source : custom,
    key: about.id ?? about.digest ?? "",
    about,
    scene: about.scene,
    custom,
    whyInvalid: latest((ball) => open.whyInvalid(...ball) ?? null),
    nearestPlace: (ball) => open.nearestPlace(...ball) ?? null,
    rollout: remembered((ball) => open.rollout(ball)),
    pathMasks: remembered((ball) => open.pathMasks(ball)),
    sketchMask: (path) => open.sketchMask(path),
  };
  handles.set(puzzle, open);
  return puzzle;
}

export function paint(
  context: CanvasRenderingContext2D,
  puzzle: Puzzle,
  rollouts: readonly ShownRollout[],
  view: View,
  maps: HTMLCanvasElement[],
): void {
  handles.get(puzzle)!.paint(context, [...rollouts], view, maps);
}

/** Paints a custom scene while it is being made, even if it is not playable. */
export function paintMaking(
  context: CanvasRenderingContext2D,
  scene: CustomScene,
  view: View,
  maps: HTMLCanvasElement[],
): void {
  paintEditedScene(context, scene, view, maps);
}

const problems = new WeakMap<object, SceneProblem[]>();

/** Returns why a scene is not playable. */
export function problemsOf(scene: CustomScene): readonly SceneProblem[] {
  const known = problems.get(scene) ?? sceneProblems(scene);
  problems.set(scene, known);
  return known;
}

/** Whether none of a scene's problems concerns this body. */
export function fits(scene: CustomScene, index: number): boolean {
  return problemsOf(scene).every(({ body, other }) => body !== index && other !== index);
}

/** Returns a map as a picture, painted once. Its opacity follows the values, so that uncertain places look faint. */
export function mapPicture(name: MapName, values: Float32Array, dark: boolean): HTMLCanvasElement {
  return picture(pictures, values, dark, GRID_SIDE, (context) => paintMap(context, name, values, 1, dark));
}

export function outcomesPicture(outcomes: Uint8Array, dark: boolean): HTMLCanvasElement {
  return picture(pictures, outcomes, dark, SCENE_SIZE, (context) => paintOutcomes(context, outcomes, dark));
}

/** Returns a small picture of a puzzle's scene. It is painted once the page has nothing more urgent to do. */
export function thumbnail(task: string, dark: boolean, place: string): HTMLCanvasElement {
  // An element can be in one place only.
  const key = `${place} ${task} ${dark}`;
  const canvas = thumbnails.get(key) ?? document.createElement("canvas");
  if (!thumbnails.has(key)) {
    thumbnails.set(key, canvas);
    canvas.width = canvas.height = THUMBNAIL_SIDE;
    if (unpainted.length === 0) later(paintNext);
    unpainted.push(() => {
      paintThumbnail(canvas.getContext("2d")!, task, dark);
      canvas.classList.add("painted");
    });
  }
  return canvas;
}

const THUMBNAIL_SIDE = 256;
const thumbnails = new Map<string, HTMLCanvasElement>();
const unpainted: (() => void)[] = [];

function later(work: (deadline?: IdleDeadline) => void): void {
  // Not supported by every browser.
  if ("requestIdleCallback" in self) requestIdleCallback(work, { timeout: 100 });
  else setTimeout(work, 20);
}

function paintNext(deadline?: IdleDeadline): void {
  do unpainted.shift()!();
  while (unpainted.length > 0 && deadline && deadline.timeRemaining() > 3);
  if (unpainted.length > 0) later(paintNext);
}

/** Waits until all small pictures are painted. */
export async function thumbnailsPainted(): Promise<void> {
  while (unpainted.length > 0) await new Promise<void>((resolve) => later(() => resolve()));
}

const known = new Map<Setup, Benchmark>();

/** Facts about the benchmark's tasks, and which are new to the model of a setup. */
export function benchmark(setup: Setup = "within"): Benchmark {
  const before = known.get(setup);
  if (before) return before;
  const tasks = TEMPLATES.flatMap((template) => template.tasks);
  const isUnseen = (index: number) => (parseInt(UNSEEN[setup][index >> 2]!, 16) >> (index & 3)) & 1;
  const made = { tasks, rates: solveRates(), unseen: new Set(tasks.filter((_, index) => isUnseen(index))) };
  known.set(setup, made);
  return made;
}

/** The share of balls that solve a task. */
export function rateOf(task: string): number {
  const { tasks, rates } = benchmark();
  return rates[tasks.indexOf(task)] ?? 0;
}

/**
 * Simulates an attempt from a file again: returns the key of its puzzle and the new outcome. Null if it is not an
 * attempt.
 */
export function readAttempt({ task, scene, ball }: Partial<AttemptLine>): { key: string; line: AttemptLine } | null {
  try {
    const line = attemptLine((task ?? scene)!, ball!);
    const key = line.task ?? sceneDigest(line.scene!);
    return line.ball && line.status !== "invalid" ? { key, line } : null;
  } catch {
    return null;
  }
}

/** Key under which attempts at a custom scene are kept; null if the scene is not playable. */
export function digestOf(scene: CustomScene): string | null {
  try {
    return sceneDigest(scene);
  } catch {
    return null;
  }
}

/** Returns a small picture of a map over the scene. */
export function mapTile(puzzle: Puzzle, name: MapName, values: Float32Array, dark: boolean): HTMLCanvasElement {
  return picture(tiles, values, dark, SCENE_SIZE, (context) => {
    paintThumbnail(context, puzzle.source, dark);
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.drawImage(mapPicture(name, values, dark), 0, 0, SCENE_SIZE, SCENE_SIZE);
  });
}

/** Pictures by their values, for light and dark. */
type Pictures = WeakMap<object, Map<boolean, HTMLCanvasElement>>;
const tiles: Pictures = new WeakMap();
const pictures: Pictures = new WeakMap();

function picture(
  pictures: Pictures,
  values: Float32Array | Uint8Array,
  dark: boolean,
  side: number,
  draw: (context: CanvasRenderingContext2D) => void,
): HTMLCanvasElement {
  const made = pictures.get(values) ?? new Map<boolean, HTMLCanvasElement>();
  pictures.set(values, made);
  const canvas = made.get(dark) ?? drawn(side, draw);
  made.set(dark, canvas);
  return canvas;
}

function drawn(side: number, draw: (context: CanvasRenderingContext2D) => void): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = side;
  draw(canvas.getContext("2d")!);
  return canvas;
}

/** Caches the last result of a pure function. */
function latest<Result>(compute: (ball: Ball) => Result): (ball: Ball) => Result {
  let last: { ball: Ball; result: Result } | null = null;
  return (ball) => (last?.ball === ball ? last : (last = { ball, result: compute(ball) })).result;
}

const MOST_REMEMBERED = 16;

/** Caches the last results of a pure function. */
function remembered<Result>(compute: (ball: Ball | null) => Result): (ball: Ball | null) => Result {
  const results = new Map<string, Result>();
  return (ball) => {
    const key = String(ball);
    const result = results.get(key) ?? compute(ball);
    results.delete(key);
    results.set(key, result);
    if (results.size > MOST_REMEMBERED) results.delete(results.keys().next().value!);
    return result;
  };
}
