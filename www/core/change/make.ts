// Making a puzzle: the scene as it is being changed, with undo and redo. A playable scene becomes the puzzle once a
// gesture has ended (effects/making.ts). Until something is changed this state is null, and the puzzle itself is shown.

import {
  SIZES,
  bodyAt,
  degreesOf,
  directionTo,
  distanceTo,
  knobsOf,
  limitsOf,
  roleOf,
  sizeAt,
  sizeOf,
  wrapped,
} from "../derived/bodies.ts";
import { NO_HISTORY, recorded, travelled } from "../undo.ts";
import { NO_ANSWERS } from "./model.ts";
import { linkTo } from "./route.ts";
import { SCENE_LIMITS, SCENE_SIZE } from "../../pkg/constants.ts";
import type { Role, Shape, Size } from "../derived/bodies.ts";
import type { History } from "../undo.ts";
import type { Point } from "./placement.ts";
import type { Route } from "./route.ts";
import type { Puzzle } from "../puzzle.ts";
import type { State } from "../state.ts";
import type { CustomBody, CustomScene } from "../../pkg/page/pathlight.js";

export interface Making extends History<CustomScene> {
  readonly scene: CustomScene;
  /** The puzzle that is being changed. Undo leads back to it. */
  readonly origin: Puzzle;
  /** The index of the selected body. */
  readonly selected: number | null;
  readonly drag: BodyDrag | null;
}

/** A body held by a pointer, directly or by one of its knobs. */
export interface BodyDrag {
  readonly pointer: number;
  readonly grip: "move" | "size" | "turn";
  /** Offset to the body's origin, px; for `turn`, first is from the pointer's direction to the angle, degrees. */
  readonly offset: Point;
  /** The state to restore if the browser takes the pointer away. */
  readonly before: Pick<State, "make" | "run">;
}

/** Dragged values are rounded to these, which keeps links short and bodies straight. */
const PX = 1;
const DEGREES = 5;
/** Minimum distance of a copy from its original, px. */
const COPY_OFFSET = 16;
/** Offsets at which a new body is tried, px: nearest first. */
const PLACES = [0, 24, -24, 48, -48, 72, -72, 96, -96]
  .flatMap((dy, _, all) => all.map((dx) => [dx, dy] as const))
  .sort((one, other) => Math.hypot(...one) - Math.hypot(...other));
/** Preferred position of a new body. */
const NEW_PLACE = { x: SCENE_SIZE / 2, y: 180, angle: 0 };
const NEW_BODIES: Record<Shape, CustomBody> = {
  ball: { shape: "ball", radius: 12, ...NEW_PLACE, dynamic: true },
  bar: { shape: "bar", length: 64, thickness: 6, ...NEW_PLACE, dynamic: false },
  jar: { shape: "jar", height: 48, ...NEW_PLACE, dynamic: true },
  standing_sticks: { shape: "standing_sticks", length: 48, ...NEW_PLACE, dynamic: true },
};
/** A minimal solvable scene: a ball on a shelf, and the floor as its goal. */
const EMPTY: CustomScene = {
  version: 1,
  body1: 0,
  body2: 1,
  bodies: [
    { shape: "ball", radius: 12, x: 128, y: 135, angle: 0, dynamic: true },
    { shape: "bar", length: SCENE_SIZE, thickness: 6, x: 128, y: 3, angle: 0, dynamic: false },
    { shape: "bar", length: 72, thickness: 6, x: 128, y: 120, angle: 0, dynamic: false },
  ],
};

/** Returns the scene being made: that of the puzzle, until something is changed. */
export function making({ make, puzzle }: State): Making {
  return make ?? { ...NO_HISTORY, scene: puzzle.custom, origin: puzzle, selected: null, drag: null };
}

export function selectedBody(state: State): CustomBody | null {
  const { scene, selected } = making(state);
  return selected === null ? null : scene.bodies[selected]!;
}

/** Whether the scene being made is the open puzzle. */
export function isSettled({ make, puzzle }: State): boolean {
  return make === null || make.scene === puzzle.custom;
}

/** Records that the scene being made has been opened: it is now the puzzle, with its own attempts. The ball stays. */
export function remade(state: State, puzzle: Puzzle, named: Partial<Pick<Route, "task" | "scene">>): State {
  if (!state.make) return state;
  const { ball: _, ...route } = linkTo(state, named);
  return {
    ...state,
    puzzle,
    route,
    make: { ...state.make, scene: puzzle.custom },
    // The maps of the previous scene stay until new ones arrive.
    answers: { ...NO_ANSWERS, maps: state.answers.maps },
    check: state.check && { ...state.check, seeking: false },
  };
}

export function select(state: State, selected: number | null): State {
  return selected === making(state).selected ? state : withMake(state, { selected });
}

