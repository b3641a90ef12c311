// A scene that is being edited: the bodies as they are now, the one that is selected, and what can be undone. All that
// a person can do to a scene is a method here; pointer, keys and fields only call them. Fires "change" when anything
// has changed. Knows nothing of the document.

import { SCENE_SIZE } from "../shell/constants.js";
import { pathlight } from "../shell/page-api.js";
import { UndoStack } from "../play/undo-stack.js";
import { SIZES } from "./body-geometry.js";
import { rounded, wrapped } from "./body-words.js";

/** @typedef {import("../pkg/pathlight.js").CustomScene} CustomScene */
/** @typedef {import("../pkg/pathlight.js").CustomBody} CustomBody */
/** @typedef {import("../pkg/pathlight.js").SceneLimits} SceneLimits */
/** @typedef {import("./body-geometry.js").Size} Size */

/** What is dragged is rounded to multiples of this, px, with snap and without; it keeps links short. */
const GRID = { on: 4, off: 0.5 };
/** The same for angles, degrees. */
const ANGLE_GRID = { on: 5, off: 1 };
/** How far a copy lies from its original at least, px. */
const COPY_OFFSET = 16;
/** Where a new body is tried, from where it is wanted, px: nearest first, and above before below. */
const PLACES = [0, 24, -24, 48, -48, 72, -72, 96, -96]
  .flatMap((y, _, all) => all.map((x) => [x, y]))
  .sort((one, other) => Math.hypot(...one) - Math.hypot(...other));

/** @type {Record<CustomBody["shape"], (x: number, y: number) => CustomBody>} */
const NEW_BODIES = {
  ball: (x, y) => ({ shape: "ball", radius: 12, x, y, angle: 0, dynamic: true }),
  bar: (x, y) => ({ shape: "bar", length: 64, thickness: 5, x, y, angle: 0, dynamic: false }),
  jar: (x, y) => ({ shape: "jar", height: 48, x, y, angle: 0, dynamic: true }),
  standing_sticks: (x, y) => ({ shape: "standing_sticks", length: 48, x, y, angle: 0, dynamic: true }),
};

export class EditedScene extends EventTarget {
  /** Do positions, angles and sizes that are dragged snap to a coarse grid? */
  snap = false;
  /** @type {CustomScene} */
  #scene;
  /** @type {number | null} */
  #selected = null;
  #limits;
  /** @type {UndoStack<string>} */
  #undoStack;

  /**
   * @param {CustomScene} scene
   * @param {SceneLimits} limits
   */
  constructor(scene, limits) {
    super();
    this.#scene = scene;
    this.#limits = limits;
    this.#undoStack = new UndoStack(JSON.stringify(scene));
  }

  /** The scene as it is now; never changed in place. */
  get scene() {
    return this.#scene;
  }

  /** The index of the selected body, or null. */
  get selected() {
    return this.#selected;
  }

  /** The selected body, or null. */
  get body() {
    return this.#selected === null ? null : this.#scene.bodies[this.#selected];
  }

  get canUndo() {
    return this.#undoStack.canUndo;
  }

  get canRedo() {
    return this.#undoStack.canRedo;
  }

  get canAdd() {
    return this.#scene.bodies.length < this.#limits.bodies[1];
  }

  /** Whether the selected body may go: the object and the goal stay. */
  get canRemove() {
    const { body1, body2 } = this.#scene;
    return this.#selected !== null && this.#selected !== body1 && this.#selected !== body2;
  }

  /**
   * The smallest and the largest value of a size of a body.
   * @param {CustomBody} body
   * @param {Size} size
   */
  limitsOf({ shape }, size) {
    if (size === "radius") return this.#limits.ball_radius;
    if (size === "thickness") return this.#limits.bar_thickness;
    if (size === "height") return this.#limits.jar_height;
    return shape === "bar" ? this.#limits.bar_length : this.#limits.stick_length;
  }

