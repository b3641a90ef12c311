// After the player has solved a puzzle: in the panel Play what to do next, with a small celebration, which leaves the
// winning picture alone; and before, what a challenge asks for. Fires "share", a CustomEvent with a Result, when the
// person wants to share the puzzle, solved or not.

import { Component } from "../widgets/component.js";
import { setText } from "../widgets/dom.js";
import { text } from "../text/text.js";
import { kindOf, nextByDifficulty } from "../puzzles/difficulty.js";
import { TASKS } from "../puzzles/templates.js";
import { paintStill } from "./still.js";

/** @typedef {import("./session.js").Session} Session */

/**
 * What a person shares.
 * @typedef {object} Result
 * @property {string | null} task null for a custom scene
 * @property {string} name the puzzle's
 * @property {number | null} solvedAt at which attempt it was solved, also counting deleted ones; null if it is not
 * @property {{ used: number, solvedAt: number | null, remembers: boolean } | null} model how the model did, and whether
 *   it played with a memory; null if it has not played
 * @property {(context: CanvasRenderingContext2D, dark: boolean, ball: boolean) => void} paint draws the scene into a
 *   square canvas, until the puzzle is left; if `ball`, with the ball and paths of the person's solving attempt, and of
 *   the model's if there is one; without such an attempt, what is shown now
 * @property {() => boolean} isOpen whether the puzzle has not been left
 * @property {(() => Run) | null} openRun shows that attempt, or what has run, again; null if nothing has
 */

/**
 * A run, frame by frame.
 * @typedef {object} Run
 * @property {number} steps
 * @property {(context: CanvasRenderingContext2D, step: number, dark: boolean) => boolean} paint draws a step into a
 *   square canvas; false if something else is shown meanwhile
 */

/** How long the celebration stays, ms. */
const CELEBRATION = 2600;
/** The colours of its sparks in turn: custom properties of the palette. */
const COLOURS = ["green", "blue", "purple", "red", "ring"];
const SPARKS = 20;

export class AfterSolving extends Component {
  #progress;
  #hrefOf;
  #celebration = this.byId("celebration");
  #next = this.byId("solved-next", HTMLAnchorElement);
  #by = this.byId("next-by", HTMLSelectElement);
  /** @type {number | null} */
  #challenge = null;
  /** What the next puzzle was chosen for: to choose it takes too long for every step of a drag. */
  #reason = "";
  /** @type {number | undefined} */
  #timer;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../storage/progress.js").Progress} progress
   * @param {(task: string) => string | null} hrefOf the address of a puzzle, or null if there is no way to it
   */
  constructor(root, progress, hrefOf) {
    super(root);
    this.#progress = progress;
    this.#hrefOf = hrefOf;
    this.#celebration.append(...Array.from({ length: SPARKS }, (_, index) => spark(index)));
    this.#by.addEventListener("change", () => this.#update());
    this.byId("solved-share").addEventListener("click", () => this.share());
  }

