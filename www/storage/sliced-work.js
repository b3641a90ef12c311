// Long work in slices, between which the page draws and answers.

/** How long a slice may take, ms. */
const SLICE = 12;

/**
 * A problem with what a person has chosen, in a sentence for them. Other errors are not for their eyes.
 */
export class FileProblem extends Error {}

/**
 * Runs a generator to its end and returns what it returns. Rejects with the signal's reason once that is aborted.
 * @template Result
 * @param {Generator<number, Result, void>} steps yields after each step how much is done, 0..1
 * @param {object} [options]
 * @param {AbortSignal} [options.signal]
 * @param {(done: number) => void} [options.onProgress] called between slices
 * @param {() => Promise<void>} [options.pause]
 * @param {() => number} [options.now] ms
 * @returns {Promise<Result>}
 */
export async function inSlices(steps, { signal, onProgress, pause = nextTask, now = () => performance.now() } = {}) {
  let end = now() + SLICE;
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
    if (now() < end) continue;
    onProgress?.(value);
    await pause();
    if (signal?.aborted) {
      steps.return(/** @type {any} */ (undefined));
      throw signal.reason;
    }
    end = now() + SLICE;
  }
}

/**
 * Runs a generator to its end at once.
 * @template Result
 * @param {Generator<number, Result, void>} steps
 */
export function atOnce(steps) {
  for (;;) {
    const { done, value } = steps.next();
    if (done) return /** @type {Result} */ (value);
  }
}

/** @returns {Promise<void>} */
function nextTask() {
  return new Promise((resolve) => setTimeout(resolve));
}

/**
 * The lines of a text that are not empty, with how much of it they end.
 * @param {string} text
 * @returns {Generator<{ line: string, number: number, done: number }, void, void>}
 */
export function* linesOf(text) {
  let number = 0;
  for (let start = 0; start < text.length; number += 1) {
    const newline = text.indexOf("\n", start);
    const end = newline < 0 ? text.length : newline;
    const line = text.slice(start, end);
    start = end + 1;
    if (line.trim()) yield { line, number: number + 1, done: end / text.length };
  }
}
