// The components of a puzzle, which all get the same calls of widgets/component.js's lifecycle, in the order in which
// they are made. The scene, the transport and the panel Play are there from the first picture on; panel-components.js
// has the rest, which may come later: what the others have been told before is told then.

import { palette } from "../pkg/pathlight.js";
import { afterFrame } from "../loading/after-frame.js";
import { pauseIfLong } from "../loading/next-task.js";
import { AfterSolving } from "../play/after-solving.js";
import { AttemptList } from "../play/attempt-list.js";
import { SceneCanvas } from "../play/canvas.js";
import { Controls } from "../play/controls.js";
import { Guide } from "../play/guide.js";
import { KeptAttempts } from "../play/kept-attempts.js";
import { byId, find } from "../widgets/dom.js";
import { Tabs } from "../widgets/tabs.js";

/** @typedef {import("../widgets/component.js").Component} Component */
/** @typedef {import("../play/session.js").Session} Session */
/** @typedef {import("../state/view.js").View} View */

/**
 * What components are made of.
 * @typedef {object} Parts
 * @property {ShadowRoot} root
 * @property {WebAssembly.Module} module
 * @property {import("../model/shared-client.js").SharedClient} client
 * @property {import("../storage/progress.js").Progress} progress
 * @property {import("../storage/preferences.js").Preferences} preferences
 * @property {import("../model/model-memory.js").ModelMemory} memory
 * @property {(task: string, panel: import("../state/url-state.js").Panel) => string | null} hrefOf the address of
 *   another puzzle, or null
 */

export class Components {
  canvas;
  guide;
  afterSolving;
  /**
   * Those of the other panels that the controller itself asks for something; null until they are made.
   * @type {Omit<Awaited<ReturnType<typeof import("./panel-components.js").createPanelComponents>>, "all"> | null}
   */
  panels = null;
  /** Are those of the panels on their way, or there? */
  #panelsAwaited = false;
  #parts;
  #listen;
  /** @type {Component[]} */
  #all = [];
  /** @type {Session | null} */
  #session = null;
  /** @type {boolean | null} */
  #dark = null;

  /**
   * @param {Parts} parts
   * @param {(component: Component) => void} listen is called once for each component
   */
  constructor(parts, listen) {
    const { root, client, progress, memory, hrefOf } = (this.#parts = parts);
    this.#listen = listen;
    this.canvas = new SceneCanvas(root);
    this.guide = new Guide(root);
    this.afterSolving = new AfterSolving(root, progress, (task) => hrefOf(task, "play"));
    this.#add([
      new Tabs(root),
      this.canvas,
      new Controls(root),
      new KeptAttempts(root, client, progress, memory),
      this.guide,
      this.afterSolving,
      new AttemptList(root, byId(root, "play-attempts"), byId(root, "play-count"), "player"),
    ]);
  }

  /**
   * Makes the others, unless they are there or on their way. Returns whether it has made them; then `setState` has to
   * follow. Rejects if their modules cannot be loaded.
   * @param {boolean} later once the scene is drawn
   */
  async addPanels(later) {
    if (this.#panelsAwaited) return false;
    this.#panelsAwaited = true;
    if (later) await afterFrame();
    const { all, ...panels } = await this.#createPanels().catch((error) => {
      this.#panelsAwaited = false;
      throw error;
    });
    for (const component of all) {
      await pauseIfLong();
      this.#add([component]);
    }
    await pauseIfLong();
    this.panels = panels;
    for (const element of this.#parts.root.querySelectorAll("[inert]")) element.removeAttribute("inert");
    return true;
  }

  async #createPanels() {
    const { createPanelComponents } = await import("./panel-components.js");
    return createPanelComponents(this.#parts, this.canvas);
  }

  /** @param {Component[]} components */
  #add(components) {
    for (const component of components) {
      this.#listen(component);
      if (this.#dark !== null) component.setTheme(this.#dark);
      if (this.#session) component.open(this.#session);
    }
    this.#all.push(...components);
  }

  /**
   * Applies the colour scheme to what the wasm paints, and its colours to the style sheet.
   * @param {boolean} dark
   */
  setTheme(dark) {
    if (dark === this.#dark) return;
    this.#dark = dark;
    const { style } = find(this.#parts.root, ".puzzle");
    for (const [name, colour] of Object.entries(palette(dark))) style.setProperty(`--${name}`, colour);
    for (const component of this.#all) component.setTheme(dark);
  }

  /** @param {Session} session */
  open(session) {
    this.#session = session;
    for (const component of this.#all) component.open(session);
  }

  /** @param {View} view */
  setState(view) {
    for (const component of this.#all) component.setState(view);
  }

  /** In reverse order: a component is closed before those that it reads from. */
  close() {
    this.#session = null;
    for (const component of this.#all.toReversed()) component.close();
  }
}
