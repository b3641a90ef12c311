// Compresses files in advance, for servers that send FILE.br or FILE.gz in place of FILE.
//
// Results are kept in target/compressed, named by the hash of the content: at the best quality each file of weights
// takes 15 s.

import { createHash } from "node:crypto";
import { mkdir, readFile, rename, writeFile } from "node:fs/promises";
import { basename, extname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";
import { brotliCompress, constants, gzip } from "node:zlib";

const KEPT = fileURLToPath(new URL("../target/compressed", import.meta.url));
/** Brotli's quality for weights. The highest takes twice as long and makes them 1 % larger. */
const WEIGHTS_QUALITY = 10;
/** Files that a person waits for are announced: bytes, and from which quality on. */
const SLOW = 3_000_000;
const SLOW_QUALITY = 10;
/** Images do not become smaller. */
const COMPRESSIBLE = /\.(html|css|js|json|jsonl|svg|txt|wasm|webmanifest|safetensors)$/;

/** @param {string} path */
export function isCompressible(path) {
  return COMPRESSIBLE.test(path);
}

/**
 * Writes the compressed forms of a file beside it.
 * @param {string} path
 * @param {Buffer} content the file's
 * @param {number} [quality] brotli's; by default the one that makes the file smallest
 */
export async function writeCompressed(path, content, quality = bestQuality(path)) {
  const hash = createHash("sha256").update(content).digest("hex");
  const params = { [constants.BROTLI_PARAM_QUALITY]: quality, [constants.BROTLI_PARAM_SIZE_HINT]: content.length };
  const forms = [
    { name: `${hash}-${quality}.br`, compress: () => brotli(path, content, params) },
    { name: `${hash}.gz`, compress: () => promisify(gzip)(content, { level: constants.Z_BEST_COMPRESSION }) },
  ];
  await Promise.all(
    forms.map(async ({ name, compress }) => writeFile(path + extname(name), await keptOr(name, compress))),
  );
}

/** @param {string} path */
function bestQuality(path) {
  return path.endsWith(".safetensors") ? WEIGHTS_QUALITY : constants.BROTLI_MAX_QUALITY;
}

/**
 * @param {string} path
 * @param {Buffer} content
 * @param {Record<number, number>} params
 */
function brotli(path, content, params) {
  if (content.length > SLOW && params[constants.BROTLI_PARAM_QUALITY] >= SLOW_QUALITY)
    console.error(`== compressing ${basename(path)} (some seconds, once)`);
  return promisify(brotliCompress)(content, { params });
}

/**
 * Returns a kept result, or computes it and keeps it.
 * @param {string} name
 * @param {() => Promise<Buffer>} compress
 */
async function keptOr(name, compress) {
  const path = join(KEPT, name);
  const kept = await readFile(path).catch(() => undefined);
  if (kept) return kept;
  const result = await compress();
  await mkdir(KEPT, { recursive: true });
  // Renamed, so that an interrupted build leaves no half of a result.
  await writeFile(`${path}.${process.pid}`, result);
  await rename(`${path}.${process.pid}`, path);
  return result;
}
