// "Can it be solved?": the worker tries the balls of a grid on the open puzzle, and says how many solve it and how that
// compares with the benchmark. The easiest ball stays hidden until it is asked for. It can be stopped, and ends when
// the puzzle is left. What is edited so that it may not be played is not searched.

import { text } from "../text/text.js";
import { Component } from "../widgets/component.js";
import { find, setText } from "../widgets/dom.js";
import { Search } from "../model/search.js";

/** @typedef {import("../pkg/pathlight.js").FoundSolutions} FoundSolutions */

export class SolvableCheck extends Component {
  #client;
  #editor;
  #button = this.byId("check-search", HTMLButtonElement);
  #search = new Search(() => this.#onEnd());
  /** @type {FoundSolutions | null} */
  #found = null;
  #revealed = false;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../model/shared-client.js").SharedClient} client
   * @param {import("./editor.js").Editor} editor
   */
  constructor(root, client, editor) {
    super(root);
    this.#client = client;
    this.#editor = editor;
    editor.addEventListener("edit", () => this.#onEdit());
    this.#button.addEventListener("click", () => (this.#search.running ? this.#search.stop() : void this.#start()));
    this.byId("check-reveal").addEventListener("click", () => this.#reveal());
    this.#button.disabled = true;
  }

  /** @param {import("../play/session.js").Session} session */
  open(session) {
    super.open(session);
    this.#update();
  }

  close() {
    super.close();
    this.#forget();
    // Until the next puzzle is there, a press would be lost.
    this.#button.disabled = true;
  }

  #forget() {
    this.#search.forget();
    this.#found = null;
    this.#revealed = false;
  }

  /** Whether the scene shows what may not be played, and not the open puzzle. */
  get #blocked() {
    return this.#editor.scene !== null && this.#editor.playable === null;
  }

  #onEdit() {
    if (!this.session || this.#blocked === this.#button.disabled) return;
    if (this.#blocked) this.#forget();
    this.#update();
  }

  async #start() {
    // What was edited a moment ago is searched, not the puzzle before.
    await this.#editor.settle();
    const { session } = this;
    if (!session) return;
    if (!this.#client.alive) this.requestModel();
    this.#found = null;
    this.#revealed = false;
    this.#search.start((signal) =>
      this.#client.call("search", [session.puzzle], signal, (found) => {
        this.#found = found;
        this.#update();
      }),
    );
    this.#update();
  }

  #onEnd() {
    this.#update();
    this.announce(this.byId("check-words").textContent ?? "");
  }

  #reveal() {
    const ball = this.#found?.easiest;
    if (!ball || !this.session) return;
    this.#revealed = true;
    this.session.placement.place(ball);
    this.#update();
    this.announce(this.byId("check-ball").textContent ?? "");
  }

  #update() {
    const found = this.#found;
    const { stop, search, blocked, easiest } = text.editor.check;
    setText(this.#button, this.#search.running ? stop : search);
    this.byId("check-progress").hidden = !this.#search.running;
    find(this.byId("check-progress"), "progress", HTMLProgressElement).value = found?.progress ?? 0;
    this.#button.disabled = this.#blocked;
    const trouble = this.#blocked ? blocked : this.#search.failure;
    setText(this.byId("check-words"), trouble ?? (found ? words(found) : ""));
    const ball = found?.easiest ?? null;
    this.byId("check-reveal").hidden = ball === null || this.#revealed;
    setText(this.byId("check-ball"), ball && this.#revealed ? easiest(...ball) : "");
  }
}

/**
 * What was found, in sentences.
 * @param {FoundSolutions} found
 */
function words({ progress, valid, solved, solves_itself: solvesItself, rank }) {
  const { check } = text.editor;
  const ended = progress === 1;
  const sentences = [];
  if (solvesItself) sentences.push(check.solvesItself);
  sentences.push(solved === 0 ? check.none(valid, ended) : check.found(solved, valid, ended));
  if (ended && solved > 0 && rank !== null) sentences.push(check.harder(rank));
  if (ended && solved === 0) sentences.push(check.between);
  return sentences.join(" ");
}
