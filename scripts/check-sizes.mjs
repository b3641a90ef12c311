// Checks that no part of the page exceeds its size limit: node scripts/check-sizes.mjs (needs dist/, which `make dist`
// builds). If a part grows on purpose, raise its limit here.

import { existsSync } from "node:fs";
import { readFile, readdir } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { brotliCompressSync } from "node:zlib";

const DIST = join(dirname(fileURLToPath(import.meta.url)), "..", "dist");

/** Limits for the total size of the files of a part, kB: uncompressed, and compressed by brotli. */
const LIMITS = [
  { part: "the page's wasm", files: /page\/\w+\.wasm$/, raw: 1000, br: 260 },
  { part: "the worker's wasm", files: /worker\/\w+\.wasm$/, raw: 3750, br: 595 },
  // The scripts of a visit in English: the other language and QR codes load on demand.
  {
    part: "scripts",
    files: /^\w+\/(first-look|main|worker|updates|chunks\/(?!de-|lean-qr)[\w-]+)\.js$/,
    raw: 190,
    br: 60,
  },
  { part: "styles", files: /\.css$/, raw: 30, br: 8 },
  { part: "weights within-0", files: /within-0-\w+\.safetensors$/, raw: 3720, br: 3000 },
  { part: "weights cross-0", files: /cross-0-\w+\.safetensors$/, raw: 3720, br: 3050 },
];

/**
 * Returns the total size of some files, kB.
 * @param {string[]} paths
 * @param {(path: string) => Promise<Buffer>} read
 */
async function sizeOf(paths, read) {
  const contents = await Promise.all(paths.map(read));
  return contents.reduce((sum, { length }) => sum + length, 0) / 1000;
}

/** @param {string} path */
const compressed = async (path) =>
  existsSync(`${path}.br`) ? readFile(`${path}.br`) : brotliCompressSync(await readFile(path));

const all = await readdir(DIST, { recursive: true });
for (const { part, files, raw, br } of LIMITS) {
  const paths = all.filter((path) => files.test(path)).map((path) => join(DIST, path));
  const sizes = [
    { form: "uncompressed", size: await sizeOf(paths, (path) => readFile(path)), limit: raw },
    { form: "compressed", size: await sizeOf(paths, compressed), limit: br },
  ];
  for (const { form, size, limit } of sizes) {
    const isRight = paths.length > 0 && size <= limit;
    console.log(`${isRight ? "ok   " : "error"} ${part}, ${form}: ${size.toFixed(0)} of ${limit} kB`);
    if (!isRight) process.exitCode = 1;
  }
}
