import { AGENTS_VERSION, SIMULATOR_VERSION } from "../shell/constants.js";

/**
 * What the turns of a model depend on: the same balls follow as long as these are the same.
 * @param {import("./worker.js").LoadedModel | null} loaded
 */
export function turnVersions(loaded) {
  // Eight digits are enough to tell weights apart.
  return { simulator: SIMULATOR_VERSION, agents: AGENTS_VERSION, weights: loaded?.sha256?.slice(0, 8) };
}