export function selectNext(state: State, by: 1 | -1): State {
  const { selected, scene } = making(state);
  const count = scene.bodies.length;
  return select(state, selected === null ? (by > 0 ? 0 : count - 1) : (selected + by + count) % count);
}

export function moveTo(state: State, x: number, y: number, gesture: string | null): State {
  return withBody(state, { x: hundredths(x), y: hundredths(y) }, gesture);
}

export function turnTo(state: State, degrees: number, gesture: string | null): State {
  // Ten thousandths of a radian are finer than hundredths of a degree.
  return withBody(state, { angle: Math.round((wrapped(degrees) / 180) * Math.PI * 1e4) / 1e4 }, gesture);
}

/** Resizes the selected body within its limits. */
export function resizeTo(state: State, size: Size, value: number, gesture: string | null): State {
  const body = selectedBody(state);
  if (!body || !SIZES[body.shape].includes(size)) return state;
  const [least, most] = limitsOf(body, size);
  return withBody(state, { [size]: hundredths(Math.min(Math.max(value, least), most)) }, gesture);
}

/** Whether the selected body may have a role. The green object and the goal can be swapped, but never removed. */
export function mayBe(state: State, role: Role): boolean {
  const { scene, selected } = making(state);
  if (selected === null) return false;
  const isNeeded = selected === scene.body1 || selected === scene.body2;
  return !isNeeded || (role !== "gray" && role !== "black");
}

export function setRole(state: State, role: Role): State {
  const { scene, selected } = making(state);
  if (selected === null || !mayBe(state, role) || roleOf(scene, selected) === role) return state;
  let { body1, body2 } = scene;
  if (role === "green") [body1, body2] = [selected, body2 === selected ? body1 : body2];
  if (role === "blue" || role === "purple") [body1, body2] = [body1 === selected ? body2 : body1, selected];
  const dynamic = role !== "purple" && role !== "black";
  const bodies = scene.bodies.map((body, index) =>
    index === selected ? { ...body, dynamic } : index === body1 ? { ...body, dynamic: true } : body,
  );
  return withScene(state, { ...scene, body1, body2, bodies }, null);
}

export function mayAdd(state: State): boolean {
  return making(state).scene.bodies.length < SCENE_LIMITS.bodies[1];
}

/** Adds a body where there is room, and selects it. `fits`: whether this body leaves a scene playable. */
export function add(state: State, shape: Shape, fits: (scene: CustomScene, body: number) => boolean): State {
  return append(state, NEW_BODIES[shape], fits);
}

/** Adds a copy of the selected body next to it, and selects the copy. */
export function duplicate(state: State, fits: (scene: CustomScene, body: number) => boolean): State {
  const body = selectedBody(state);
  if (!body) return state;
  const [dx, dy] = [body.x, body.y].map((value) => (value + COPY_OFFSET > SCENE_SIZE ? -COPY_OFFSET : COPY_OFFSET));
  return append(state, { ...body, x: body.x + dx!, y: body.y + dy! }, fits);
}

function append(state: State, body: CustomBody, fits: (scene: CustomScene, body: number) => boolean): State {
  if (!mayAdd(state)) return state;
  const { scene } = making(state);
  const index = scene.bodies.length;
  const scenes = PLACES.map(([dx, dy]) => ({
    ...scene,
    bodies: [...scene.bodies, { ...body, x: hundredths(body.x + dx), y: hundredths(body.y + dy) }],
  }));
  const added = withScene(state, scenes.find((one) => fits(one, index)) ?? scenes[0]!, null);
  return withMake(added, { selected: index });
}

export function mayRemove(state: State): boolean {
  const { scene, selected } = making(state);
  return selected !== null && selected !== scene.body1 && selected !== scene.body2;
}

export function remove(state: State): State {
  const { scene, selected } = making(state);
  if (selected === null || !mayRemove(state)) return state;
  const moved = (index: number) => (index > selected ? index - 1 : index);
  const bodies = scene.bodies.filter((_, index) => index !== selected);
  const removed = { ...scene, body1: moved(scene.body1), body2: moved(scene.body2), bodies };
  return withMake(withScene(state, removed, null), { selected: null });
}

export function rename(state: State, text: string): State {
  const { name: _, ...scene } = making(state).scene;
  const name = text.trim().slice(0, SCENE_LIMITS.name_length);
  return withScene(state, name ? { ...scene, name } : scene, "name");
}

/** Starts over with a minimal scene; undo leads back. */
export function empty(state: State): State {
  return withMake(withScene(state, EMPTY, null), { selected: null });
}

