// The measurements of the shipped models: which test tasks each agent solves, and how often its chances come true; and
// beside them what others have published. Read only when somebody asks for them. Knows nothing of the document.
//
// assets/results.json, which `pathlight-lab publish results` writes.

import { failure } from "../api/failure.js";
import { readFile } from "../api/files.js";
import { text } from "../text/text.js";
import { toCsv } from "./csv.js";

/**
 * The balls to which a model gives a chance in one tenth of 0..1: their number, the mean of the chances, and how many
 * solve.
 * @typedef {{ balls: number, chance: number, solved: number }} Bin
 */

/**
 * The measurements of a model on the test tasks of its fold: for each agent the first attempt that solved each task,
 * from 1, null if none of a hundred did; and its auccess, 0 to 100.
 * @typedef {object} ModelResults
 * @property {string} name
 * @property {import("../pkg/pathlight.js").Setup} setup
 * @property {number} simulator
 * @property {number} agents_version
 * @property {string[]} tasks
 * @property {Record<string, number>} auccess
 * @property {Record<string, (number | null)[]>} first_solved
 * @property {{ random: Bin[], candidates: Bin[] }} calibration
 */

/**
 * `compared`: auccess, within and cross. `ours` are means and deviations over the folds; of `published`, `method` is
 * empty if it goes by its authors. `online_with_other_data` is that of the online agent if its net learned from balls
 * that it proposed (within) or from random scenes (cross); null unless all ten folds are measured. `paper` has the
 * auccess of the paper's nets on each template, within and cross.
 * @typedef {object} Results
 * @property {ModelResults[]} models
 * @property {{ ours: { agent: string, auccess: string[] }[], online_with_other_data: (string | null)[], published:
 *   { method: string, source: string, url: string, auccess: string[] }[], paper?: { published: string[],
 *   ours: string[] }[] }} compared
 */

/** The agents in the order shown. */
export const AGENTS = /** @type {const} */ (["online", "dynamics", "success", "paper", "random"]);

const ADDRESS = new URL("../assets/results.json", import.meta.url);

/** @type {Promise<Results> | null} */
let read = null;

/**
 * Returns the contents of results.json. Rejects with a sentence for the person; the next call then tries again.
 * @returns {Promise<Results>}
 */
export function readResults() {
  read ??= load().catch((error) => {
    read = null;
    throw error;
  });
  return read;
}

async function load() {
  const bytes = await readFile(ADDRESS, (reason) =>
    failure("no_weights", text.model.results.notLoaded(reason, ADDRESS.href)),
  );
  return new Response(bytes).json().catch(() => {
    throw failure("bad_data", text.model.results.damaged(ADDRESS.href));
  });
}

/**
 * All measurements as comma-separated values: a line for each model, agent and task.
 * @param {ModelResults[]} models
 * @param {(task: string) => string} nameOf the name of a task's template
 */
export function resultsCsv(models, nameOf) {
  const rows = models.flatMap(({ name, simulator, agents_version: version, tasks, first_solved: solved }) =>
    Object.entries(solved).flatMap(([agent, firsts]) =>
      tasks.map((task, index) => [name, simulator, version, agent, task, nameOf(task), firsts[index]]),
    ),
  );
  return toCsv([["model", "simulator", "agents_version", "agent", "task", "template", "first_solved"], ...rows]);
}
