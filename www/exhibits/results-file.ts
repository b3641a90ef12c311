// assets/results.json, written by `pathlight-lab publish results`: the measurements of the models on the page, and
// published results for comparison.

import type { Setup } from "pathlight";

/** The balls whose predicted chance is in one tenth of 0..1: their number, their mean chance, and how many solve. */
export interface Bin {
  readonly balls: number;
  readonly chance: number;
  readonly solved: number;
}

/** The agents in the order shown. */
export const AGENTS = ["online", "dynamics", "success", "paper", "random"] as const;
export type Agent = (typeof AGENTS)[number];

/** The measurements of a model on the test tasks of one fold. */
export interface ModelResults {
  readonly name: string;
  readonly setup: Setup;
  readonly simulator: number;
  readonly agents_version: number;
  readonly tasks: readonly string[];
  /** For each agent, 0..100. */
  readonly auccess: Readonly<Partial<Record<Agent, number>>>;
  /** For each agent, the number of the ball that first solved each task, from 1; null if none of a hundred did. */
  readonly first_solved: Readonly<Partial<Record<Agent, readonly (number | null)[]>>>;
  readonly calibration: { readonly random: readonly Bin[]; readonly candidates: readonly Bin[] };
}

/** Auccess, within and cross, as printed: means and deviations over ten folds. */
type Row = readonly string[];

export interface Results {
  readonly models: readonly ModelResults[];
  readonly compared: {
    /** By the name of the recipe; "–" unless all ten folds are measured. */
    readonly ours: readonly (readonly [recipe: string, auccess: Row])[];
    /** `method` is empty if the result is known by its authors. */
    readonly published: readonly { method: string; source: string; url: string; auccess: Row }[];
    /** The paper's nets on each template, within and cross: as published, and ours. */
    readonly paper: readonly (readonly [published: readonly string[], ours: readonly string[]])[];
  };
}

/** All measurements as comma-separated values (RFC 4180): a line for each model, agent and task. */
export function resultsCsv(models: readonly ModelResults[], kindOf: (task: string) => string): string {
  const lines = models.flatMap(({ name, simulator, agents_version: version, tasks, first_solved }) =>
    Object.entries(first_solved).flatMap(([agent, firsts]) =>
      tasks.map((task, index) => [name, simulator, version, agent, task, kindOf(task), firsts[index] ?? ""]),
    ),
  );
  const head = ["model", "simulator", "agents_version", "agent", "task", "template", "first_solved"];
  const field = (value: string | number) =>
    /[",\r\n]/.test(String(value)) ? `"${String(value).replaceAll('"', '""')}"` : value;
  return [head, ...lines].map((line) => `${line.map(field).join(",")}\r\n`).join("");
}