/** Handles a pointer going down: it grabs a knob or a body, or clears the selection. */
export function press(state: State, pointer: number, point: Point, reach: { knob: number; ball: number }): State {
  if (making(state).drag) return state;
  const before = { make: state.make, run: state.run };
  const body = selectedBody(state);
  const knob = body && knobAt(body, point, reach.knob);
  if (body && knob) return withMake(state, { drag: { pointer, before, ...knob } });
  const { scene, selected } = making(state);
  // The selected body can be grabbed even where it is under another.
  const hit = body && distanceTo(body, point) <= 0 ? selected : bodyAt(scene.bodies, point, reach.knob);
  if (hit === null) return withMake(state, { selected: null });
  const { x, y } = scene.bodies[hit]!;
  const offset = [x - point[0], y - point[1]] as const;
  return withMake(state, { selected: hit, drag: { pointer, before, grip: "move", offset } });
}

function knobAt(body: CustomBody, [x, y]: Point, reach: number): Pick<BodyDrag, "grip" | "offset"> | null {
  const { size, turn } = knobsOf(body);
  const [toSize, toTurn] = [size, turn].map((knob) => (knob ? Math.hypot(x - knob[0], y - knob[1]) : Infinity));
  if (Math.min(toSize!, toTurn!) > reach) return null;
  if (toSize! <= toTurn!) return { grip: "size", offset: [0, 0] };
  return { grip: "turn", offset: [degreesOf(body) - directionTo(body, [x, y]), 0] };
}

export function drag(state: State, pointer: number, point: Point): State {
  const { drag } = making(state);
  const body = selectedBody(state);
  if (drag?.pointer !== pointer || !body) return state;
  const gesture = `pointer ${pointer}`;
  if (drag.grip === "size") return resizeTo(state, SIZES[body.shape][0], onGrid(sizeAt(body, point), PX), gesture);
  if (drag.grip === "turn") return turnTo(state, onGrid(directionTo(body, point) + drag.offset[0], DEGREES), gesture);
  // The origin stays in the scene, so that the body can be grabbed again.
  const at = (axis: 0 | 1) => Math.min(Math.max(onGrid(point[axis] + drag.offset[axis], PX), 0), SCENE_SIZE);
  return moveTo(state, at(0), at(1), gesture);
}

export function release(state: State, pointer: number): State {
  return state.make?.drag?.pointer === pointer ? withMake(state, { drag: null, gesture: null }) : state;
}

/** Restores the state if the browser takes the pointer away to scroll. */
export function cancel(state: State, pointer: number): State {
  const held = state.make?.drag;
  return held?.pointer === pointer ? { ...state, ...held.before } : state;
}

export function nudge(state: State, dx: number, dy: number, dr: number, gesture: string): State {
  const body = selectedBody(state);
  if (!body) return state;
  if (dr === 0) return moveTo(state, body.x + dx, body.y + dy, gesture);
  const [size] = SIZES[body.shape];
  return resizeTo(state, size, sizeOf(body, size) + dr, gesture);
}

export function turnBy(state: State, degrees: number, gesture: string): State {
  const body = selectedBody(state);
  return body ? turnTo(state, degreesOf(body) + degrees, gesture) : state;
}

export function undo(state: State): State {
  return travel(state, "past");
}

export function redo(state: State): State {
  return travel(state, "future");
}

/** Also ends a drag, which would otherwise move the body back at once. */
function travel(state: State, to: "past" | "future"): State {
  const now = making(state);
  const there = travelled(now, to, now.scene);
  if (!there) return state;
  const { value: scene, ...lists } = there;
  const selected = now.selected !== null && now.selected < scene.bodies.length ? now.selected : null;
  return withMake(state, { ...lists, scene, selected, drag: null });
}

function withBody(state: State, change: Partial<CustomBody>, gesture: string | null): State {
  const { scene, selected } = making(state);
  const isSame = ([key, value]: [string, unknown]) => (selectedBody(state) as any)[key] === value;
  if (selected === null || Object.entries(change).every(isSame)) return state;
  const bodies = scene.bodies.map((body, index) =>
    index === selected ? ({ ...body, ...change } as CustomBody) : body,
  );
  return withScene(state, { ...scene, bodies }, gesture);
}

function withScene(state: State, scene: CustomScene, gesture: string | null): State {
  const now = making(state);
  return withMake(state, { ...recorded(now, now.scene, gesture), scene: named(state, scene) });
}

/** Renames a task of the benchmark that has been changed. */
function named({ puzzle, text }: State, scene: CustomScene): CustomScene {
  const isOfTask = puzzle.about.id !== null && scene.name === undefined && scene.bodies !== EMPTY.bodies;
  return isOfTask ? { ...scene, name: text.make.changed(text.puzzle.name(puzzle.about)) } : scene;
}

/** Changes the scene, which ends the run. */
function withMake(state: State, change: Partial<Making>): State {
  return { ...state, run: null, make: { ...making(state), ...change } };
}

const onGrid = (value: number, grid: number) => Math.round(value / grid) * grid;
const hundredths = (value: number) => Math.round(value * 100) / 100;
