// Writes folders of files for servers that send FILE.br or FILE.gz instead of FILE.
//
// Results are cached in target/compressed, named by the hash of the content, because each weights file takes 15 s at
// the best quality.

import { createHash, randomUUID } from "node:crypto";
import { mkdir, readFile, rename, rm, writeFile } from "node:fs/promises";
import { basename, dirname, extname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";
import { brotliCompress, constants, gzip } from "node:zlib";

const KEPT = fileURLToPath(new URL("../target/compressed", import.meta.url));
/** Brotli's quality for weights. The highest takes twice as long and makes them 1 % larger. */
const WEIGHTS_QUALITY = 10;
/** Compressing a file of more than these bytes, at this quality or higher, is slow enough to announce. */
const SLOW = 3_000_000;
const SLOW_QUALITY = 10;
/** Below this size, bytes, even the best quality takes only seconds. The files that a page needs first are smaller. */
const SMALL = 1_000_000;
/** Image files do not shrink further. */
const COMPRESSIBLE = /\.(html|css|js|json|jsonl|svg|txt|wasm|webmanifest|safetensors)$/;

/** @param {string} path */
export function isCompressible(path) {
  return COMPRESSIBLE.test(path);
}

/**
 * Replaces the contents of a folder by files and their compressed forms, once all are written, so that a server never
 * serves a mix of two versions.
 * @param {string} out
 * @param {Iterable<[path: string, content: Buffer]>} files
 * @param {number} [quality] brotli's quality for files that are not small; by default the one that makes each file
 *   smallest; 0 compresses nothing
 */
export async function replaceFolder(out, files, quality) {
  const part = `${out}.${process.pid}`;
  try {
    await writeFiles(part, files, quality);
    await rm(out, { recursive: true, force: true });
    await rename(part, out);
  } finally {
    await rm(part, { recursive: true, force: true });
  }
}

/**
 * @param {string} folder
 * @param {Iterable<[path: string, content: Buffer]>} files
 * @param {number} [quality] as above
 */
export async function writeFiles(folder, files, quality) {
  const written = [...files].map(async ([path, content]) => {
    const target = join(folder, path);
    await mkdir(dirname(target), { recursive: true });
    await writeFile(target, content);
    const chosen = content.length < SMALL ? undefined : quality;
    if (quality !== 0 && isCompressible(path)) await writeCompressed(target, content, chosen);
  });
  await Promise.all(written);
}

/**
 * Writes the compressed forms of a file next to it.
 * @param {string} path
 * @param {Buffer} content the content of the file
 * @param {number} [quality] brotli's quality; by default the one that makes the file smallest
 */
async function writeCompressed(path, content, quality = bestQuality(path)) {
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
    console.error(`== compressing ${basename(path)} (a few seconds, once)`);
  return promisify(brotliCompress)(content, { params });
}

/**
 * Returns a cached result, or computes and caches it.
 * @param {string} name
 * @param {() => Promise<Buffer>} compress
 */
async function keptOr(name, compress) {
  const path = join(KEPT, name);
  const kept = await readFile(path).catch(() => undefined);
  if (kept) return kept;
  const result = await compress();
  await mkdir(KEPT, { recursive: true });
  // Renaming is atomic: an interrupted build leaves no partial result, and two files with the same content can be
  // compressed at the same time.
  const part = `${path}.${randomUUID()}`;
  await writeFile(part, result);
  await rename(part, path);
  return result;
}
