// The attempts of assets/attempts.jsonl, which the native program has simulated: what computes the same digests here
// computes the same as it.

import { failure } from "../api/failure.js";
import { readFile } from "../api/files.js";

const ADDRESS = new URL("../assets/attempts.jsonl", import.meta.url);

/**
 * Returns their lines; none where Pathlight comes without them.
 * @returns {Promise<unknown[]>}
 */
export async function readNativeAttempts() {
  const bytes = await readFile(ADDRESS, (reason) => failure("bad_data", reason)).catch(() => null);
  return bytes
    ? new TextDecoder()
        .decode(bytes)
        .trimEnd()
        .split("\n")
        .map((line) => JSON.parse(line))
    : [];
}
