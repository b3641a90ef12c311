// Attempts as a file: JSON lines, one attempt each, with the digest of all its poses, so that anybody can simulate it
// again and see whether the same comes out (`pathlight verify`).

import { download, fileName } from "../widgets/download.js";

/** @typedef {import("../pkg/pathlight.js").AttemptLine} AttemptLine */

/** More than the attempts of a person at all puzzles, bytes. */
const MAX_SIZE = 2e7;

/**
 * Saves attempts, so that they can be verified and also be read back as progress (shell/attempt-store.js).
 * @param {string} name of the puzzle
 * @param {(AttemptLine & { by: string, longest_touch: number, final_touch: number, agents?: number })[]} lines
 */
export function saveAttempts(name, lines) {
  const text = lines.map((line) => `${JSON.stringify(line)}\n`).join("");
  download(fileName(`${name} attempts`, "jsonl"), new Blob([text], { type: "application/jsonl" }));
}

/**
 * Returns the lines of a file of attempts, as they are. Rejects with a sentence if it is none.
 * @param {File} file
 * @returns {Promise<unknown[]>}
 */
export async function readAttempts(file) {
  const foreign = (/** @type {string} */ why) =>
    new Error(`${file.name} is not a file of attempts from Pathlight: ${why}. Nothing was changed.`);
  if (file.size > MAX_SIZE) throw foreign("it is too large");
  const lines = (await file.text()).split("\n");
  /** @type {unknown[]} */
  const attempts = [];
  lines.forEach((line, index) => {
    if (!line.trim()) return;
    try {
      attempts.push(JSON.parse(line));
    } catch {
      throw foreign(`line ${index + 1} is not JSON`);
    }
  });
  if (attempts.length === 0) throw foreign("it is empty");
  return attempts;
}
