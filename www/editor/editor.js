// The panel Make: the scene of the open puzzle as something to take apart. An EditedScene holds what the person makes
// of it; one that may be played becomes the puzzle of all panels whenever a gesture has ended, and its link the
// address. What the nets imagine and where the green object goes without a ball follow while something is dragged
// (live-scene.js), and no frame waits for them. Fires "edit" when what the scene shows may have changed.

import { paintEditedScene, palette } from "../pkg/pathlight.js";
import { Component } from "../widgets/component.js";
import { pathlight } from "../shell/page-api.js";
import { SCENE_SIZE } from "../shell/constants.js";
import { EditorPen } from "./editor-pen.js";
import { BodyFields } from "./body-fields.js";
import { wordsOf } from "./body-words.js";
import { sentencesOf } from "./problem-words.js";
import { EditedScene } from "./edited-scene.js";
import { drawDecoration } from "./knobs.js";
import { LiveScene } from "./live-scene.js";
import { sceneOf } from "./plain-scene.js";
import { textOfScene } from "./scene-link.js";

/** @typedef {import("../pkg/pathlight.js").CustomScene} CustomScene */
/** @typedef {import("../pkg/pathlight.js").SceneProblem} SceneProblem */

/** Time without a change after which the scene becomes the puzzle, ms; at the end of a drag it does so at once. */
const REST = 300;

