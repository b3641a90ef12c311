// Hashes what was fetched, so that a file damaged on its way or in a cache is not used.

/**
 * Returns the SHA-256 of bytes in hexadecimal, or null where it cannot be computed: browsers hash only on secure and
 * local addresses.
 * @param {BufferSource} bytes
 */
export async function sha256(bytes) {
  if (!globalThis.crypto?.subtle) return null;
  const hash = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  return Array.from(hash, (byte) => byte.toString(16).padStart(2, "0")).join("");
}

/**
 * Returns what a function makes of a file that is intact. A damaged one is asked for once more, past all caches, which
 * may hold the damage.
 * @template T
 * @param {(cache: RequestCache) => Promise<T | null>} read null if the file is damaged
 */
export async function intact(read) {
  return (await read("default")) ?? (await read("reload"));
}
