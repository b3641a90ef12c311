// The placements of one puzzle in the order they were made, to undo and redo them. Knows nothing of what a
// placement is: it keeps values and gives them back.

export class History {
  #values;
  #at = 0;
  /** The gesture that the newest value belongs to, or null. */
  #gesture = null;

  constructor(first) {
    this.#values = [first];
  }

  /** Takes a new value; what had been undone is forgotten. Values of one gesture (anything but null) are one step. */
  put(value, gesture = null) {
    if (String(value) === String(this.#values[this.#at])) return;
    const same = gesture !== null && gesture === this.#gesture;
    this.#values.length = this.#at + 1;
    if (same) this.#values[this.#at] = value;
    else this.#at = this.#values.push(value) - 1;
    this.#gesture = gesture;
  }

  get canUndo() {
    return this.#at > 0;
  }

  get canRedo() {
    return this.#at < this.#values.length - 1;
  }

  /** The value before the present one; the first has none before it and stays. */
  undo() {
    return this.#move(-1);
  }

  redo() {
    return this.#move(1);
  }

  #move(by) {
    this.#gesture = null;
    this.#at = Math.min(Math.max(this.#at + by, 0), this.#values.length - 1);
    return this.#values[this.#at];
  }
}
