// What can be done with the puzzle that has been made: name it, keep it in this browser, save it as a file.

import { text } from "../text/text.js";
import { Component } from "../widgets/component.js";
import { setText } from "../widgets/dom.js";
import { sceneName } from "../puzzles/puzzle-name.js";
import { customPuzzles } from "../storage/puzzle-store.js";
import { plainScene } from "./plain-scene.js";
import { savePuzzle } from "./puzzle-file.js";

export class SharePuzzle extends Component {
  #editor;
  #name = this.byId("make-name", HTMLInputElement);
  /**
   * The scene that the sentence is about.
   * @type {import("../pkg/pathlight.js").CustomScene | null}
   */
  #kept = null;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("./editor.js").Editor} editor
   * @param {boolean} keeps whether this browser may keep puzzles for the page
   */
  constructor(root, editor, keeps) {
    super(root);
    this.#editor = editor;
    this.byId("make-keep").hidden = !keeps;
    this.byId("make-keep").addEventListener("click", () => this.#keep());
    this.byId("make-save").addEventListener("click", () => editor.playable && savePuzzle(editor.playable));
    this.#name.addEventListener("change", () => editor.rename(this.#name.value));
    this.byId("make-share").addEventListener("submit", (event) => event.preventDefault());
    editor.addEventListener("edit", () => this.#update());
  }

  #keep() {
    const scene = this.#editor.playable;
    if (!scene) return;
    const { failure } = customPuzzles().add([plainScene(scene)]);
    this.#kept = scene;
    this.#say(failure ?? text.editor.kept(sceneName(scene)));
  }

  /** @param {string} words */
  #say(words) {
    setText(this.byId("make-said"), words);
    this.announce(words);
  }

  #update() {
    const scene = this.#editor.playable;
    for (const id of ["make-keep", "make-save"]) this.byId(id, HTMLButtonElement).disabled = scene === null;
    if (this.#editor.scene !== this.#kept) setText(this.byId("make-said"), "");
    const name = this.#editor.scene?.name ?? "";
    if (this.#name.value !== name && !this.#name.matches(":focus")) this.#name.value = name;
  }
}
