// The controls round the scene: the transport below it, the status line, and the fields of the ball being placed.

import { Component } from "../widgets/component.js";
import {
  FIRST_RADIUS,
  GOAL_SECONDS,
  MAX_RADIUS,
  MIN_RADIUS,
  SCENE_SIZE,
  STEPS_PER_SECOND,
} from "../shell/constants.js";
import { afterFrame } from "../loading/after-frame.js";
import { difficultyWords } from "../puzzles/difficulty.js";
import { find, setText } from "../widgets/dom.js";
import { text } from "../text/text.js";
import { statusOf } from "./status.js";

/** @typedef {import("./session.js").Session} Session */

/** Half of the width of the mark where the object came nearest, as a fraction of the time line. */
const CLOSEST_WIDTH = 0.004;

/** Time without a move after which a ball is at rest, and its place is announced, ms; before its chance is. */
const REST = 400;

export class Controls extends Component {
  #time = this.byId("time", HTMLInputElement);
  #radius = this.byId("radius", HTMLInputElement);
  #fields = ["ball-x", "ball-y", "ball-r"].map((id) => this.byId(id, HTMLInputElement));
  #goalMeter = this.byId("goal-meter");
  /**
   * Where the ball is, as it was last announced.
   * @type {string | null}
   */
  #place = null;
  /** @type {number | undefined} */
  #timer;
  /** Was a puzzle open before? */
  #opened = false;
  /**
   * The first and last steps of the stretches in which the green object touches its goal, in what is shown.
   * @type {[first: number, last: number][]}
   */
  #touches = [];

