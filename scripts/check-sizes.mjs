// Checks that no part of dist/ has grown unseen: node scripts/check-sizes.mjs (`make dist` builds it). Whoever makes a
// part larger on purpose raises its limit here.

import { readFile, readdir } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const DIST = join(dirname(fileURLToPath(import.meta.url)), "..", "dist");

/** Most kB of the files of a part, together: as they are, and compressed by brotli. */
const LIMITS = [
  { part: "wasm", files: /\.wasm$/, raw: 3300, br: 580 },
  // With the words in both languages, of which a person loads one.
  { part: "scripts", files: /\.js$/, raw: 445, br: 132 },
  { part: "styles", files: /\.css$/, raw: 53, br: 13 },
  { part: "weights within-0", files: /within-0-\w+\.safetensors$/, raw: 3720, br: 3000 },
  { part: "weights cross-0", files: /cross-0-\w+\.safetensors$/, raw: 3720, br: 3050 },
];

/**
 * The size of some files of dist/, kB.
 * @param {string[]} paths
 */
async function sizeOf(paths) {
  const contents = await Promise.all(paths.map((path) => readFile(join(DIST, path))));
  return contents.reduce((sum, { length }) => sum + length, 0) / 1000;
}

const all = await readdir(DIST, { recursive: true });
for (const { part, files, raw, br } of LIMITS) {
  const paths = all.filter((path) => files.test(path));
  const sizes = [
    { form: "as it is", size: await sizeOf(paths), limit: raw },
    { form: "compressed", size: await sizeOf(paths.map((path) => `${path}.br`)), limit: br },
  ];
  for (const { form, size, limit } of sizes) {
    const isRight = paths.length > 0 && size <= limit;
    console.log(`${isRight ? "ok   " : "error"} ${part}, ${form}: ${size.toFixed(0)} of ${limit} kB`);
    if (!isRight) process.exitCode = 1;
  }
}
