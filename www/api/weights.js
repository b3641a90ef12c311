// Finds and reads the weights of the models.
//
// assets/model.json lists them: { "models": [{ "name", "file", "size", "sha256" }, …] }; the size is in bytes.

import { failure } from "./failure.js";
import { readFile } from "./files.js";
import { intact, sha256 } from "./sha256.js";

/** @typedef {import("./files.js").OnProgress} OnProgress */
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
 * Returns the weights of a model. Refuses those that are not what the list names.
 * @param {ModelEntry} entry
 * @param {OnProgress} [onProgress]
 */
export async function readWeights({ file, size, sha256: hash }, onProgress) {
  // In this form bundlers find the files.
  const address = new URL(`../assets/${file}`, import.meta.url);
  /** @type {import("./files.js").Refuse} */
  const refuse = (reason, status) =>
    failure(
      "no_weights",
      `The model’s weights ${status === 404 ? "are missing here" : "could not be loaded"}: ${reason} for ${address}.`,
    );
  const bytes = await intact(async (cache) => {
    const read = await readFile(address, refuse, onProgress, size, cache);
    const found = hash ? await sha256(read) : null;
    return found && found !== hash ? null : read;
  });
  if (!bytes) throw failure("bad_weights", `${address} is not the file that ${LIST} names: it is damaged or old.`);
  return bytes;
}
