// Values in order, to undo and redo changes: the placements of a puzzle, the scenes of an editor. Knows nothing of what
// they are.

/** @template Value */
export class UndoStack {
  /** @type {Value[]} */
  #values;
  #index = 0;
  /**
   * The gesture that the newest value belongs to, or null.
   * @type {unknown}
   */
  #gesture = null;

  /** @param {Value} first */
  constructor(first) {
    this.#values = [first];
  }

  /**
   * Adds a value; values that had been undone are forgotten. Values of one gesture (anything but null) are one step.
   * @param {Value} value
   * @param {unknown} [gesture]
   */
  push(value, gesture = null) {
    if (String(value) === String(this.#values[this.#index])) return;
    const same = gesture !== null && gesture === this.#gesture;
    this.#values.length = this.#index + 1;
    if (same) this.#values[this.#index] = value;
    else this.#index = this.#values.push(value) - 1;
    this.#gesture = gesture;
  }

  get canUndo() {
    return this.#index > 0;
  }

  get canRedo() {
    return this.#index < this.#values.length - 1;
  }

  /** Returns the value before the present one; the first stays. */
  undo() {
    return this.#move(-1);
  }

  /** Returns the value after the present one; the last stays. */
  redo() {
    return this.#move(1);
  }

  /** @param {number} by */
  #move(by) {
    this.#gesture = null;
    this.#index = Math.min(Math.max(this.#index + by, 0), this.#values.length - 1);
    return this.#values[this.#index];
  }
}
