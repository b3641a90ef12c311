// Saves what the scene shows: as a picture, or a run as a film, which the browser records from a canvas while the run is drawn on
// it once more. Everything happens in this browser.

import { Component } from "../shell/component.js";
import { STEPS_PER_SECOND } from "../shell/constants.js";
import { contextOf, setText } from "../shell/dom.js";
import { download, fileName } from "../shell/download.js";
import { paintStill } from "../play/still.js";

/** Width and height of a picture, pixels, and of a film. */
const PICTURE_SIDE = 1024;
const FILM_SIDE = 512;
/** What films are saved as, best first; browsers record different formats. */
const FORMATS = ["video/webm;codecs=vp9", "video/webm", "video/mp4"];
/** Bits of a film per second. */
const BIT_RATE = 4e6;
/** How long the last frame stays, s. */
const LAST_FRAME = 0.7;

export class Pictures extends Component {
  #filmButton = this.byId("save-film", HTMLButtonElement);
  /**
   * The film that is being recorded.
   * @type {AbortController | null}
   */
  #recording = null;

  /** @param {import("../shell/dom.js").Root} root */
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
    const type = globalThis.MediaRecorder && FORMATS.find((format) => MediaRecorder.isTypeSupported(format));
    if (!type) {
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
      const blob = await recorded(context.canvas, type, recording.signal, (seconds) => {
        const step = Math.min(seconds * STEPS_PER_SECOND, steps);
        if (!showsTheSame()) recording.abort();
        else paintStill(session, context, step, this.dark);
        setText(this.byId("save-words"), `Recording: ${Math.min(seconds, steps / STEPS_PER_SECOND).toFixed(0)} of ${(steps / STEPS_PER_SECOND).toFixed(0)} s.`);
        return seconds < steps / STEPS_PER_SECOND + LAST_FRAME;
      });
      if (blob) {
        download(fileName(titleOf(session), type.includes("mp4") ? "mp4" : "webm"), blob);
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

/**
 * Records a canvas while frames are drawn on it. Returns the film, or null if it was aborted. Rejects if the browser cannot
 * record it, or a frame cannot be drawn.
 * @param {HTMLCanvasElement} canvas
 * @param {string} type
 * @param {AbortSignal} signal
 * @param {(seconds: number) => boolean} drawFrame draws the frame of a time, s; returns whether more follow
 * @returns {Promise<Blob | null>}
 */
async function recorded(canvas, type, signal, drawFrame) {
  drawFrame(0);
  const recorder = new MediaRecorder(canvas.captureStream(), { mimeType: type, videoBitsPerSecond: BIT_RATE });
  /** @type {Blob[]} */
  const parts = [];
  recorder.addEventListener("dataavailable", ({ data }) => parts.push(data));
  /** @type {unknown} */
  let failure = null;
  recorder.addEventListener("error", (event) => (failure = event));
  const stopped = new Promise((resolve) => recorder.addEventListener("stop", resolve));
  recorder.start();
  const begin = performance.now();
  try {
    do await new Promise(requestAnimationFrame);
    while (!signal.aborted && recorder.state === "recording" && drawFrame((performance.now() - begin) / 1000));
  } finally {
    // It has stopped by itself if it has failed.
    if (recorder.state === "recording") recorder.stop();
  }
  await stopped;
  if (failure) throw failure;
  return signal.aborted ? null : new Blob(parts, { type });
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
