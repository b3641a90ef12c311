// What the model remembers of the puzzles that it and the person have played, while it is switched on: attempts go in
// by the worker, which has the wasm's `Memory`, and are kept by storage/kept-memory.js. What was tried at a puzzle
// never counts there, only at others: the person's ball must not tell the model how to solve the same puzzle.
//
//   switch   it has been switched on or off
//   change   it remembers something else, or another model is loaded

import { puzzleKey } from "../shell/puzzle-key.js";

/** @typedef {import("../pkg/pathlight.js").Ball} Ball */
/** @typedef {import("../pkg/pathlight.js").TriedProposal} TriedProposal */
/** @typedef {import("./shared-client.js").SharedClient} SharedClient */
/** @typedef {Pick<import("../play/session.js").Session, "puzzle" | "about">} Open */
/**
 * The earlier puzzle that led to a ball: a task, or a custom puzzle, which may have a name.
 * @typedef {{ task: string | null, name: string | null, mirrored: boolean }} Source
 */

export class ModelMemory extends EventTarget {
  /** What it remembers; `damaged` is said until the puzzle is left. */
  kept;
  #client;
  #switchedOn = false;
  /** What the person has tried while there was no model. @type {[open: Open, ball: Ball, solved: boolean][]} */
  #waiting = [];

  /**
   * @param {SharedClient} client
   * @param {import("../storage/kept-memory.js").KeptMemory} kept
   */
  constructor(client, kept) {
    super();
    this.#client = client;
    this.kept = kept;
    client.addEventListener("change", () => {
      // Without a model there is nothing to tell; and the store, which all puzzles share, keeps no removed one alive.
      if (client.status === "off") kept.removeEventListener("change", this.#changed);
      else kept.addEventListener("change", this.#changed);
      if (client.status === "ready") for (const attempt of this.#waiting.splice(0)) this.remember(...attempt);
      this.#changed();
    });
  }

  /** The loaded model's; empty if there is none, which remembers nothing. */
  get #name() {
    return this.#client.loaded?.name ?? "";
  }

  /** Does the loaded model play with what it remembers? */
  get on() {
    return this.#switchedOn && this.able === true;
  }

  /** Can the loaded model play with a memory? Only one that imagines balls can; null while none is loaded. */
  get able() {
    const { loaded } = this.#client;
    return loaded && loaded.card.dynamics !== undefined;
  }

  /** @param {boolean} on */
  switch(on) {
    if (on === this.#switchedOn) return;
    this.#switchedOn = on;
    if (!on) this.#waiting = [];
    this.dispatchEvent(new Event("switch"));
  }

  /** How many puzzles the loaded model remembers. */
  get count() {
    return this.kept.puzzles(this.#name).length;
  }

  /** Forgets all that the loaded model remembers. */
  forget() {
    this.kept.forget(this.#name);
  }

  /**
   * Plays the model's turn. Once it has ended, it is remembered.
   * @param {Open} open
   * @param {AbortSignal} signal
   * @param {(attempt: TriedProposal, source: Source | null) => void} onAttempt
   */
  async play(open, signal, onAttempt) {
    await this.#ask(open, async ({ puzzles, json }) => {
      const onUpdate = (/** @type {TriedProposal} */ attempt) => onAttempt(attempt, sourceOf(attempt, puzzles));
      return (await this.#client.call("learn", [open.puzzle, json], signal, onUpdate)).memory;
    });
  }

  /**
   * Remembers an attempt of the person's, as soon as there is a model.
   * @param {Open} open
   * @param {Ball} ball
   * @param {boolean} solved
   */
  async remember(open, ball, solved) {
    if (!this.#switchedOn) return;
    if (this.#client.status !== "ready") return void this.#waiting.push([open, ball, solved]);
    if (!this.able) return;
    const { signal } = new AbortController();
    try {
      await this.#ask(open, ({ json }) => this.#client.call("remember", [open.puzzle, ball, solved, json], signal));
    } catch {
      // The worker has ended, which is told elsewhere. Only this attempt is not remembered.
    }
  }

  /**
   * Asks the worker for a memory in which the open puzzle is the last, and keeps it.
   * @param {Open} open
   * @param {(others: ReturnType<ModelMemory["kept"]["without"]>) => Promise<string>} call
   */
  async #ask({ puzzle, about }, call) {
    const name = this.#name;
    const key = puzzleKey(puzzle);
    const others = () => this.kept.without(name, key);
    const json = await call(others()).catch((error) => {
      if (error.code !== "bad_memory") throw error;
      // Damaged, or of other weights: it begins anew.
      this.kept.dropDamaged(name);
      return call(others());
    });
    this.kept.add(name, { key, name: about.id === null ? about.name : null }, json);
  }

  #changed = () => {
    this.dispatchEvent(new Event("change"));
  };
}

/**
 * Which puzzle led to a ball, if one did.
 * @param {TriedProposal} attempt
 * @param {import("../storage/kept-memory.js").Remembered[]} puzzles those that were remembered, in order
 * @returns {Source | null}
 */
function sourceOf({ reminder }, puzzles) {
  // A puzzle may also have spoken against the ball, or for it only by what failed elsewhere.
  if (!reminder?.solved || reminder.change < 0) return null;
  const { puzzle, task = null, mirrored } = reminder;
  return { task, name: puzzles[puzzle - 1]?.name ?? null, mirrored };
}
