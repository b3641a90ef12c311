// Reads a file that the person has chosen: the notice says how far it is, stops it, and says what went wrong.

import { dismissNotice, showNotice } from "../widgets/notice.js";
import { FileProblem } from "../storage/sliced-work.js";
import { text } from "../text/text.js";

/**
 * Returns what `read` returns, or null if that was stopped or has failed.
 * @template T
 * @param {string} name of the file
 * @param {(options: { signal: AbortSignal, onProgress: (done: number) => void }) => Promise<T>} read
 * @returns {Promise<T | null>}
 */
export async function readChosen(name, read) {
  const { reading, stop: stopLabel, stopped, failed } = text.page.files;
  const stop = new AbortController();
  let shown = "";
  const onProgress = (/** @type {number} */ done) => {
    const words = reading(name, Math.floor(done * 10) / 10);
    if (words !== shown) showNotice((shown = words), [[stopLabel, () => stop.abort()]]);
  };
  try {
    const result = await read({ signal: stop.signal, onProgress });
    if (shown) dismissNotice();
    return result;
  } catch (error) {
    if (stop.signal.aborted) showNotice(stopped(name));
    else if (error instanceof FileProblem) showNotice(error.message);
    else showNotice(failed(name));
    return null;
  }
}
