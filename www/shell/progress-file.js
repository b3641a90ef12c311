// The file that a person saves progress to: what was tried and solved, by the player and by each model, and the
// attempts themselves. It is read back whole, also what other versions have saved, and JSON lines of attempts alone.
// Knows nothing of the document.
//
// { "tasks": {…}, "models": { "within-0": {…} }, "attempts": [{…}] }   as progress-store.js and attempt-store.js have
// them

import { NAME, TASK, formatAttempts, parseAttempts } from "./attempt-store.js";
import { validTasks } from "./progress-store.js";

/** @typedef {import("./progress-store.js").SharedProgress} SharedProgress */

/** @param {SharedProgress} progress */
export function progressJson(progress) {
  const models = Object.fromEntries(
    progress.modelNames.map((name) => [name, JSON.parse(progress.ofModel(name).toJson()).tasks]),
  );
  const attempts = formatAttempts(progress.attempts.all)
    .split("\n")
    .filter(Boolean)
    .map((line) => JSON.parse(line));
  return `${JSON.stringify({ ...JSON.parse(progress.player.toJson()), models, attempts }, null, 1)}\n`;
}

/**
 * Takes what a file holds; where it tells more of a puzzle than is known here, it counts. Returns the number of puzzles
 * and of attempts that it holds. Throws an error with a sentence for the person if it holds none; then nothing has
 * changed.
 * @param {SharedProgress} progress
 * @param {string} text
 */
export function takeProgress(progress, text) {
  const { tasks, models, lines } = contentOf(text);
  const { attempts } = parseAttempts(lines);
  const ofPlayer = validTasks({ tasks });
  const ofModels = Object.entries(Object(models)).map(([name, ofModel]) => ({
    name,
    of: validTasks({ tasks: ofModel }),
  }));
  const named = ofModels.filter(({ name, of }) => NAME.test(name) && Object.keys(of).length > 0);
  const known = new Set([
    ...[ofPlayer, ...named.map(({ of }) => of)].flatMap(Object.keys),
    ...attempts.map(({ puzzle }) => puzzle),
  ]);
  if (known.size === 0)
    throw new Error("This file holds no progress of Pathlight and no attempts. Choose one that was saved here.");
  progress.attempts.take(attempts);
  progress.player.take(ofPlayer);
  named.forEach(({ name, of }) => progress.ofModel(name).take(of));
  // Files of attempts alone tell of the progress too.
  for (const [by, tasksOf] of counted(attempts))
    (by === "player" ? progress.player : progress.ofModel(by)).take(tasksOf);
  return { puzzles: known.size, attempts: attempts.length };
}

/**
 * What attempts at tasks tell of the progress of each contender.
 * @param {import("./attempt-store.js").KeptAttempt[]} attempts
 */
function counted(attempts) {
  /** @type {Map<string, Record<string, import("./progress-store.js").TaskProgress>>} */
  const contenders = new Map();
  for (const { puzzle: task, by, ending } of attempts) {
    if (!TASK.test(task)) continue;
    const tasks = contenders.get(by) ?? {};
    const { attempts: before, solved } = tasks[task] ?? { attempts: 0, solved: null };
    tasks[task] = { attempts: before + 1, solved: solved ?? (ending.solved ? before + 1 : null) };
    contenders.set(by, tasks);
  }
  return contenders;
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
    return {
      tasks,
      models,
      lines: (Array.isArray(attempts) ? attempts : []).map((one) => JSON.stringify(one)).join("\n"),
    };
  } catch {
    return { lines: text };
  }
}