export class Editor extends Component {
  #pen = new EditorPen(
    () => this.#edited,
    () => this.#leaveRun(),
    () => this.#commit(),
  );
  #client;
  #live;
  #fields;
  #visible = false;
  /** @type {EditedScene | null} */
  #edited = null;
  /** @type {SceneProblem[]} */
  #problems = [];
  /** @type {number | undefined} */
  #timer;
  #updateScheduled = false;
  /** The edited scene becomes the puzzle: it is closed and opened again. */
  #committing = false;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../model/shared-client.js").SharedClient} client
   */
  constructor(root, client) {
    super(root);
    this.#client = client;
    this.#live = new LiveScene(root, client);
    this.#live.addEventListener("live", () => this.#tellEdit());
    this.#fields = new BodyFields(root);
    this.byId("make-undo").addEventListener("click", () => this.undo());
    this.byId("make-redo").addEventListener("click", () => this.redo());
    this.byId("make-watch").addEventListener("click", () => this.session?.watch());
    this.byId("make-snap", HTMLInputElement).addEventListener("change", () => this.#applySnap());
    for (const button of this.byId("make").querySelectorAll("[data-adds]")) {
      const shape = /** @type {import("../pkg/pathlight.js").CustomBody["shape"]} */ (button.getAttribute("data-adds"));
      button.addEventListener("click", () => this.#edited?.add(shape, [SCENE_SIZE / 2, 0.7 * SCENE_SIZE]));
    }
  }

  /** @param {import("../play/session.js").Session} session */
  open(session) {
    super.open(session);
    if (this.#edited && JSON.stringify(this.#edited.scene) !== JSON.stringify(sceneOf(session))) this.#setEdited(null);
    this.listenTo(session, "wanted", (event) => this.#onWanted(/** @type {CustomEvent} */ (event).detail));
    this.listen("change", () => this.#tellEdit());
  }

  close() {
    super.close();
    clearTimeout(this.#timer);
    if (!this.#committing) this.#setEdited(null);
  }

  /** @param {import("../state/view.js").View} view */
  setState({ panel, hide }) {
    const [before, now] = [this.#visible, panel === "make"];
    this.#visible = now;
    this.#live.imagines = !hide.includes("imagine");
    if (!this.session) return;
    // A run that has ended would lie over what is edited.
    if (now && !before && this.session.finished) this.#leaveRun();
    this.#tellSession();
    if (before && !now) this.#commit();
    if (this.#visible && !this.#edited) this.#begin(this.session);
  }

  /** @param {boolean} dark */
  setTheme(dark) {
    super.setTheme(dark);
    this.#live.setTheme(dark);
  }

  undo() {
    this.#edited?.undo();
  }

  redo() {
    this.#edited?.redo();
  }

  /** The scene as it is being edited, or null. */
  get scene() {
    return this.#edited?.scene ?? null;
  }

  /** The scene as it is being edited, if it may be played; else null. */
  get playable() {
    return this.#problems.length > 0 ? null : this.scene;
  }

  #tellEdit() {
    this.dispatchEvent(new Event("edit"));
    this.changeOverlay();
  }

  /** @param {string} name */
  rename(name) {
    this.#edited?.rename(name);
  }

  get overlay() {
    if (!this.#visible) return null;
    // None are imagined of what may not be played.
    const maps = this.session?.placing && this.playable ? this.#live.canvases : [];
    return { maps, painter: this.#painter, pen: this.#pen };
  }

  /**
   * Draws the edited scene; null while something runs, which the session draws.
   * @type {import("../play/canvas.js").Painter | null}
   */
  get #painter() {
    const edited = this.#edited;
    if (!edited || !this.session?.placing) return null;
    return (context, view, maps) => {
      paintEditedScene(context, edited.scene, { ...view, knob: 0 }, maps);
      const { bodies } = edited.scene;
      const troubled = this.#problems
        .flatMap(({ body, other }) => [body, other])
        .flatMap((index) => (index === null ? [] : [bodies[index]]));
      drawDecoration(context, {
        selected: edited.body,
        troubled,
        path: this.playable && this.#live.path,
        colours: palette(this.dark),
      });
    };
  }

  /** Shows the edited scene in place of a run. */
  #leaveRun() {
    if (this.session && !this.session.placing) this.session.reset();
  }

  /**
   * Begins to edit the open puzzle.
   * @param {import("../play/session.js").Session} session
   */
  #begin(session) {
    // A lesson that shows nothing of the model has not started the worker, which simulates too.
    if (this.#client.status === "off") this.requestModel();
    this.#setEdited(new EditedScene(sceneOf(session), pathlight.sceneLimits()));
  }

  /** @param {EditedScene | null} edited */
  #setEdited(edited) {
    this.#edited = edited;
    this.#fields.setEdited(edited);
    this.#problems = [];
    this.#live.clear();
    edited?.addEventListener("change", () => {
      if (edited !== this.#edited) return;
      this.#leaveRun();
      this.#onChange(edited);
    });
    if (edited) {
      this.#applySnap();
      this.#onChange(edited);
    } else {
      this.#tellEdit();
    }
  }

  #applySnap() {
    if (this.#edited) this.#edited.snap = this.byId("make-snap", HTMLInputElement).checked;
  }

  /** @param {EditedScene} edited */
  #onChange(edited) {
    this.#problems = pathlight.sceneProblems(edited.scene);
    this.#live.follow(edited.scene, this.#problems.length === 0);
    this.#scheduleUpdate();
    this.#tellEdit();
    clearTimeout(this.#timer);
    if (!this.#pen.dragging) this.#timer = setTimeout(() => this.#commit(), REST);
    if (this.session?.refusal) this.session.refuse(null);
    this.#tellSession();
  }

  /**
   * Tells the session whether the edited scene is seen in its place. What may not be played is seen on this panel
   * alone.
   */
  #tellSession() {
    this.session?.edit({ edited: this.#problems.length > 0 ? this.#visible : !this.#isPuzzle });
  }

  /**
   * The person wants the edited scene to run.
   * @param {(session: import("../play/session.js").Session) => void} act
   */
  async #onWanted(act) {
    const session = await this.settle();
    if (session) act(session);
  }

  async #commit() {
    const edited = this.#edited;
    // Last: a puzzle that is opened announces its state.
    if (edited && (await this.#becomePuzzle()))
      this.announce([wordsOf(edited.scene, edited.selected), ...sentencesOf(this.#problems, edited.scene)].join(" "));
  }

  /**
   * Makes the edited scene the puzzle of all panels, if it may be played and is another. Returns false if it has been
   * edited further or was left meanwhile.
   */
  async #becomePuzzle() {
    clearTimeout(this.#timer);
    const edited = this.#edited;
    if (!edited || !this.session) return false;
    const { scene } = edited;
    if (!this.#isPuzzle) {
      const text = await textOfScene(scene);
      // It may have been edited further meanwhile; another commit follows then.
      if (edited !== this.#edited || edited.scene !== scene || !this.session) return false;
      // Or it has been made the puzzle by another call.
      if (this.#isPuzzle) return true;
      this.#committing = true;
      this.requestState({ task: null, scene: text, proposal: null, challenge: null });
      this.#committing = false;
    }
    return true;
  }

  /** Is the edited scene the puzzle already, or may it not be? */
  get #isPuzzle() {
    const { session, scene } = this;
    return (
      !session || !scene || this.#problems.length > 0 || JSON.stringify(scene) === JSON.stringify(sceneOf(session))
    );
  }

  /** Is a scene in sight that may not be played? */
  get blocked() {
    return this.#visible && this.#problems.length > 0;
  }

  /**
   * Makes what is seen the puzzle, and returns its session; null if it may not be played, or was edited further or
   * left meanwhile.
   */
  async settle() {
    if (this.blocked && this.#edited) this.session?.refuse(sentencesOf(this.#problems, this.#edited.scene)[0]);
    else if (await this.#becomePuzzle()) return this.session;
    return null;
  }

  /** Updates the panel before the next frame, once however often the scene changes. */
  #scheduleUpdate() {
    if (this.#updateScheduled) return;
    this.#updateScheduled = true;
    requestAnimationFrame(() => {
      this.#updateScheduled = false;
      this.#update();
    });
  }

  #update() {
    const edited = this.#edited;
    if (!edited) return;
    this.byId("make-undo", HTMLButtonElement).disabled = !edited.canUndo;
    this.byId("make-redo", HTMLButtonElement).disabled = !edited.canRedo;
    for (const button of this.byId("make").querySelectorAll("[data-adds]"))
      /** @type {HTMLButtonElement} */ (button).disabled = !edited.canAdd;
    const list = this.byId("make-problems");
    list.hidden = this.#problems.length === 0;
    const sentences = sentencesOf(this.#problems, edited.scene);
    const items = sentences.map((textContent) => Object.assign(document.createElement("li"), { textContent }));
    if (list.textContent !== sentences.join("")) list.replaceChildren(...items);
    this.#fields.update();
  }
}
