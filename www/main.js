// The page: starts the wasm, follows the address, and joins its parts. Each part knows the session and the
// wasm; only this file knows the parts.

import { About } from "./shell/about.js";
import { Attempts } from "./play/attempts.js";
import { SceneCanvas } from "./play/canvas.js";
import { Compare } from "./panels/compare.js";
import { Controls } from "./play/controls.js";
import { engine } from "./shell/load-wasm.js";
import { Gallery } from "./shell/gallery.js";
import { Imagine } from "./panels/imagine.js";
import { listen } from "./shell/shortcuts.js";
import { Model } from "./model/worker-client.js";
import { notice, quiet } from "./shell/notice.js";
import { Progress } from "./shell/progress-store.js";
import { Record } from "./shell/progress-view.js";
import { Session } from "./play/session.js";
import { PANELS, START, read, write } from "./shell/url-state.js";
import { Thinking } from "./panels/panels.js";

const at = (id) => document.getElementById(id);
const darkness = matchMedia("(prefers-color-scheme: dark)");
const stillness = matchMedia("(prefers-reduced-motion: reduce)");

class Page {
  #wasm;
  #templates;
  #state = { ...START };
  #session = null;
  #model;
  #gallery;
  #canvas = new SceneCanvas(at("scene"));
  #controls = new Controls();
  #imagine;
  #thinking;
  #compare;
  #lists;
  #progress = new Progress();
  #record;
  #writing = null;

  constructor(wasm, module) {
    this.#wasm = wasm;
    this.#templates = wasm.templates();
    this.#model = new Model(module);
    this.#gallery = new Gallery(at("templates"), wasm, this.#templates);
    this.#record = new Record(this.#progress, this.#templates, this.#gallery);
    this.#imagine = new Imagine(wasm, this.#model);
    this.#thinking = new Thinking(wasm, this.#model, this.#imagine, this.#canvas, this.#progress);
    this.#compare = new Compare(this.#model);
    new About(this.#model);
    this.#lists = [
      new Attempts(at("play-attempts"), at("play-count"), "player"),
      new Attempts(at("you-attempts"), at("you-count"), "player"),
      new Attempts(at("it-attempts"), at("it-count"), "model"),
    ];
    this.#listen();
    this.#dress();
    this.#follow();
  }