  /** @param {Session} session */
  open(session) {
    super.open(session);
    this.listen("change", () => this.#update());
    this.listen("attempted", ({ shown }) => shown?.ending.solved && this.#celebrate());
    this.#update();
  }

  close() {
    super.close();
    this.#reason = "";
    this.#endCelebration();
  }

  /** @param {import("../state/view.js").View} view */
  setState({ challenge }) {
    this.#challenge = challenge;
    // The model that the address names is kept on the way.
    this.#reason = "";
    this.#update();
  }

  #update() {
    const { session } = this;
    const solvedAt = session && session.hiddenAuthor !== "player" ? session.attempts.playerTotal.solved_at : null;
    const section = this.byId("solved");
    // What is new stands at the top of the panel.
    if (section.hidden && solvedAt !== null) this.byId("tabpanel-play").scrollTop = 0;
    section.hidden = solvedAt === null;
    this.byId("challenge").hidden = this.#challenge === null;
    if (this.#challenge !== null) setText(this.byId("challenge"), challengeWords(this.#challenge, solvedAt));
    if (!session || solvedAt === null) return;
    this.byId("solved-title").textContent = text.play.afterSolving.title(solvedAt);
    // A custom scene has no id: nothing comes after it, and no link leads to it.
    const { id } = session.about;
    const reason = `${id} ${solvedAt} ${this.#by.value}`;
    if (reason !== this.#reason) {
      this.#reason = reason;
      const next = id && this.#nextTask(id);
      const href = next && this.#hrefOf(next);
      this.#next.hidden = !href;
      if (href) this.#next.href = href;
    }
    this.byId("solved-share").hidden = !id || this.#hrefOf(id) === null;
  }

  /**
   * The puzzle after this one that is not solved yet, by kind or difficulty.
   * @param {string} task
   */
  #nextTask(task) {
    const unsolved = TASKS.filter((other) => other !== task && this.#progress.player.of(other).solved === null);
    const { value } = this.#by;
    if (value === "harder" || value === "easier") return nextByDifficulty(task, unsolved, value);
    const kind = unsolved.filter((other) => kindOf(other) === kindOf(task));
    return (
      kind.find((other) => other > task) ?? kind[0] ?? unsolved.find((other) => other > task) ?? unsolved[0] ?? null
    );
  }

  share() {
    const { session } = this;
    if (!session) return;
    // What still runs for the first time is not told, nor a turn of the model that is not over.
    const solving = session.hiddenAuthor === "player" ? null : session.attempts.standing("player").solved_at;
    const modelPlays = session.hiddenAuthor === "model" || session.ghosts !== null;
    const standing = session.attempts.standing("model");
    const { used, solved_at: modelSolvedAt } = modelPlays ? { used: 0, solved_at: null } : standing;
    const { game, about, placing } = session;
    /** @type {Result} */
    const detail = {
      task: about.id,
      name: session.name,
      solvedAt: solving && session.attempts.playerTotal.solved_at,
      model: used > 0 ? { used, solvedAt: modelSolvedAt, remembers: session.attempts.modelName === null } : null,
      paint: (context, dark, ball) => {
        if (!ball) game.paintThumbnail(context, dark);
        else if (solving && modelSolvedAt) game.paintPair(context, solving, modelSolvedAt, dark);
        else if (solving) game.paintAttempt(context, "player", solving, dark);
        else paintStill(session, context, session.playback.step, dark);
      },
      isOpen: () => session === this.session,
      openRun: solving || !placing ? () => this.#openRun(session, solving) : null,
    };
    this.dispatchEvent(new CustomEvent("share", { detail }));
  }

  /**
   * @param {Session} session
   * @param {number | null} number of the attempt; null for what is shown
   * @returns {Run}
   */
  #openRun(session, number) {
    if (number) session.replay("player", number);
    session.seek(session.playback.last);
    const { shown } = session;
    const isShown = () => session === this.session && session.shown === shown;
    return {
      steps: session.playback.last,
      paint: (context, step, dark) => {
        if (isShown()) paintStill(session, context, step, dark);
        return isShown();
      },
    };
  }

  #celebrate() {
    this.#endCelebration();
    this.#celebration.hidden = false;
    this.#timer = setTimeout(() => this.#endCelebration(), CELEBRATION);
  }

  #endCelebration() {
    clearTimeout(this.#timer);
    this.#celebration.hidden = true;
  }
}

/**
 * @param {number} challenge
 * @param {number | null} solvedAt
 */
function challengeWords(challenge, solvedAt) {
  const words = text.play.afterSolving.challenge;
  if (solvedAt === null) return words.asked(challenge);
  if (solvedAt === challenge) return words.equal;
  return solvedAt < challenge ? words.beaten(challenge) : words.missed(challenge);
}

/**
 * A spark; the style sheet lets it fall through the panel beside the words, or shows it at its place.
 * @param {number} index
 */
function spark(index) {
  const element = document.createElement("span");
  // Spread evenly without a pattern: the low-discrepancy sequence R2.
  const [across, down] = [0.7549, 0.5698].map((step) => (index * step) % 1);
  element.style.setProperty("--x", `${72 + 26 * across}%`);
  element.style.setProperty("--y", `${8 + 84 * down}%`);
  element.style.animationDelay = `${1 - down}s`;
  element.style.background = `var(--${COLOURS[index % COLOURS.length]})`;
  return element;
}
