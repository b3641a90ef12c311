// Saves what the scene shows: as a picture, or a run as a film, for which the run is drawn once more. Everything
// happens in this browser.

import { Component } from "../widgets/component.js";
import { STEPS_PER_SECOND } from "../shell/constants.js";
import { contextOf, setText } from "../widgets/dom.js";
import { download, fileName } from "../widgets/download.js";
import { paintStill } from "../play/still.js";
import { filmFormat, recorded } from "./film.js";

/** Width and height of a picture, pixels, and of a film. */
const PICTURE_SIDE = 1024;
const FILM_SIDE = 512;
/** How long the last frame stays, s. */
const LAST_FRAME = 0.7;

export class Pictures extends Component {
  #filmButton = this.byId("save-film", HTMLButtonElement);
  /**
   * The film that is being recorded.
   * @type {AbortController | null}
   */
  #recording = null;

  /** @param {import("../widgets/dom.js").Root} root */
  constructor(root) {
    super(root);
    this.byId("save-picture").addEventListener("click", () => this.#savePicture());
    this.#filmButton.addEventListener("click", () => (this.#recording ? this.#recording.abort() : this.#saveFilm()));
  }

  /** @param {import("../play/session.js").Session} session */
  open(session) {
    super.open(session);
    this.listen("change", () => this.#update());
    this.#update();
  }

  close() {
    super.close();
    this.#recording?.abort();
    this.#recording = null;
    setText(this.byId("save-words"), "");
  }

  #savePicture() {
    const { session } = this;
    if (!session) return;
    const context = newContext(PICTURE_SIDE);
    paintStill(session, context, session.playback.step, this.dark);
    context.canvas.toBlob((blob) => {
      if (blob) download(fileName(titleOf(session), "png"), blob);
      else this.#say("This browser could not make the picture.");
    }, "image/png");
  }

  async #saveFilm() {
    const { session } = this;
    if (!session || session.placing) return;
    const format = filmFormat();
    if (!format) {
      this.#say("This browser cannot record films. A picture can be saved.");
      return;
    }
    const recording = (this.#recording = new AbortController());
    this.#update();
    const steps = session.puzzle.steps();
    const context = newContext(FILM_SIDE);
    // The recordings of the session may be replaced meanwhile: then the film is given up.
    const { phase, shown } = session;
    const showsTheSame = () => session === this.session && session.phase === phase && session.shown === shown;
    let words = "The film was given up.";
    try {
      const blob = await recorded(context.canvas, format.type, recording.signal, (seconds) => {
        const step = Math.min(seconds * STEPS_PER_SECOND, steps);
        if (!showsTheSame()) recording.abort();
        else paintStill(session, context, step, this.dark);
        setText(
          this.byId("save-words"),
          `Recording: ${Math.min(seconds, steps / STEPS_PER_SECOND).toFixed(0)} of ${(steps / STEPS_PER_SECOND).toFixed(0)} s.`,
        );
        return seconds < steps / STEPS_PER_SECOND + LAST_FRAME;
      });
      if (blob) {
        download(fileName(titleOf(session), format.extension), blob);
        words = "The film is saved.";
      }
    } catch {
      words = "This browser could not record the film. A picture can be saved.";
    }
    // The puzzle may have been left meanwhile.
    if (this.#recording !== recording) return;
    this.#recording = null;
    this.#say(words);
    this.#update();
  }

  /** @param {string} words */
  #say(words) {
    setText(this.byId("save-words"), words);
    this.announce(words);
  }

  #update() {
    if (!this.session) return;
    this.#filmButton.disabled = this.session.placing && !this.#recording;
    this.#filmButton.title = this.session.placing ? "Run a ball first" : "";
    setText(this.#filmButton, this.#recording ? "Stop recording" : "Save the run as a film");
  }
}

/** @param {number} side */
function newContext(side) {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = side;
  return contextOf(canvas);
}

/** @param {import("../play/session.js").Session} session */
function titleOf({ about }) {
  return `${about.name} ${about.id ?? ""}`;
}
