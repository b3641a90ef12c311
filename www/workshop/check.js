// "Can it be solved?": the worker tries the balls of a grid on the open puzzle, and says how many solve it and how that
// compares with the benchmark. The easiest ball stays hidden until it is asked for. It can be stopped, and ends when
// the puzzle is left. What is bent so that it may not be played is not searched.

import { Component } from "../widgets/component.js";
import { find, setText } from "../widgets/dom.js";
import { Search } from "../model/search.js";

/** @typedef {import("../pkg/pathlight.js").FoundSolutions} FoundSolutions */

export class Check extends Component {
  #client;
  #bend;
  #button = this.byId("check-search", HTMLButtonElement);
  #search = new Search(() => this.#onEnd());
  /** @type {FoundSolutions | null} */
  #found = null;
  #revealed = false;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../model/shared-client.js").SharedClient} client
   * @param {import("./bend.js").Bend} bend
   */
  constructor(root, client, bend) {
    super(root);
    this.#client = client;
    this.#bend = bend;
    bend.addEventListener("bend", () => this.#onBend());
    this.#button.addEventListener("click", () => (this.#search.running ? this.#search.stop() : void this.#start()));
    this.byId("check-reveal").addEventListener("click", () => this.#reveal());
  }

  /** @param {import("../play/session.js").Session} session */
  open(session) {
    super.open(session);
    this.#update();
  }

  close() {
    super.close();
    this.#forget();
  }

  #forget() {
    this.#search.forget();
    this.#found = null;
    this.#revealed = false;
  }

  /** Whether the scene shows what may not be played, and not the open puzzle. */
  get #blocked() {
    return this.#bend.scene !== null && this.#bend.playable === null;
  }

  #onBend() {
    if (this.#blocked === this.#button.disabled) return;
    if (this.#blocked) this.#forget();
    this.#update();
  }

  async #start() {
    // What was bent a moment ago is searched, not the puzzle before.
    await this.#bend.settle();
    const { session } = this;
    if (!session) return;
    if (!this.#client.alive) this.requestModel();
    this.#found = null;
    this.#revealed = false;
    this.#search.start((signal) =>
      this.#client.call("search", [session.played], signal, (found) => {
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
    setText(this.#button, this.#search.running ? "Stop" : "Search for solutions");
    this.byId("check-progress").hidden = !this.#search.running;
    find(this.byId("check-progress"), "progress", HTMLProgressElement).value = found?.progress ?? 0;
    this.#button.disabled = this.#blocked;
    const blocked = this.#blocked ? "First mend what stands above: then it can be searched." : null;
    setText(this.byId("check-words"), blocked ?? this.#search.failure ?? (found ? words(found) : ""));
    const ball = found?.easiest ?? null;
    this.byId("check-reveal").hidden = ball === null || this.#revealed;
    setText(
      this.byId("check-ball"),
      ball && this.#revealed
        ? `The easiest ball is at x ${ball[0]}, y ${ball[1]} with radius ${ball[2]}: it lies in the scene now. Press Run.`
        : "",
    );
  }
}

/**
 * What was found, in sentences.
 * @param {FoundSolutions} found
 */
function words({ progress, valid, solved, solves_itself: solvesItself, rank }) {
  const sentences = [];
  if (solvesItself) sentences.push("The scene solves itself, without any ball.");
  const tried = `${valid.toLocaleString("en")} balls${progress < 1 ? " so far" : ""}`;
  sentences.push(
    solved === 0
      ? `None found in ${tried}.`
      : `It can be solved: ${solved.toLocaleString("en")} of ${tried} solve it, ${share(solved / valid)}.`,
  );
  if (progress === 1 && solved > 0 && rank !== null)
    sentences.push(`Of the benchmark’s puzzles ${Math.round(100 * rank)} % are harder.`);
  if (progress === 1 && solved === 0) sentences.push("A ball between those of the grid may still solve it.");
  return sentences.join(" ");
}

/** @param {number} fraction */
function share(fraction) {
  return fraction < 0.001 ? "less than one in a thousand" : `${(100 * fraction).toFixed(fraction < 0.01 ? 1 : 0)} %`;
}
