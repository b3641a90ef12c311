// Records a result as a short film: the card, with the run instead of its picture.

import { STEPS_PER_SECOND } from "../shell/constants.js";
import { recorded } from "../attempts/film.js";
import { HEIGHT, WIDTH, paintResultCard } from "./result-card.js";

/** Width of the film, pixels: browsers record larger ones with gaps. */
const FILM_WIDTH = 800;
/** A longer run is shown faster, s. */
const LONGEST = 8;
/** How long the last frame stays, to read the words, s. */
const LAST_FRAME = 1.5;

/** Returns an empty canvas for the film. */
export function filmCanvas() {
  return Object.assign(document.createElement("canvas"), { width: FILM_WIDTH, height: (FILM_WIDTH * HEIGHT) / WIDTH });
}

/**
 * Returns the film, or null if it was given up. Rejects if the browser cannot record it.
 * @param {object} what
 * @param {HTMLCanvasElement} what.canvas shows the film while it is recorded
 * @param {string} what.type its media type
 * @param {import("../play/after-solving.js").Run} what.run
 * @param {import("./result-card.js").Lines} what.lines
 * @param {import("../pkg/pathlight.js").Palette} what.palette
 * @param {boolean} what.dark
 * @param {(fraction: number) => void} what.onProgress
 * @param {AbortController} giveUp
 */
export function recordResult({ canvas, type, run, lines, palette, dark, onProgress }, giveUp) {
  const duration = Math.min(run.steps / STEPS_PER_SECOND, LONGEST);
  return recorded(canvas, type, giveUp.signal, (seconds) => {
    const fraction = Math.min(seconds / duration, 1);
    paintResultCard(canvas, palette, lines, (context) => {
      if (!run.paint(context, fraction * run.steps, dark)) giveUp.abort();
    });
    onProgress(Math.min(seconds / (duration + LAST_FRAME), 1));
    return seconds < duration + LAST_FRAME;
  });
}
