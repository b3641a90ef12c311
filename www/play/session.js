// One puzzle being played: the ball being placed, the rollout being shown, the attempts of player and model.
// Wraps the wasm's Puzzle and the clock; the parts of the page ask it to do things and listen:
//   "change" something to read has changed      "draw" only the picture has
//   "attempt" an attempt of the player's that was new is over, with { solved }
// Knows nothing of the document.

import { History } from "./undo-stack.js";
import { Playback } from "./playback.js";

/** Where a ball starts that is first moved by keys, px. */
const MIDDLE = 128;
const FIRST_RADIUS = 12;

export class Session extends EventTarget {
  /** The wasm's Puzzle. */
  puzzle;
  about;
  playback = new Playback();
  /** [x, y, r] in whole px, or null. */
  ball = null;
  /** Why the ball may not be placed, or null. */
  reason = null;
  /** What is on: "placing", "attempt", "watch", "compare". */
  phase = "placing";
  /** The attempt that is shown: { agent, number, words, ball, ending }; only while phase is "attempt". */
  shown = null;
  /** Is the player's last attempt running for the first time? Then nothing tells yet how it ends. */
  unseen = false;
  /** The one or two attempts that lie over each other, the player's first; only while phase is "compare". */
  pair = [];
  /** The last refusal in words, or null. */
  refused = null;
  /** Has what is shown come to its end at least once? */
  finished = false;
  #drawing = false;
  #still;
  #history = new History(null);

  /** `still`: says whether motion is unwanted; then a run goes straight to its end. */
  constructor(puzzle, still) {
    super();
    this.puzzle = puzzle;
    this.about = puzzle.about();
    this.#still = still;
    this.playback.addEventListener("moment", () => this.#moment());
  }

  get placing() {
    return this.phase === "placing";
  }

  /** Puts the ball being placed somewhere, in px; it is rounded and kept inside the square. Placements of one
   * `gesture` (a drag, say) are undone together. */
  place([x, y, r], gesture = null) {
    const between = (value, low, high) => Math.min(Math.max(Math.round(value), low), high);
    const ball = [between(x, 0, 255), between(y, 0, 255), between(r, 2, 32)];
    this.#history.put(ball, gesture);
    this.#take(ball);
  }

  /** Moves the ball and changes its radius by so many px; a first ball appears in the middle. */
  nudge(dx, dy, dr, gesture = null) {
    const [x, y, r] = this.ball ?? [MIDDLE - dx, MIDDLE - dy, FIRST_RADIUS - dr];
    this.place([x + dx, y + dy, r + dr], gesture);
  }

  get canUndo() {
    return this.#history.canUndo;
  }

  get canRedo() {
    return this.#history.canRedo;
  }

  undo() {
    if (this.canUndo) this.#take(this.#history.undo());
  }

  redo() {
    if (this.canRedo) this.#take(this.#history.redo());
  }

  #take(ball) {
    this.ball = ball;
    this.reason = (ball && this.puzzle.whyInvalid(...ball)) ?? null;
    this.refused = null;
    if (this.placing) this.#changed("change");
    else this.reset();
  }

  /** What the run button does now: run the ball, pause, or go on. */
  run() {
    if (!this.placing) {
      if (this.playback.playing) this.playback.pause();
      else this.playback.play();
      this.#changed("change");
    } else if (!this.ball) {
      this.#refuse("Place the ball first: click or tap in the scene, or press an arrow key there.");
    } else {
      this.#try();
    }
  }

