// The page's wasm: it simulates and paints, and knows no nets. The only user of pkg/page.

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

/** Its objects are freed with the puzzles that they belong to. */
const handles = new WeakMap<Puzzle, OpenPuzzle>();

let loading: Promise<void> | null = null;

/** Loads the wasm, once for all puzzles of a page. Throws if it cannot be loaded; then it can be tried again. */
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

/** Throws if there is no such task, or if the scene may not be played. */
export function openPuzzle(source: Source): Puzzle {
  const open = new OpenPuzzle(source);
  const about = open.about();
  // As a custom scene it is plain: without what else its JSON may hold.
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

/** Paints a custom scene as it is being made, also one that may not be played. */
export function paintMaking(
  context: CanvasRenderingContext2D,
  scene: CustomScene,
  view: View,
  maps: HTMLCanvasElement[],
): void {
  paintEditedScene(context, scene, view, maps);
}

const problems = new WeakMap<object, SceneProblem[]>();

/** Why a scene may not be played. */
export function problemsOf(scene: CustomScene): readonly SceneProblem[] {
  const known = problems.get(scene) ?? sceneProblems(scene);
  problems.set(scene, known);
  return known;
}

/** Are none of a scene's problems those of a body? */
export function fits(scene: CustomScene, index: number): boolean {
  return problemsOf(scene).every(({ body, other }) => body !== index && other !== index);
}

/** A map as a picture, painted once. Its opacity is that of the values, so that what is unsure looks so. */
export function mapPicture(name: MapName, values: Float32Array, dark: boolean): HTMLCanvasElement {
  return picture(pictures, values, dark, GRID_SIDE, (context) => paintMap(context, name, values, 1, dark));
}

export function outcomesPicture(outcomes: Uint8Array, dark: boolean): HTMLCanvasElement {
  return picture(pictures, outcomes, dark, SCENE_SIZE, (context) => paintOutcomes(context, outcomes, dark));
}

/** The scene of a puzzle, small. It is painted once the page has nothing more urgent to do. */
export function thumbnail(task: string, dark: boolean, place: string): HTMLCanvasElement {
  // An element can only be at one place.
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
  // Not in every browser.
  if ("requestIdleCallback" in self) requestIdleCallback(work, { timeout: 100 });
  else setTimeout(work, 20);
}

function paintNext(deadline?: IdleDeadline): void {
  do unpainted.shift()!();
  while (unpainted.length > 0 && deadline && deadline.timeRemaining() > 3);
  if (unpainted.length > 0) later(paintNext);
}

const known = new Map<Setup, Benchmark>();

/** What is new in it to the model of a setup. */
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
 * An attempt of a file, simulated again: what becomes of the ball today, and the key of its puzzle. Null if it is none.
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

/** By which attempts at a custom scene are kept; null if it may not be played. */
export function digestOf(scene: CustomScene): string | null {
  try {
    return sceneDigest(scene);
  } catch {
    return null;
  }
}

/** A map over the scene, small. */
export function mapTile(puzzle: Puzzle, name: MapName, values: Float32Array, dark: boolean): HTMLCanvasElement {
  return picture(tiles, values, dark, SCENE_SIZE, (context) => {
    paintThumbnail(context, puzzle.source, dark);
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.drawImage(mapPicture(name, values, dark), 0, 0, SCENE_SIZE, SCENE_SIZE);
  });
}

/** By their values; for light and dark. */
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

/** A pure function that keeps its last result. */
function latest<Result>(compute: (ball: Ball) => Result): (ball: Ball) => Result {
  let last: { ball: Ball; result: Result } | null = null;
  return (ball) => (last?.ball === ball ? last : (last = { ball, result: compute(ball) })).result;
}

const MOST_REMEMBERED = 16;

/** A pure function that keeps its last results. */
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
