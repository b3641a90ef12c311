// What stands round the scene: the transport below it, the status line, and the fields of the ball being placed.

import { say } from "../shell/announce.js";
import { sentence } from "./session.js";

const at = (id) => document.getElementById(id);
const set = (id, property, value) => {
  const element = at(id);
  if (element[property] !== value) element[property] = value;
};

/** How long the goal has to hold, and steps in a second, as in the simulator. */
const GOAL_SECONDS = 3;
const STEPS_PER_SECOND = 60;

export class Controls {
  #session = null;
  /** The stretches of steps in which the green object touches its goal, in what is shown. */
  #touches = [];

  constructor() {
    const session = () => this.#session;
    at("run").addEventListener("click", () => session().run());
    at("step").addEventListener("click", () => session().step(1));
    at("reset").addEventListener("click", () => session().reset());
    at("watch").addEventListener("click", () => session().watch());
    at("undo").addEventListener("click", () => session().undo());
    at("redo").addEventListener("click", () => session().redo());
    at("time").addEventListener("input", () => session().seek(Number(at("time").value)));
    at("speed").addEventListener("change", () => this.#speed());
    at("placing").addEventListener("submit", (event) => event.preventDefault());
    at("radius").addEventListener("input", () => {
      const [x, y] = session().ball ?? [128, 128];
      session().place([x, y, Number(at("radius").value)], "radius");
    });
    for (const id of ["ball-x", "ball-y", "ball-r"]) at(id).addEventListener("change", () => this.#typed());
  }

  show(session) {
    this.#session = session;
    this.#speed();
    at("goal").textContent = session.about.goal;
    at("story").textContent = session.about.story;
    at("description").textContent = session.about.description;
    session.addEventListener("change", () => this.#update());
    session.addEventListener("draw", () => this.#tick());
    this.#update();
  }

  #speed() {
    if (this.#session) this.#session.playback.speed = Number(at("speed").value);
  }

  /** Takes the three numbers once all are there. */
  #typed() {
    const texts = ["ball-x", "ball-y", "ball-r"].map((id) => at(id).value);
    if (texts.every((text) => text !== "" && Number.isFinite(Number(text)))) this.#session.place(texts.map(Number));
  }

  #update() {
    const session = this.#session;
    const { playing, last, ended } = session.playback;
    const label = session.placing ? "Run" : playing ? "Pause" : ended ? "Again" : "Go on";
    set("run-label", "textContent", label);
    at("run-icon").setAttribute("href", playing ? "#icon-pause" : "#icon-run");
    at("run").title = `${label}  Space`;
    set("time", "disabled", session.placing);
    set("time", "max", String(last));
    set("reset", "disabled", session.placing);
    set("undo", "disabled", !session.canUndo);
    set("redo", "disabled", !session.canRedo);
    this.#touches = session.placing ? [] : session.puzzle.touches();
    // Of two rollouts over each other the ring could be either's.
    at("hold").hidden = session.placing || session.phase === "compare";
    this.#bands();
    const [x, y, r] = session.ball ?? ["", "", ""];
    set("ball-x", "value", String(x));
    set("ball-y", "value", String(y));
    set("ball-r", "value", String(r));
    set("radius", "value", String(r || 12));
    const { kind, words } = status(session);
    if (at("status").textContent !== words) {
      at("status").textContent = words;
      say(words);
    }
    at("status").dataset.kind = kind;
    this.#tick();
  }

  #tick() {
    const { step, seconds, last } = this.#session.playback;
    set("time", "value", String(Math.floor(step)));
    at("time").setAttribute("aria-valuetext", `${seconds.toFixed(1)} seconds`);
    at("time").style.setProperty("--done", last ? step / last : 0);
    set("clock", "textContent", `${seconds.toFixed(1)} s`);
    this.#hold(Math.floor(step));
  }

  /** The three-second ring: how long the goal has held without a break, up to a step. */
  #hold(step) {
    const [first] = this.#touches.find(([first, last]) => first <= step && step <= last) ?? [step + 1];
    const held = Math.min((step + 1 - first) / STEPS_PER_SECOND, GOAL_SECONDS);
    const words = `${held.toFixed(1)} of ${GOAL_SECONDS} s`;
    const hold = at("hold");
    if (hold.lastElementChild.textContent === words) return;
    hold.lastElementChild.textContent = words;
    hold.setAttribute("aria-valuenow", held.toFixed(1));
    hold.setAttribute("aria-valuetext", `${held.toFixed(1)} of ${GOAL_SECONDS} seconds`);
    hold.style.setProperty("--held", (100 * held) / GOAL_SECONDS);
  }

  /** Marks on the time line when the green object touches its goal. */
  #bands() {
    const steps = this.#session.playback.last + 1;
    const bands = this.#touches.map(([first, last]) => {
      const [from, to] = [first, last + 1].map((step) => `${((100 * step) / steps).toFixed(2)}%`);
      return `transparent ${from}, var(--ring) ${from}, var(--ring) ${to}, transparent ${to}`;
    });
    at("time").style.setProperty("--touches", bands.length ? `linear-gradient(to right, ${bands.join(", ")})` : "none");
  }
}

/** What a comparison shows. */
function compared([first, second]) {
  const named = ({ agent, number }) => `${agent === "player" ? "your" : "the model’s"} attempt ${number}`;
  if (second) return sentence(`${named(first)} and ${named(second)}, over each other; the second is dashed`);
  return sentence(`${named(first)}; ${first.agent === "player" ? "the model has" : "you have"} made none`);
}

/** The session in one sentence, and its kind for the eye. */
function status(session) {
  const { phase, ball, reason, refused, shown, finished, drawing } = session;
  if (phase === "placing") {
    if (refused) return { kind: "wrong", words: refused };
    if (drawing) return { kind: "hint", words: "Draw in the scene the path that the green object will take." };
    if (!ball) return { kind: "hint", words: "Click or tap the scene to place the red ball." };
    if (reason) return { kind: "wrong", words: `Not here: ${sentence(reason)}` };
    return { kind: "ready", words: "The ball may start here. Press Run." };
  }
  if (phase === "watch") return { kind: "hint", words: finished ? "That was the scene without a ball." : "The scene without a ball." };
  if (phase === "compare") return { kind: "hint", words: compared(session.pair) };
  const what = `${shown.agent === "player" ? "Your" : "The model’s"} ${shown.rehearsed ? "ball" : "attempt"} ${shown.number}`;
  if (!finished) return { kind: "running", words: `${what} is running.` };
  if (shown.ending.solved) return { kind: "solved", words: `Solved! ${what}: ${shown.words}.` };
  return { kind: "missed", words: `Not solved. ${what}: ${shown.words}.` };
}