  #try() {
    try {
      const before = this.puzzle.score("player").used;
      const attempt = this.puzzle.attempt(...this.ball);
      this.#show("attempt", { agent: "player", ...attempt }, true, attempt.number > before);
    } catch (error) {
      if (!error.code) throw error;
      this.#refuse(`${sentence(error.message)} That does not count as an attempt.`);
    }
  }

  /** Shows the scene without a ball. */
  watch() {
    this.puzzle.watch();
    this.#show("watch", null);
  }

  /** Shows an attempt again; it does not count once more. */
  replay(agent, number) {
    const attempt = this.puzzle.replay(agent, number);
    if (agent === "player") {
      this.ball = attempt.ball;
      this.reason = null;
      this.#history.put(attempt.ball);
    }
    this.#show("attempt", { agent, ...attempt });
  }

  /** Shows at its end what the model's ball of this number comes to; it does not count. `tried`: has it been an attempt? */
  rehearse(number, ball, tried) {
    const attempt = this.puzzle.rehearse(...ball);
    this.#show("attempt", { ...attempt, agent: "model", number, tried, rehearsed: number }, false);
  }

  /** Is the scene drawn on, instead of a ball placed in it? */
  get drawing() {
    return this.#drawing;
  }

  set drawing(drawing) {
    if (drawing === this.#drawing) return;
    this.#drawing = drawing;
    this.#changed("change");
  }

  /** Shows the best attempts of both over each other: at their end, or from the start. */
  compare(play) {
    const [player, model] = this.puzzle.compare();
    this.pair = [player && { agent: "player", ...player }, model && { agent: "model", ...model }].filter(Boolean);
    if (this.pair.length === 0) return this.reset();
    this.#show("compare", null, play);
  }

  /** Lays an attempt over another: over the one that is shown, else over the other agent's last, else its neighbour. */
  overlay(agent, number) {
    const self = { agent, number };
    const other = this.#partner(self);
    if (!other) return this.replay(agent, number);
    const pair = agent === "model" && other.agent === "player" ? [other, self] : [self, other];
    const laid = this.puzzle.overlay(pair[0].agent, pair[0].number, pair[1].agent, pair[1].number);
    this.pair = laid.map((attempt, index) => ({ agent: pair[index].agent, ...attempt }));
    this.#show("compare", null);
  }

  #partner({ agent, number }) {
    const another = (one) => one.agent !== agent || one.number !== number;
    if (this.onShow.length === 1 && another(this.onShow[0])) return this.onShow[0];
    const rival = agent === "player" ? "model" : "player";
    const { used } = this.puzzle.score(rival);
    if (used > 0) return { agent: rival, number: used };
    const neighbour = number > 1 ? number - 1 : 2;
    return neighbour <= this.puzzle.score(agent).used ? { agent, number: neighbour } : null;
  }

  /** The attempts that are being shown. */
  get onShow() {
    if (this.phase === "compare") return this.pair;
    return this.shown && !this.shown.rehearsed ? [this.shown] : [];
  }

  /** Deletes an attempt; those after it move up by one. */
  remove(agent, number) {
    this.puzzle.remove(agent, number);
    // What is shown may be the one that is gone, or have another number now.
    if (this.placing) this.#changed("change");
    else this.reset();
  }

  /** Back to placing, with the ball where it was. */
  reset() {
    this.#settle();
    this.puzzle.reset();
    this.phase = "placing";
    this.shown = null;
    this.playback.load(0);
    this.#changed("change");
  }

  /** Steps by one, forward or back; while placing, it first runs the ball. */
  step(by) {
    if (this.placing) {
      this.run();
      if (this.placing) return;
      this.playback.seek(0);
    }
    this.playback.seek(Math.floor(this.playback.step) + by);
    this.#changed("change");
  }

  seek(step) {
    this.playback.seek(step);
    this.#changed("change");
  }

  /** Adds an attempt of the model's that the worker has simulated. */
  record(attempt) {
    this.puzzle.record(attempt);
    this.#changed("change");
  }

  clear() {
    this.puzzle.clear("player");
    this.puzzle.clear("model");
    this.reset();
  }

  /** Stops the clock and gives the wasm's memory back. */
  close() {
    this.#settle();
    this.playback.pause();
    this.puzzle.free();
  }

  #show(phase, attempt, play = true, unseen = false) {
    this.#settle();
    this.phase = phase;
    this.shown = attempt;
    this.refused = null;
    this.finished = false;
    this.unseen = unseen;
    const last = this.puzzle.steps();
    const still = !play || this.#still();
    this.playback.load(last, still ? last : 0);
    if (!still) this.playback.play();
    this.#changed("change");
  }

  #moment() {
    const { playing, ended } = this.playback;
    if (!this.placing && ended && !playing && !this.finished) {
      this.finished = true;
      this.#settle();
      this.#changed("change");
    }
    this.#changed("draw");
  }

  /** The player's new attempt has run to its end, or the player has turned from it: now it may be told. */
  #settle() {
    if (!this.unseen) return;
    this.unseen = false;
    this.dispatchEvent(new CustomEvent("attempt", { detail: { solved: this.shown.ending.solved } }));
  }

  #refuse(words) {
    this.refused = words;
    this.#changed("change");
  }

  #changed(what) {
    this.dispatchEvent(new Event(what));
  }
}

/** Words as a sentence: "the ball …" becomes "The ball ….". */
export function sentence(words) {
  return words[0].toUpperCase() + words.slice(1) + (/[.!?]$/.test(words) ? "" : ".");
}
