// Reads the weights of the models.

import { failure } from "./failure.js";
import { readFile } from "./files.js";
import { weightsAddress } from "./model-files.js";
import { intact, sha256 } from "./sha256.js";

/** @typedef {import("./files.js").OnProgress} OnProgress */
/** @typedef {import("./model-files.js").ModelEntry} ModelEntry */

/**
 * Returns the weights of a model. Refuses those that are not what the list names.
 * @param {ModelEntry} entry
 * @param {OnProgress} [onProgress]
 */
export async function readWeights(entry, onProgress) {
  const { size, sha256: hash } = entry;
  const address = weightsAddress(entry);
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
  if (!bytes)
    throw failure("bad_weights", `${address} is not the file that the list of models names: it is damaged or old.`);
  return bytes;
}
