// "It learns while you watch": the model plays puzzles of a kind that is new to it, one after the other, and remembers
// what each try taught. Beside it the same model plays without a memory. It plays in the worker, one puzzle ahead of
// what is shown.

import { SharedClient } from "../model/shared-client.js";
import { readResults } from "../model/results.js";
import { ATTEMPT_LIMIT } from "../shell/constants.js";
import { LEARNT_TASK } from "../home/home-tasks.js";
import { TEMPLATES } from "../puzzles/templates.js";
import { text } from "../text/text.js";
import { byId, focusIsLost, passFocus, setText } from "../widgets/dom.js";
import { PausableClock } from "./pausable-clock.js";
import { LearnsBoard } from "./learns-board.js";
import { LearnsKinds } from "./learns-kinds.js";
import { LearnsList } from "./learns-list.js";
import { playedWords, totalWords } from "./learns-words.js";

/** @typedef {import("./learns-words.js").Played} Played */
/** @typedef {import("../pkg/pathlight.js").TriedProposal} TriedProposal */
/** @typedef {import("./results-view.js").HrefOf} HrefOf */
/**
 * A puzzle that was played, with all tries, and what is remembered after it.
 * @typedef {{ played: Played, learned: TriedProposal[], fresh: TriedProposal[], memory: string }} Game
 */

/** Puzzles that are played in a row. */
const ROW = 20;
/** How long the end of a puzzle is shown, s; under reduced motion it is all that is shown. */
const PAUSE = 0.6;
const STILL = 1.6;

const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");

export class LearnsView {
  #play = byId(document, "learns-play", HTMLButtonElement);
  #next = byId(document, "learns-next", HTMLButtonElement);
  #finish = byId(document, "learns-finish", HTMLButtonElement);
  #forget = byId(document, "learns-forget", HTMLButtonElement);
  #learned = new LearnsBoard(byId(document, "learns-learned"));
  #fresh = new LearnsBoard(byId(document, "learns-fresh"));
  #kinds = new LearnsKinds(byId(document, "learns-kinds"), () => this.#onKind());
  #list;
  #client;
  /** The name of the model that is to play; empty until the results say which. */
  #model = "";
  /**
   * What was played since all was forgotten, by kind.
   * @type {Map<string, Played[]>}
   */
  #played = new Map();
  /**
   * What it remembers, as JSON.
   * @type {string | null}
   */
  #memory = null;
  /**
   * Ends what is being played; null while nothing is.
   * @type {AbortController | null}
   */
  #row = null;
  #clock = new PausableClock();
  /** Are all further puzzles of the row shown at their end only? */
  #hurries = false;

  /**
   * @param {WebAssembly.Module} module
   * @param {HrefOf} hrefOf the address of a task with a model; null if the link hides it
   */
  constructor(module, hrefOf) {
    this.#client = new SharedClient(module);
    this.#client.addEventListener("change", () => this.#onClient());
    this.#list = new LearnsList((task) => hrefOf(task, this.#model));
    // The second click of a double click must not pause what the first has started.
    this.#play.addEventListener("click", ({ detail }) => detail < 2 && this.#onPlay());
    this.#next.addEventListener("click", () => this.#skip());
    this.#finish.addEventListener("click", () => this.#hurry());
    this.#forget.addEventListener("click", () => this.#onForget());
    byId(document, "learns-retry").addEventListener("click", () => this.show());
  }

