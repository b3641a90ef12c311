// The file that a person saves progress to: what was tried and solved, by the player and by each model, and the attempts
// themselves. It is read back whole, also what other versions have saved, and JSON lines of attempts alone. Knows nothing of the
// document.
//
// { "tasks": {…}, "models": { "within-0": {…} }, "attempts": [{…}] }   as progress-store.js and attempt-store.js have them

import { formatAttempts, parseAttempts } from "./attempt-store.js";

/** @typedef {import("./progress-store.js").SharedProgress} SharedProgress */

/** @param {SharedProgress} progress */
export function progressJson(progress) {
  const models = Object.fromEntries(progress.modelNames.map((name) => [name, JSON.parse(progress.ofModel(name).toJson()).tasks]));
  const attempts = formatAttempts(progress.attempts.all).split("\n").filter(Boolean).map((line) => JSON.parse(line));
  return `${JSON.stringify({ ...JSON.parse(progress.player.toJson()), models, attempts }, null, 1)}\n`;
}

/**
 * Takes what a file holds; where it tells more of a puzzle than is known here, it counts. Returns the number of puzzles and of
 * attempts that it holds. Throws an error with a sentence for the person if it holds none; then nothing has changed.
 * @param {SharedProgress} progress
 * @param {string} text
 */
export function takeProgress(progress, text) {
  const { tasks, models, lines } = contentOf(text);
  const { attempts } = parseAttempts(lines);
  // Files of attempts alone tell of the progress too.
  /** @type {Map<string, { attempts: number, solved: number | null }>} */
  const counted = new Map();
  for (const { task, by, ending } of attempts) {
    const { attempts: before, solved } = counted.get(`${by} ${task}`) ?? { attempts: 0, solved: null };
    counted.set(`${by} ${task}`, { attempts: before + 1, solved: solved ?? (ending.solved ? before + 1 : null) });
  }
  const known = new Set([...Object.keys(Object(tasks)), ...attempts.map(({ task }) => task)]);
  if (known.size === 0) throw new Error("This file holds no progress of Pathlight and no attempts. Choose one that was saved here.");
  progress.attempts.take(attempts);
  progress.player.take(tasks);
  for (const [name, ofModel] of Object.entries(Object(models))) progress.ofModel(name).take(ofModel);
  for (const [key, result] of counted) {
    const [by, task] = key.split(" ");
    (by === "player" ? progress.player : progress.ofModel(by)).take({ [task]: result });
  }
  return { puzzles: known.size, attempts: attempts.length };
}

/**
 * The parts of a file, unchecked.
 * @param {string} text
 * @returns {{ tasks?: unknown, models?: unknown, lines: string }}
 */
function contentOf(text) {
  try {
    const { tasks, models, attempts } = Object(JSON.parse(text));
    if (!Array.isArray(attempts) && tasks === undefined) return { lines: text };
    return { tasks, models, lines: (Array.isArray(attempts) ? attempts : []).map((one) => JSON.stringify(one)).join("\n") };
  } catch {
    return { lines: text };
  }
}