  /** @param {number | null} index */
  select(index) {
    if (index === this.#selected) return;
    this.#selected = index;
    this.#changed();
  }

  /**
   * Selects the next body, or the one before.
   * @param {1 | -1} by
   */
  selectNext(by) {
    const { length } = this.#scene.bodies;
    this.select(this.#selected === null ? (by > 0 ? 0 : length - 1) : (this.#selected + by + length) % length);
  }

  /**
   * Moves the selected body's origin. Changes of one `gesture` (a drag, say) are undone together.
   * @param {number} x
   * @param {number} y
   * @param {unknown} [gesture]
   * @param {boolean} [exact] the numbers were typed
   */
  moveTo(x, y, gesture = null, exact = false) {
    const [atX, atY] = [x, y].map((value) => this.#onGrid(value, GRID, exact));
    this.#changeBody({ x: atX, y: atY }, gesture);
  }

  /**
   * Turns the selected body to an angle.
   * @param {number} degrees
   * @param {unknown} [gesture]
   * @param {boolean} [exact]
   */
  turnTo(degrees, gesture = null, exact = false) {
    const angle = wrapped(this.#onGrid(degrees, ANGLE_GRID, exact));
    // Ten thousandths of a radian are finer than hundredths of a degree.
    this.#changeBody({ angle: Math.round((angle / 180) * Math.PI * 1e4) / 1e4 }, gesture);
  }

  /**
   * Sets a size of the selected body, within its limits.
   * @param {Size} size
   * @param {number} value
   * @param {unknown} [gesture]
   * @param {boolean} [exact]
   */
  resizeTo(size, value, gesture = null, exact = false) {
    const body = this.body;
    if (!body || !SIZES[body.shape].includes(size)) return;
    const [least, most] = this.limitsOf(body, size);
    this.#changeBody({ [size]: Math.min(Math.max(this.#onGrid(value, GRID, exact), least), most) }, gesture);
  }

  /**
   * Makes the selected body dynamic or static; the green object stays dynamic.
   * @param {boolean} dynamic
   */
  setDynamic(dynamic) {
    if (this.#selected !== this.#scene.body1) this.#changeBody({ dynamic }, null);
  }

  /** Makes the selected body the green object; the goal, if it was that, changes places with it. */
  makeObject() {
    const index = this.#selected;
    if (index === null || index === this.#scene.body1) return;
    const { body1, body2, bodies } = this.#scene;
    const moving = bodies.map((body, at) => (at === index ? { ...body, dynamic: true } : body));
    this.#set({ ...this.#scene, body1: index, body2: body2 === index ? body1 : body2, bodies: moving });
  }

  /** Makes the selected body the goal; the green object, if it was that, changes places with it. */
  makeGoal() {
    const index = this.#selected;
    if (index === null || index === this.#scene.body2) return;
    const { body1, body2, bodies } = this.#scene;
    if (body1 !== index) return this.#set({ ...this.#scene, body2: index });
    this.#set({
      ...this.#scene,
      body1: body2,
      body2: index,
      bodies: bodies.map((body, at) => (at === body2 ? { ...body, dynamic: true } : body)),
    });
  }

  /**
   * Adds a body and selects it.
   * @param {CustomBody["shape"]} shape
   * @param {[x: number, y: number]} place of its origin, if there is room
   */
  add(shape, [x, y]) {
    this.#append(NEW_BODIES[shape](nearest(x, GRID.on), nearest(y, GRID.on)));
  }

  /** Adds a copy of the selected body beside it, and selects the copy. */
  duplicate() {
    const body = this.body;
    if (!body) return;
    const to = body.x + COPY_OFFSET > SCENE_SIZE ? -COPY_OFFSET : COPY_OFFSET;
    this.#append({ ...body, x: rounded(body.x + to), y: rounded(body.y + COPY_OFFSET) });
  }

  /** Removes the selected body. */
  remove() {
    const index = this.#selected;
    if (index === null || !this.canRemove) return;
    const { body1, body2, bodies } = this.#scene;
    /** @param {number} at */
    const moved = (at) => (at > index ? at - 1 : at);
    this.#selected = null;
    this.#set({
      ...this.#scene,
      body1: moved(body1),
      body2: moved(body2),
      bodies: bodies.filter((_, at) => at !== index),
    });
  }

  /** @param {string} name */
  rename(name) {
    /** @type {CustomScene} */
    const scene = { ...this.#scene, name: name.trim().slice(0, this.#limits.name_length) };
    if (!scene.name) delete scene.name;
    this.#set(scene, "name");
  }

  undo() {
    if (this.canUndo) this.#restore(this.#undoStack.undo());
  }

  redo() {
    if (this.canRedo) this.#restore(this.#undoStack.redo());
  }

  /**
   * @param {number} value
   * @param {{ on: number, off: number }} grid
   * @param {boolean} exact
   */
  #onGrid(value, grid, exact) {
    return exact ? rounded(value) : nearest(value, this.snap ? grid.on : grid.off);
  }

  /**
   * Adds a body where it may be, as near as it can to where it is wanted.
   * @param {CustomBody} body
   */
  #append(body) {
    if (!this.canAdd) return;
    const { bodies } = this.#scene;
    const index = bodies.length;
    const moved = (/** @type {number[]} */ [dx, dy]) => ({
      ...this.#scene,
      bodies: [...bodies, { ...body, x: rounded(body.x + dx), y: rounded(body.y + dy) }],
    });
    const fits = (/** @type {CustomScene} */ scene) =>
      pathlight.sceneProblems(scene).every((problem) => problem.body !== index && problem.other !== index);
    this.#selected = index;
    this.#set(PLACES.map(moved).find(fits) ?? moved(PLACES[0]));
  }

  /**
   * @param {object} patch
   * @param {unknown} gesture
   */
  #changeBody(patch, gesture) {
    const index = this.#selected;
    if (index === null) return;
    const bodies = this.#scene.bodies.map((body, at) => (at === index ? { ...body, ...patch } : body));
    this.#set({ ...this.#scene, bodies }, gesture);
  }

  /**
   * @param {CustomScene} scene
   * @param {unknown} [gesture]
   */
  #set(scene, gesture = null) {
    this.#scene = scene;
    this.#undoStack.push(JSON.stringify(scene), gesture);
    this.#changed();
  }

  /** @param {string} json */
  #restore(json) {
    this.#scene = JSON.parse(json);
    if (this.#selected !== null && this.#selected >= this.#scene.bodies.length) this.#selected = null;
    this.#changed();
  }

  #changed() {
    this.dispatchEvent(new Event("change"));
  }
}

/** @type {(value: number, grid: number) => number} */
const nearest = (value, grid) => Math.round(value / grid) * grid;
