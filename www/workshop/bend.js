// The panel Bend: the scene of the open puzzle as something to take apart. A Draft holds what the person makes of it; a
// draft that may be played becomes the puzzle of all panels whenever a gesture has ended, and its link the address.
// What the nets imagine and where the green object goes alone follow while something is dragged (live-scene.js), and no
// frame waits for them. Fires "bend" when what the scene shows may have changed.

import { paintDraft, palette } from "../pkg/pathlight.js";
import { Component } from "../widgets/component.js";
import { setText } from "../widgets/dom.js";
import { pathlight } from "../shell/page-api.js";
import { SCENE_SIZE } from "../shell/constants.js";
import { BendPen } from "./bend-pen.js";
import { BodyFields } from "./body-fields.js";
import { wordsOf } from "./body-words.js";
import { Draft } from "./draft.js";
import { drawDecoration } from "./knobs.js";
import { LiveScene } from "./live-scene.js";
import { textOfScene } from "./scene-link.js";

/** @typedef {import("../pkg/pathlight.js").OwnScene} OwnScene */
/** @typedef {import("../pkg/pathlight.js").SceneProblem} SceneProblem */

/** A draft that has not changed for so long, ms, becomes the puzzle; a drag that ends does so at once. */
const REST = 300;

export class Bend extends Component {
  pen = new BendPen(
    () => this.#draft,
    () => this.#leaveRun(),
    () => this.#commit(),
  );
  #client;
  #live;
  #fields;
  #visible = false;
  /** @type {Draft | null} */
  #draft = null;
  /** @type {SceneProblem[]} */
  #problems = [];
  /** @type {number | undefined} */
  #timer;
  #updateScheduled = false;
  /** The draft becomes the puzzle: it is closed and opened again. */
  #committing = false;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../model/shared-client.js").SharedClient} client
   */
  constructor(root, client) {
    super(root);
    this.#client = client;
    this.#live = new LiveScene(root, client);
    this.#live.addEventListener("live", () => this.dispatchEvent(new Event("bend")));
    this.#fields = new BodyFields(root);
    this.byId("bend-undo").addEventListener("click", () => this.undo());
    this.byId("bend-redo").addEventListener("click", () => this.redo());
    this.byId("bend-watch").addEventListener("click", () => this.session?.watch());
    this.byId("bend-snap", HTMLInputElement).addEventListener("change", () => this.#applySnap());
    for (const button of this.byId("bend").querySelectorAll("[data-adds]")) {
      const shape = /** @type {import("../pkg/pathlight.js").OwnBody["shape"]} */ (button.getAttribute("data-adds"));
      button.addEventListener("click", () => this.#draft?.add(shape, [SCENE_SIZE / 2, 0.7 * SCENE_SIZE]));
    }
  }

  /** @param {import("../play/session.js").Session} session */
  open(session) {
    super.open(session);
    if (this.#draft && JSON.stringify(this.#draft.scene) !== JSON.stringify(sceneOf(session))) this.#setDraft(null);
    this.listenTo(session, "draft", (event) => this.#onWanted(/** @type {CustomEvent} */ (event).detail));
    this.listen("change", () => this.dispatchEvent(new Event("bend")));
  }

  close() {
    super.close();
    clearTimeout(this.#timer);
    if (!this.#committing) this.#setDraft(null);
  }

  /** @param {import("../state/view.js").View} view */
  setState({ panel, hide }) {
    const left = this.#visible && panel !== "bend";
    this.#visible = panel === "bend";
    this.#live.imagines = !hide.includes("imagine");
    if (!this.session) return;
    this.#tellSession();
    if (left) this.#commit();
    if (this.#visible && !this.#draft) this.#begin(this.session);
  }

  /** @param {boolean} dark */
  setTheme(dark) {
    super.setTheme(dark);
    this.#live.setTheme(dark);
  }

  undo() {
    this.#draft?.undo();
  }

  redo() {
    this.#draft?.redo();
  }

  /** The scene as it is being bent, or null. */
  get scene() {
    return this.#draft?.scene ?? null;
  }

  /** The scene as it is being bent, if it may be played; else null. */
  get playable() {
    return this.#problems.length > 0 ? null : this.scene;
  }

  /** @param {string} name */
  rename(name) {
    this.#draft?.rename(name);
  }

  /** The maps to lay over the scene; none are imagined of what may not be played. */
  get maps() {
    return this.session?.placing && this.playable ? this.#live.canvases : [];
  }

  /**
   * Draws the draft; null while something runs, which the session draws.
   * @type {import("../play/canvas.js").Painter | null}
   */
  get painter() {
    const draft = this.#draft;
    if (!draft || !this.session?.placing) return null;
    return (context, view, maps) => {
      paintDraft(context, draft.scene, { ...view, knob: 0 }, maps);
      const { bodies } = draft.scene;
      const troubled = this.#problems
        .flatMap(({ body, other }) => [body, other])
        .flatMap((index) => (index === null ? [] : [bodies[index]]));
      drawDecoration(context, {
        selected: draft.body,
        troubled,
        path: this.playable && this.#live.path,
        colours: palette(this.dark),
      });
    };
  }

  /** Shows the draft in place of a run. */
  #leaveRun() {
    if (this.session && !this.session.placing) this.session.reset();
  }

  /**
   * Begins to bend the open puzzle.
   * @param {import("../play/session.js").Session} session
   */
  #begin(session) {
    // A lesson that shows nothing of the model has not started the worker, which simulates too.
    if (this.#client.status === "off") this.requestModel();
    this.#setDraft(new Draft(sceneOf(session), pathlight.sceneLimits()));
  }

  /** @param {Draft | null} draft */
  #setDraft(draft) {
    this.#draft = draft;
    this.#fields.setDraft(draft);
    this.#problems = [];
    this.#live.clear();
    draft?.addEventListener("change", () => {
      if (draft !== this.#draft) return;
      this.#leaveRun();
      this.#onChange(draft);
    });
    if (draft) {
      this.#applySnap();
      this.#onChange(draft);
    } else {
      this.dispatchEvent(new Event("bend"));
    }
  }

  #applySnap() {
    if (this.#draft) this.#draft.snap = this.byId("bend-snap", HTMLInputElement).checked;
  }

  /** @param {Draft} draft */
  #onChange(draft) {
    this.#problems = pathlight.sceneProblems(draft.scene);
    this.#live.follow(draft.scene, this.#problems.length === 0);
    this.#scheduleUpdate();
    this.dispatchEvent(new Event("bend"));
    clearTimeout(this.#timer);
    if (!this.pen.dragging) this.#timer = setTimeout(() => this.#commit(), REST);
    if (this.session?.refusal) this.session.refuse(null);
    this.#tellSession();
  }

  /** Tells the session whether the draft is seen in its place. What may not be played is seen on this panel alone. */
  #tellSession() {
    this.session?.edit({ draft: this.#problems.length > 0 ? this.#visible : !this.#isPuzzle });
  }

  /**
   * The person wants the draft to run.
   * @param {(session: import("../play/session.js").Session) => void} act
   */
  async #onWanted(act) {
    const session = await this.settle();
    if (session) act(session);
  }

  async #commit() {
    const draft = this.#draft;
    // Last: a puzzle that is opened announces its state.
    if (draft && (await this.#becomePuzzle()))
      this.announce(
        [wordsOf(draft.scene, draft.selected), ...this.#problems.map(({ sentence }) => sentence)].join(" "),
      );
  }

  /**
   * Makes the draft the puzzle of all panels, if it may be played and is another. Returns false if it has been bent
   * further or was left meanwhile.
   */
  async #becomePuzzle() {
    clearTimeout(this.#timer);
    const draft = this.#draft;
    if (!draft || !this.session) return false;
    const { scene } = draft;
    if (!this.#isPuzzle) {
      const text = await textOfScene(scene);
      // It may have been bent further meanwhile; another commit follows then.
      if (draft !== this.#draft || draft.scene !== scene || !this.session) return false;
      // Or it has been made the puzzle by another call.
      if (this.#isPuzzle) return true;
      this.#committing = true;
      this.requestState({ task: null, scene: text, proposal: null, challenge: null });
      this.#committing = false;
    }
    return true;
  }

  /** Is the draft the puzzle already, or may it not be? */
  get #isPuzzle() {
    const { session, scene } = this;
    return (
      !session || !scene || this.#problems.length > 0 || JSON.stringify(scene) === JSON.stringify(sceneOf(session))
    );
  }

  /**
   * Makes what is seen the puzzle, and returns its session; null if it may not be played, or was bent further or left
   * meanwhile.
   */
  async settle() {
    const [problem] = this.#problems;
    if (problem && this.#visible) this.session?.refuse(problem.sentence);
    else if (await this.#becomePuzzle()) return this.session;
    return null;
  }

  /** Updates the panel before the next frame, once however often the draft changes. */
  #scheduleUpdate() {
    if (this.#updateScheduled) return;
    this.#updateScheduled = true;
    requestAnimationFrame(() => {
      this.#updateScheduled = false;
      this.#update();
    });
  }

  #update() {
    const draft = this.#draft;
    if (!draft) return;
    this.byId("bend-undo", HTMLButtonElement).disabled = !draft.canUndo;
    this.byId("bend-redo", HTMLButtonElement).disabled = !draft.canRedo;
    for (const button of this.byId("bend").querySelectorAll("[data-adds]"))
      /** @type {HTMLButtonElement} */ (button).disabled = !draft.canAdd;
    const list = this.byId("bend-problems");
    list.hidden = this.#problems.length === 0;
    const sentences = this.#problems.map(({ sentence }) => sentence);
    if (Array.from(list.children, (item) => item.textContent).join() !== sentences.join())
      list.replaceChildren(...sentences.map(listItem));
    this.#fields.update();
  }
}

/**
 * The scene of an open puzzle in the form in which it is bent.
 * @param {import("../play/session.js").Session} session
 * @returns {OwnScene}
 */
function sceneOf({ played, about }) {
  return typeof played === "string" ? { ...pathlight.ownScene(played), name: `${about.name}, bent` } : played;
}

/** @param {string} text */
function listItem(text) {
  const item = document.createElement("li");
  setText(item, text);
  return item;
}
