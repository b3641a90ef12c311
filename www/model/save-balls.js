import { download, fileName } from "../widgets/download.js";
import { ballsCsv } from "./outcomes.js";

/** @typedef {NonNullable<import("./shared-client.js").SharedClient["loaded"]>} Loaded */

/**
 * Saves the balls of a model on a task as comma-separated values.
 * @param {import("../pkg/pathlight.js").TriedProposal[]} balls
 * @param {{ task: string, seen: boolean, loaded: Loaded }} about
 */
export function saveBalls(balls, { task, seen, loaded: { name, card } }) {
  const csv = ballsCsv(balls, { task, model: name, seen, simulator: card.simulator });
  download(fileName(`pathlight ${task} ${name}`, "csv"), new Blob([csv], { type: "text/csv" }));
}