  /** Shows the kinds that are new to the model. */
  async show() {
    // What had the focus may be out of sight now.
    if (focusIsLost()) byId(document, "learns-title").focus();
    this.#fail(null);
    if (!this.#model) {
      try {
        const { models } = await readResults();
        const { name, tasks } = models.find(({ setup }) => setup === "cross") ?? models[0];
        this.#model = name;
        this.#kinds.show(
          TEMPLATES.map(({ id, name, tasks: all }) => ({
            id,
            name,
            tasks: all.filter((task) => tasks.includes(task)),
          })),
          LEARNT_TASK,
        );
      } catch (error) {
        return this.#fail(error);
      }
    }
    byId(document, "learns-body").hidden = false;
    this.#onKind();
  }

  /** Stops, and leaves the worker. What was played and is remembered stays. */
  stop() {
    this.#row?.abort();
    this.#client.stop();
  }

  /** What was played of the chosen kind. */
  get #all() {
    return this.#played.get(this.#kinds.chosen.id) ?? [];
  }

  get #left() {
    return this.#kinds.chosen.tasks.slice(this.#all.length);
  }

  #onKind() {
    this.#row?.abort();
    this.#row = null;
    const task = this.#left[0] ?? this.#kinds.chosen.tasks[0];
    for (const board of [this.#learned, this.#fresh]) board.clear(task);
    setText(byId(document, "learns-status"), "");
    this.#update();
  }

  #onPlay() {
    if (!this.#row) return void this.#playRow();
    this.#hurries = false;
    this.#clock.paused = !this.#clock.paused;
    this.#update();
  }

  /** Shows the end of the puzzle at once. */
  #skip() {
    this.#clock.skip();
    this.#update();
  }

  #hurry() {
    this.#hurries = true;
    this.#skip();
  }

  #onForget() {
    this.#played.clear();
    this.#memory = null;
    this.#onKind();
    setText(byId(document, "learns-status"), text.learns.forgotten);
    this.#play.focus();
  }

  async #playRow() {
    const row = (this.#row = new AbortController());
    this.#clock.paused = this.#hurries = false;
    this.#fail(null);
    this.#update();
    try {
      await this.#playAll(this.#left.slice(0, ROW), row.signal);
    } catch (error) {
      if (row.signal.aborted) return;
      this.#fail(error);
    }
    this.#row = null;
    const lost = [this.#next, this.#finish].some((button) => button === document.activeElement);
    this.#update();
    if (lost) this.#play.focus();
  }

  /**
   * @param {string[]} tasks
   * @param {AbortSignal} signal
   */
  async #playAll(tasks, signal) {
    await this.#client.ready(this.#model, signal);
    let next = this.#playOne(tasks[0], this.#memory, signal);
    for (const [index, task] of tasks.entries()) {
      const game = await next;
      if (index + 1 < tasks.length) {
        next = this.#playOne(tasks[index + 1], game.memory, signal);
        // A failure is handled when `next` is awaited, after this puzzle has been shown.
        next.catch(() => {});
      }
      await this.#showGame(task, game, signal);
    }
  }

  /**
   * Plays a puzzle with what is remembered, and without.
   * @param {string} task
   * @param {string | null} memory
   * @param {AbortSignal} signal
   * @returns {Promise<Game>}
   */
  async #playOne(task, memory, signal) {
    const [{ tries, memory: after }, fresh] = await Promise.all([
      this.#client.call("learn", [task, memory], signal),
      this.#client.call("propose", [task], signal),
    ]);
    const firstOf = (/** @type {TriedProposal[]} */ all) => (all.at(-1)?.ending.solved ? all.length : null);
    const played = { task, learned: firstOf(tries), fresh: firstOf(fresh), reminder: tries.at(-1)?.reminder ?? null };
    return { played, learned: tries, fresh, memory: after };
  }

  /**
   * Shows the tries at a puzzle, then what came of them.
   * @param {string} task
   * @param {Game} game
   * @param {AbortSignal} signal
   */
  async #showGame(task, { played, learned, fresh, memory }, signal) {
    const boards = [this.#learned, this.#fresh];
    const longest = Math.max(this.#learned.show(task, learned), this.#fresh.show(task, fresh));
    setText(byId(document, "learns-puzzle"), text.learns.puzzle(this.#all.length + 1));
    if (!this.#hurries && !reducedMotion.matches)
      await this.#clock.run(longest, signal, (time) => boards.forEach((board) => board.setTime(time)));
    for (const board of boards) board.setTime(Infinity);
    this.#memory = memory;
    this.#played.set(this.#kinds.chosen.id, [...this.#all, played]);
    const earlier = this.#all.slice(0, -1).map(({ task }) => task);
    const words = playedWords(played, earlier, ATTEMPT_LIMIT);
    setText(byId(document, "learns-status"), text.learns.status(this.#all.length, words));
    this.#update();
    await this.#clock.run(this.#hurries ? 0 : reducedMotion.matches ? STILL : PAUSE, signal);
  }

  #onClient() {
    const { status, progress } = this.#client;
    const done = progress && Math.floor(100 * progress) / 100;
    setText(byId(document, "learns-loading"), status === "loading" ? text.learns.fetching(done) : "");
  }

  /** Shows what was played, and what can be done. */
  #update() {
    const [all, left, playing] = [this.#all, this.#left.length, this.#row !== null];
    this.#list.show(all);
    const more = Math.min(left, ROW);
    const { play, playMore, goOn, pause, remembers, remembersNothing } = text.learns;
    const toPlay = all.length ? playMore(more) : play(more);
    setText(this.#play, playing ? (this.#clock.paused ? goOn : pause) : toPlay);
    this.#play.disabled = !playing && left === 0;
    this.#next.disabled = this.#finish.disabled = !playing;
    this.#forget.disabled = this.#memory === null;
    setText(byId(document, "learns-total"), all.length ? totalWords(all, ATTEMPT_LIMIT) : "");
    if (!playing) setText(byId(document, "learns-puzzle"), "");
    const played = [...this.#played.values()].flat();
    setText(byId(document, "learns-memory"), played.length ? remembers(played.length) : remembersNothing);
  }

  /** @param {unknown} error null if there is none any more */
  #fail(error) {
    const failure = byId(document, "learns-failure");
    if (error === null) passFocus(failure, byId(document, "learns-title"));
    failure.hidden = error === null;
    setText(byId(document, "learns-failure-words"), error === null ? "" : /** @type {Error} */ (error).message);
  }
}
