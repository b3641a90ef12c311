// What can be done with the puzzle that has been made: name it, keep it in this browser, save it as a file.

import { Component } from "../widgets/component.js";
import { setText } from "../widgets/dom.js";
import { sceneName } from "../puzzles/puzzle-name.js";
import { ownPuzzles } from "../storage/puzzle-store.js";
import { plainScene } from "./plain-scene.js";
import { savePuzzle } from "./puzzle-file.js";

export class ShareOwn extends Component {
  #bend;
  #name = this.byId("bend-name", HTMLInputElement);
  /**
   * The scene that the sentence is about.
   * @type {import("../pkg/pathlight.js").OwnScene | null}
   */
  #kept = null;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("./bend.js").Bend} bend
   * @param {boolean} keeps whether this browser may keep puzzles for the page
   */
  constructor(root, bend, keeps) {
    super(root);
    this.#bend = bend;
    this.byId("bend-keep").hidden = !keeps;
    this.byId("bend-keep").addEventListener("click", () => this.#keep());
    this.byId("bend-save").addEventListener("click", () => bend.playable && savePuzzle(bend.playable));
    this.#name.addEventListener("change", () => bend.rename(this.#name.value));
    this.byId("bend-share").addEventListener("submit", (event) => event.preventDefault());
    bend.addEventListener("bend", () => this.#update());
  }

  #keep() {
    const scene = this.#bend.playable;
    if (!scene) return;
    const { failure } = ownPuzzles().add([plainScene(scene)]);
    this.#kept = scene;
    this.#say(
      failure ?? `“${sceneName(scene)}” is kept in this browser: it is in the grid, after the benchmark’s puzzles.`,
    );
  }

  /** @param {string} words */
  #say(words) {
    setText(this.byId("bend-said"), words);
    this.announce(words);
  }

  #update() {
    const scene = this.#bend.playable;
    for (const id of ["bend-keep", "bend-save"]) this.byId(id, HTMLButtonElement).disabled = scene === null;
    if (this.#bend.scene !== this.#kept) setText(this.byId("bend-said"), "");
    const name = this.#bend.scene?.name ?? "";
    if (this.#name.value !== name && !this.#name.matches(":focus")) this.#name.value = name;
  }
}