  /** @param {import("../widgets/dom.js").Root} root */
  constructor(root) {
    super(root);
    for (const input of [this.#radius, this.#fields[2]])
      Object.assign(input, { min: String(MIN_RADIUS), max: String(MAX_RADIUS) });
    for (const field of this.#fields.slice(0, 2)) field.max = String(SCENE_SIZE - 1);
    this.#goalMeter.setAttribute("aria-valuemax", String(GOAL_SECONDS));
    /** @type {(id: string, act: (session: Session) => void) => void} */
    const onClick = (id, act) => this.byId(id).addEventListener("click", () => this.session && act(this.session));
    this.byId("run").addEventListener("click", ({ detail }) => {
      // The second click of a double click must not pause what the first has started.
      if (detail < 2 || !this.session?.playback.playing) this.session?.run();
    });
    onClick("step", (session) => session.step(1));
    onClick("reset", (session) => session.reset());
    onClick("see-closest", (session) => session.approach && session.seek(session.approach.step));
    onClick("skip-quiet", (session) => session.skipQuiet());
    onClick("watch", (session) => session.watch());
    onClick("undo", (session) => session.placement.undo());
    onClick("redo", (session) => session.placement.redo());
    this.#time.addEventListener("input", () => this.session?.seek(Number(this.#time.value)));
    this.byId("speed").addEventListener("change", () => this.#applySpeed());
    this.#radius.addEventListener("input", () => this.session?.placement.resize(Number(this.#radius.value), "radius"));
    for (const field of this.#fields) field.addEventListener("change", () => this.#onTyped());
  }

  close() {
    super.close();
    clearTimeout(this.#timer);
  }

  /** @param {Session} session */
  open(session) {
    super.open(session);
    // The first one is read when its scene gets the focus.
    if (this.#opened) this.announce(`${session.name}. ${session.goal}`);
    this.#opened = true;
    this.#applySpeed();
    this.byId("goal").textContent = session.goal;
    this.byId("story").textContent = session.story;
    this.byId("difficulty").textContent = "";
    afterFrame().then(() => session === this.session && this.#showDifficulty(session));
    this.byId("description").textContent = session.description;
    this.listen("change", () => this.#update(session));
    this.listen("draw", () => this.#updateTime(session));
    this.#place = placeWords(session);
    this.#update(session);
  }

  /** @param {Session} session */
  #showDifficulty({ about: { id } }) {
    this.byId("difficulty").textContent = id ? text.puzzles.facts(id, difficultyWords(id)) : "";
  }

  #applySpeed() {
    if (this.session) this.session.playback.speed = Number(this.byId("speed", HTMLSelectElement).value);
  }

  /** Takes the three numbers once all are there. Of a ball that is there none can be left out. */
  #onTyped() {
    const { session } = this;
    const texts = this.#fields.map(({ value }) => value);
    const [x, y, r] = texts.map(Number);
    if (texts.every((text) => text !== "" && Number.isFinite(Number(text)))) session?.placement.place([x, y, r]);
    else if (session?.ball) this.#update(session);
  }

  /** @param {Session} session */
  #update(session) {
    const { placing, phase, game, ball } = session;
    const { playing, last, ended } = session.playback;
    const drops = placing && (session.state.tool !== "line" || ball);
    const words = text.play.run;
    const label = placing
      ? drops
        ? words.drop
        : words.run
      : playing
        ? words.pause
        : ended
          ? words.replay
          : words.goOn;
    setText(this.byId("run-label"), label);
    this.byId("run-icon", SVGUseElement).setAttribute("href", playing ? "#icon-pause" : "#icon-run");
    this.byId("run").title = `${label}  ${text.element.keys.space}`;
    this.#time.disabled = placing;
    this.#time.max = String(last);
    this.setDisabled(this.byId("reset", HTMLButtonElement), placing);
    this.setDisabled(this.byId("undo", HTMLButtonElement), !session.placement.canUndo);
    this.setDisabled(this.byId("redo", HTMLButtonElement), !session.placement.canRedo);
    this.#touches = placing ? [] : game.touches();
    // Of two rollouts over each other the meter could mean either; of one that never touched it has nothing to say.
    this.#goalMeter.hidden = placing || phase === "compare" || session.approach !== null;
    this.setHidden(this.byId("see-closest"), session.approach === null);
    // Marks of a new attempt would tell how it ends.
    if (session.hiddenAuthor === null) this.#markMoments(last + 1, session.approach?.step);
    else this.#time.style.setProperty("--touches", "none");
    this.#fields.forEach((field, index) => setValue(field, String(ball?.[index] ?? "")));
    setValue(this.#radius, String(ball?.[2] ?? FIRST_RADIUS));
    this.#announceBall(session);
    const { kind, words: said } = statusOf(session);
    const status = this.byId("status");
    if (status.textContent !== said) {
      status.textContent = said;
      // The misses of the model's turn go by faster than they can be read out.
      if (!session.ghosts || session.shown?.number === 1) this.announce(said);
    }
    status.dataset.kind = kind;
    this.#updateTime(session);
  }

  /**
   * Says where a ball that was moved has come to rest, to those who cannot see it.
   * @param {Session} session
   */
  #announceBall(session) {
    const words = placeWords(session);
    if (words === this.#place) return;
    clearTimeout(this.#timer);
    if (words) this.#timer = setTimeout(() => this.announce(words), REST);
    this.#place = words;
  }

  /** @param {Session} session */
  #updateTime({ playback: { step, seconds, last }, quietEnd }) {
    this.setHidden(this.byId("skip-quiet"), quietEnd === null);
    setValue(this.#time, String(Math.floor(step)));
    this.#time.setAttribute("aria-valuetext", text.play.spokenTime(seconds));
    this.#time.style.setProperty("--done", String(last ? step / last : 0));
    setText(this.byId("clock"), text.play.time(seconds));
    this.#updateGoalMeter(Math.floor(step));
  }

  /**
   * Shows how long the goal has held without a break, up to a step.
   * @param {number} step
   */
  #updateGoalMeter(step) {
    const [first] = this.#touches.find(([begin, end]) => begin <= step && step <= end) ?? [step + 1];
    const seconds = Math.min((step + 1 - first) / STEPS_PER_SECOND, GOAL_SECONDS);
    const words = text.play.meter(seconds, GOAL_SECONDS);
    const label = find(this.#goalMeter, ":scope > span");
    if (label.textContent === words) return;
    label.textContent = words;
    this.#goalMeter.setAttribute("aria-valuenow", seconds.toFixed(1));
    this.#goalMeter.setAttribute("aria-valuetext", text.play.spokenMeter(seconds, GOAL_SECONDS));
    this.#goalMeter.style.setProperty("--percent", String((100 * seconds) / GOAL_SECONDS));
  }

  /**
   * Marks on the time line when the green object touches its goal, or when it came nearest to it.
   * @param {number} steps
   * @param {number} [closest]
   */
  #markMoments(steps, closest) {
    const percent = (/** @type {number} */ step) => `${((100 * step) / steps).toFixed(2)}%`;
    const bands = this.#touches.map(([first, last]) => band("ring", percent(first), percent(last + 1)));
    if (closest !== undefined)
      bands.push(band("text", percent(closest - CLOSEST_WIDTH * steps), percent(closest + CLOSEST_WIDTH * steps)));
    this.#time.style.setProperty("--touches", bands.length ? `linear-gradient(to right, ${bands.join(", ")})` : "none");
  }
}

/**
 * Where the ball is that is being placed; null if there is none, or it may not be there.
 * @param {Pick<Session, "placing" | "ball" | "invalidReason">} session
 */
function placeWords({ placing, ball, invalidReason }) {
  return placing && ball && invalidReason === null ? text.attempts.replays.ball(...ball) : null;
}

/**
 * @param {string} colour
 * @param {string} from
 * @param {string} to
 */
function band(colour, from, to) {
  return `transparent ${from}, var(--${colour}) ${from}, var(--${colour}) ${to}, transparent ${to}`;
}

/**
 * Sets a value only where it differs: the caret of a field that is being typed in stays.
 * @param {HTMLInputElement} input
 * @param {string} value
 */
function setValue(input, value) {
  if (input.value !== value) input.value = value;
}
