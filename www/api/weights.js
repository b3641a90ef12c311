// Finds and reads the weights of the models.
//
// assets/model.json lists them: { "models": [{ "name", "file", "size", "sha256" }, …] }; the size is in bytes.

import { failure } from "./failure.js";
import { readFile } from "./files.js";

/** @typedef {import("./files.js").OnProgress} OnProgress */
/** @typedef {{ name: string, file: string, size?: number, sha256?: string }} ModelEntry */

const LIST = new URL("../assets/model.json", import.meta.url);

/**
 * Returns the list of the models.
 * @returns {Promise<ModelEntry[]>}
 */
export async function readModelList() {
  const bytes = await readFile(LIST, (reason, status) =>
    failure("no_weights", status === 404
      ? "The model’s weights are missing here: there is no assets/model.json. If Pathlight has been updated meanwhile, load the page again; if not, the model can neither imagine nor play, but you can."
      : `The list of models could not be loaded: ${reason} for ${LIST}.`));
  const list = await new Response(bytes).json().catch(() => {
    throw failure("no_weights", `The list of models is damaged: what ${LIST} holds is not JSON. Put the file there again.`);
  });
  if (!Array.isArray(list?.models) || list.models.length === 0) {
    throw failure("no_weights", `The list of models, ${LIST}, names none. Write it again by “pathlight publish”.`);
  }
  return list.models;
}

/**
 * Returns the weights of a model. Refuses those that are not what the list names.
 * @param {ModelEntry} entry
 * @param {OnProgress} [onProgress]
 */
export async function readWeights({ file, size, sha256 }, onProgress) {
  // In this form bundlers find the files.
  const address = new URL(`../assets/${file}`, import.meta.url);
  const bytes = await readFile(address, (reason, status) =>
    failure("no_weights", `The model’s weights ${status === 404 ? "are missing here" : "could not be loaded"}: ${reason} for ${address}.`), onProgress, size);
  // Browsers hash only on secure and local addresses.
  if (sha256 && globalThis.crypto?.subtle && (await digest(bytes)) !== sha256) {
    throw failure("bad_weights", `${address} is not the file that ${LIST} names: it is damaged or old.`);
  }
  return bytes;
}

/** @param {Uint8Array<ArrayBuffer>} bytes */
async function digest(bytes) {
  const hash = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  return Array.from(hash, (byte) => byte.toString(16).padStart(2, "0")).join("");
}