  #listen() {
    addEventListener("popstate", () => this.#follow());
    darkness.addEventListener("change", () => this.#dress());
    at("previous").addEventListener("click", () => this.#turn(-1));
    at("next").addEventListener("click", () => this.#turn(1));
    at("random").addEventListener("click", () => this.#random());
    at("task").addEventListener("change", () => this.#go({ task: at("task").value }));
    at("skip").addEventListener("click", (event) => {
      // Not the address's own jump: what stands after # is the state.
      event.preventDefault();
      at("scene").focus();
    });
    at("copy").addEventListener("click", () => this.#copy());
    for (const button of document.querySelectorAll("[data-opens]")) {
      button.addEventListener("click", () => at(button.dataset.opens).showModal());
    }
    for (const tab of document.querySelectorAll("[role=tab]")) {
      tab.addEventListener("click", () => this.#set({ panel: tab.dataset.panel }));
      tab.addEventListener("keydown", (event) => this.#roam(event));
    }
    this.#imagine.addEventListener("layers", ({ detail }) => this.#set(detail));
    this.#imagine.addEventListener("opacity", ({ detail }) => this.#set(detail));
    this.#imagine.addEventListener("model", ({ detail }) => {
      this.#set(detail);
      this.#model.start(detail.model);
    });
    this.#thinking.addEventListener("set", ({ detail }) => this.#set(detail));
    for (const part of [this.#imagine, this.#compare]) {
      part.addEventListener("again", () => this.#again());
    }
    const page = this;
    listen({
      get session() {
        return page.#session;
      },
      scene: this.#canvas,
      turn: (by) => this.#turn(by),
      panel: (index) => this.#panels[index] && this.#set({ panel: this.#panels[index] }),
      help: () => at("keys").showModal(),
    });
  }

  /** Takes light or dark, which the wasm draws in and the style sheet follows. */
  #dress() {
    const dark = darkness.matches;
    for (const [name, colour] of Object.entries(this.#wasm.palette(dark))) {
      document.documentElement.style.setProperty(`--${name}`, colour);
    }
    for (const part of [this.#gallery, this.#canvas, this.#imagine, this.#thinking, ...this.#lists]) part.dark = dark;
    this.#canvas.draw();
  }

  /** Shows what the address asks for. */
  #follow() {
    quiet();
    const { state, problem } = read(location.hash);
    if (problem) notice(problem, [["All puzzles", "#"]]);
    const known = state.task === null || this.#template(state.task)?.tasks.includes(state.task);
    if (!known) {
      const template = this.#template(state.task);
      const ways = [["All puzzles", "#"]];
      if (template) ways.unshift([`The first puzzle of ${template.name}`, `#task=${template.tasks[0]}`]);
      notice(`This link asks for puzzle ${state.task}, which does not exist.`, ways);
      state.task = null;
    }
    this.#open(state);
  }

  #open(state) {
    const { task, model } = this.#state;
    const came = at("gallery").contains(document.activeElement);
    this.#state = state;
    this.#hide();
    at("gallery").hidden = state.task !== null;
    for (const id of ["puzzle", "title", "copy", "skip"]) at(id).hidden = state.task === null;
    if (state.task === null) {
      this.#shut();
      document.title = "Pathlight";
      return;
    }
    if (!this.#session || state.task !== task) this.#enter(state.task);
    if (state.ball && String(state.ball) !== String(this.#session.ball)) this.#session.place(state.ball);
    if (this.#model.status === "off" || state.model !== model) this.#model.start(state.model);
    this.#show();
    if (came) at("scene").focus({ preventScroll: true });
  }

  /** Takes away what the link hides; the ways to other puzzles go on hiding it. */
  #hide() {
    const { hide, model } = this.#state;
    for (const part of document.querySelectorAll("[data-part]")) part.classList.toggle("away", hide.includes(part.dataset.part));
    const address = (task) => `#${write({ ...START, task, model, hide })}`;
    this.#gallery.link(address);
    if (hide.includes("puzzles")) at("home").removeAttribute("href");
    else at("home").href = address(null);
  }

  /** The panels that are not hidden; Play always is there. */
  get #panels() {
    return PANELS.filter((name) => !this.#state.hide.includes(name));
  }

  #enter(task) {
    this.#shut();
    const session = new Session(new this.#wasm.Puzzle(task), () => stillness.matches);
    this.#session = session;
    const { name } = session.about;
    at("name").textContent = name;
    document.title = `${name} ${task} – Pathlight`;
    const { tasks } = this.#template(task);
    at("task").replaceChildren(...tasks.map((id) => new Option(this.#record.label(id), id, id === task, id === task)));
    at("task").title = `Puzzle ${tasks.indexOf(task) + 1} of ${tasks.length}`;
    session.addEventListener("change", () => this.#note());
    session.addEventListener("attempt", ({ detail }) => this.#progress.note(task, detail.solved));
    for (const part of [this.#canvas, this.#controls, this.#imagine, this.#compare, ...this.#lists]) part.show(session);
    this.#thinking.show(session);
  }

  #shut() {
    this.#canvas.show(null);
    this.#compare.leave();
    this.#thinking.leave();
    this.#session?.close();
    this.#session = null;
  }

  #template(task) {
    return this.#templates.find(({ id }) => task.startsWith(id));
  }

  /** Goes somewhere that the back button leaves again. */
  #go(patch) {
    const state = { ...this.#state, ball: null, ...patch };
    history.pushState(null, "", `#${write(state)}`);
    quiet();
    this.#open(state);
  }

  /** Changes what is shown of the same puzzle. */
  #set(patch) {
    const { panel } = this.#state;
    Object.assign(this.#state, patch);
    this.#show();
    if (this.#state.panel === "compare" && panel !== "compare" && !this.#state.proposal) this.#compare.open();
    this.#write();
  }

  /** Takes the ball into the link. */
  #note() {
    this.#state.ball = this.#session.ball;
    this.#write();
  }

  /** Writes the address a little later: browsers do not take it at every step of a drag. */
  #write() {
    clearTimeout(this.#writing);
    this.#writing = setTimeout(() => {
      if (this.#state.task) history.replaceState(null, "", `#${write(this.#state)}`);
    }, 200);
  }

  /** Starts the model once more; one that is not there gives way to the first that is. */
  #again() {
    if (this.#model.code === "no_model") this.#set({ model: null });
    this.#model.start(this.#state.model);
  }

  #show() {
    const panel = this.#panels.includes(this.#state.panel) ? this.#state.panel : this.#panels[0];
    for (const name of PANELS) {
      const tab = at(`tab-${name}`);
      tab.setAttribute("aria-selected", String(name === panel));
      tab.tabIndex = name === panel ? 0 : -1;
      at(name).hidden = name !== panel;
    }
    this.#imagine.set(this.#state);
    this.#thinking.set(this.#state);
  }

  #turn(by) {
    if (this.#state.hide.includes("puzzles")) return;
    const { tasks } = this.#template(this.#state.task);
    const index = (tasks.indexOf(this.#state.task) + by + tasks.length) % tasks.length;
    this.#go({ task: tasks[index] });
  }

  #random() {
    const any = (list) => list[Math.floor(Math.random() * list.length)];
    this.#go({ task: any(any(this.#templates).tasks) });
  }

  async #copy() {
    history.replaceState(null, "", `#${write(this.#state)}`);
    try {
      await navigator.clipboard.writeText(location.href);
      notice("The link to what you see is copied.");
    } catch {
      notice(`This browser does not let the page copy. The link is ${location.href}`);
    }
  }

  /** Arrow keys on the tabs. */
  #roam(event) {
    const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!by) return;
    const panels = this.#panels;
    const panel = panels[(panels.indexOf(this.#state.panel) + by + panels.length) % panels.length];
    this.#set({ panel });
    at(`tab-${panel}`).focus();
    event.preventDefault();
  }
}

addEventListener("error", ({ message }) => notice(`Something in Pathlight broke: ${message}. Load the page again to go on.`));
addEventListener("unhandledrejection", ({ reason }) => notice(`Something in Pathlight broke: ${reason?.message ?? reason}. Load the page again to go on.`));

try {
  const { wasm, module } = await engine;
  new Page(wasm, module);
} catch (error) {
  notice(error.message, [["Try again", location.pathname]]);
}
