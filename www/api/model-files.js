// Where the models are: a list of them, assets/model.json, and their weights beside it. The npm package has a module of
// its own in place of this one (scripts/build-package.mjs).
//
// The list: { "models": [{ "name", "file", "size", "sha256" }, …] }; the size is in bytes.

import { failure } from "./failure.js";
import { readFile } from "./files.js";

/** @typedef {{ name: string, file: string, size?: number, sha256?: string }} ModelEntry */

const LIST = new URL("../assets/model.json", import.meta.url);

/**
 * Returns the list of the models.
 * @returns {Promise<ModelEntry[]>}
 */
export async function readModelList() {
  const bytes = await readFile(LIST, (reason, status) =>
    failure(
      "no_weights",
      status === 404
        ? "The model’s weights are missing here: there is no assets/model.json. If Pathlight has been updated meanwhile, load the page again; if not, the model can neither imagine nor play, but you can."
        : `The list of models could not be loaded: ${reason} for ${LIST}.`,
    ),
  );
  const list = await new Response(bytes).json().catch(() => {
    throw failure(
      "no_weights",
      `The list of models is damaged: what ${LIST} holds is not JSON. Put the file there again.`,
    );
  });
  if (!Array.isArray(list?.models) || list.models.length === 0) {
    throw failure(
      "no_weights",
      `The list of models, ${LIST}, names none. Write it again by “pathlight-lab publish weights”.`,
    );
  }
  return list.models;
}

/**
 * Returns the address of a model's weights.
 * @param {ModelEntry} entry
 */
export function weightsAddress({ file }) {
  return new URL(`../assets/${file}`, import.meta.url);
}
