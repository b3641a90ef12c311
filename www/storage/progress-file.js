// The file that a person saves progress to: what was tried and solved, by the player and by each model, and the
// attempts themselves, one on each line. What other versions have saved is read too, and JSON lines of attempts alone.
// Knows nothing of the document.
//
// { "tasks": {…}, "models": { "within-0": {…} }, "attempts": [{…}] }   as counts.js and attempts.js have them

import { AttemptReader, NAME, PLAYER, compareTexts, lineOf } from "./attempt-lines.js";
import { text as catalogue } from "../text/text.js";
import { Counts } from "./counts.js";
import { FileProblem, linesOf } from "./sliced-work.js";

/** Text that is not JSON lines is read at once; more would freeze the page, characters. */
const MAX_JSON = 1e7;
/** How such a file begins. */
const OBJECT = /^\s*\{\s*"(tasks|models|attempts)"/;

/** @param {import("./progress.js").Progress} progress */
export function progressJson(progress) {
  const known = progress.counts.all.sort((a, b) => compareTexts(a.task, b.task));
  /** @param {string} author */
  const tasksOf = (author) =>
    Object.fromEntries(known.filter(({ by }) => by === author).map(({ task, progress }) => [task, progress]));
  const names = [...new Set(known.map(({ by }) => by))].filter((by) => by !== PLAYER).sort();
  const models = Object.fromEntries(names.map((name) => [name, tasksOf(name)]));
  const attempts = progress.all.map((attempt) => JSON.stringify(lineOf(attempt)));
  const counts = JSON.stringify({ tasks: tasksOf(PLAYER), models }, null, 1);
  return `${counts.slice(0, -2)},\n "attempts": [\n${attempts.join(",\n")}\n]}\n`;
}

/**
 * What a file holds, read step by step. Throws a FileProblem if it holds no progress.
 * @param {string} text
 * @param {(scene: any) => string} digestOf returns the digest of a custom scene, or throws
 * @returns {Generator<number, { attempts: import("./attempt-lines.js").KeptAttempt[], counts: Counts, unread: number },
 *   void>}
 */
export function* progressOfText(text, digestOf) {
  const counts = new Counts();
  const reader = new AttemptReader((by, task) => counts.of(by, task).solved, digestOf);
  const whole = parsed(text);
  const { tasks, models, attempts } = Object(whole);
  if (Array.isArray(attempts) || tasks !== undefined) {
    counts.read(PLAYER, tasks);
    for (const [name, ofModel] of Object.entries(Object(models))) if (NAME.test(name)) counts.read(name, ofModel);
    const values = Array.isArray(attempts) ? attempts : [];
    for (const [index, attempt] of values.entries()) {
      reader.add(attempt);
      yield index / values.length;
    }
  } else {
    for (const { line, done } of linesOf(text)) {
      // In a file that is cut off, attempts are the elements of an array.
      reader.addLine(line.replace(/,\s*$/, ""));
      yield done;
    }
  }
  if (reader.attempts.length === 0 && counts.all.length === 0) {
    const { tooLarge, empty } = catalogue.reading.progressFile;
    throw new FileProblem(text.length > MAX_JSON && whole === undefined ? tooLarge : empty);
  }
  return { attempts: reader.attempts, counts, unread: reader.unread };
}

/**
 * The value of JSON; undefined if it is none, or too much.
 * @param {string} text
 */
function parsed(text) {
  try {
    return OBJECT.test(text) && text.length <= MAX_JSON ? JSON.parse(text) : undefined;
  } catch {
    return undefined;
  }
}
