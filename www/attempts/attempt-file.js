// Attempts as a file: JSON lines, one attempt each, with the digest of all its poses, so that anybody can simulate it
// again and see whether the same comes out (`pathlight verify`).

import { download, fileName } from "../widgets/download.js";
import { FileProblem, inSlices, linesOf } from "../storage/sliced-work.js";
import { text as catalogue } from "../text/text.js";

/** @typedef {import("../pkg/pathlight.js").AttemptLine} AttemptLine */

/** More than the attempts of a person at all puzzles, bytes. */
const MAX_SIZE = 2e7;
/** The most attempts of a file that are simulated again: that takes 15 s. `pathlight verify` has no limit. */
export const MOST_ATTEMPTS = 20_000;
/** A longer line is no attempt, characters. */
const MAX_LINE = 65_536;
/** An attempt at a custom scene has objects in four levels. */
const MAX_DEPTH = 8;

/**
 * Saves attempts, so that they can be verified and also be read back as progress (storage/attempt-lines.js).
 * @param {string} name of the puzzle
 * @param {(AttemptLine & { by: string, longest_touch: number, final_touch: number, agents?: number,
 *   weights?: string })[]} lines
 */
export function saveAttempts(name, lines) {
  const text = lines.map((line) => `${JSON.stringify(line)}\n`).join("");
  download(fileName(`${name} attempts`, "jsonl"), new Blob([text], { type: "application/jsonl" }));
}

/**
 * Returns the lines of a file of attempts, as they are, and how many more it has than are read. Rejects with a
 * FileProblem if it is none.
 * @param {File} file
 * @param {Parameters<typeof inSlices>[1]} [slices]
 */
export async function readAttempts(file, slices) {
  if (file.size > MAX_SIZE) throw foreign(file.name, catalogue.attempts.file.tooLarge(MAX_SIZE / 1e6));
  return inSlices(attemptsOfText(file.name, await file.text()), slices);
}

/**
 * @param {string} name of the file
 * @param {string} text
 * @returns {Generator<number, { attempts: unknown[], left: number }, void>}
 */
function* attemptsOfText(name, text) {
  /** @type {unknown[]} */
  const attempts = [];
  let left = 0;
  for (const { line, number, done } of linesOf(text)) {
    if (attempts.length < MOST_ATTEMPTS) attempts.push(parsedLine(name, line, number));
    else left += 1;
    yield done;
  }
  if (attempts.length === 0) throw foreign(name, catalogue.attempts.file.empty);
  return { attempts, left };
}

/**
 * @param {string} name of the file
 * @param {string} line
 * @param {number} number
 */
function parsedLine(name, line, number) {
  const { tooLong, notJson, tooDeep } = catalogue.attempts.file;
  if (line.length > MAX_LINE) throw foreign(name, tooLong(number));
  /** @type {unknown} */
  let value;
  try {
    value = JSON.parse(line);
  } catch {
    throw foreign(name, notJson(number));
  }
  if (isDeeper(value, MAX_DEPTH)) throw foreign(name, tooDeep(number));
  return value;
}

/**
 * @param {unknown} value
 * @param {number} depth
 * @returns {boolean}
 */
function isDeeper(value, depth) {
  if (typeof value !== "object" || value === null) return false;
  return depth === 0 || Object.values(value).some((inner) => isDeeper(inner, depth - 1));
}

/**
 * @param {string} name of the file
 * @param {string} why
 */
function foreign(name, why) {
  return new FileProblem(catalogue.attempts.file.foreign(name, why));
}
