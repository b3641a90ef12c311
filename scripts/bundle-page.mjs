// Bundles the page: node scripts/bundle-page.mjs writes target/page, which `make play` serves (needs www/pkg).
//
// A browser spends some 8 ms on every file that it asks for, so that fifty modules would hold up the first puzzle for
// longer than all the rest. The bundle of an entry takes the entry's own place, and the addresses in it, which are
// relative to a folder beside that of the module ("../pkg/…"), lead where they led before. The sources work without it.

import { existsSync } from "node:fs";
import { mkdir, readFile, readdir, rm, writeFile } from "node:fs/promises";
import { dirname, join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const ROOT = join(dirname(fileURLToPath(import.meta.url)), "..");
export const SOURCES = join(ROOT, "www");
/** What compiles the wasm while the rest is read. */
const FIRST = "loading/compile-wasm.js";
/** With it, what the page starts with, and what its worker does. */
const ENTRIES = [FIRST, "page/main.js", "model/worker.js"];
/** What a page of dist/ has besides. */
const OFFLINE = /^offline\//;
const MODULE = /\.(js|d\.ts)$/;
/** What the page loads only when it is asked for, as it is. */
const LAZY = "pkg/lean-qr.js";

/** @typedef {Map<string, Buffer>} Files contents by path, with `/` */

/**
 * Returns all files of the page, sorted by path, with its modules bundled.
 * @param {string} page the folder of the sources
 * @returns {Promise<Files>}
 */
export async function bundledPage(page) {
  const missing = ["pkg/pathlight.js", "pkg/pathlight_bg.wasm"].find((path) => !existsSync(join(page, path)));
  if (missing) throw new Error(`${join(page, missing)} is missing: scripts/build-wasm builds it`);
  const entries = await readdir(page, { recursive: true, withFileTypes: true });
  const paths = entries
    .filter((entry) => entry.isFile())
    .map((entry) => pathIn(page, join(entry.parentPath, entry.name)));
  const kept = paths.filter((path) => OFFLINE.test(path) || path === LAZY || !MODULE.test(path));
  const read = kept.map(async (path) => /** @type {const} */ ([path, await readFile(join(page, path))]));
  return new Map(
    [...(await Promise.all(read)), ...(await bundles(page))].sort(([one], [other]) => (one < other ? -1 : 1)),
  );
}

/**
 * Writes what a server needs of it to a folder, whose contents are replaced.
 * @param {string} out
 */
export async function writeBundledPage(out) {
  const files = await bundledPage(SOURCES);
  await rm(out, { recursive: true, force: true });
  for (const [path, content] of files) {
    if (OFFLINE.test(path)) continue;
    await mkdir(dirname(join(out, path)), { recursive: true });
    await writeFile(join(out, path), content);
  }
}

/**
 * @param {string} page
 * @returns {Promise<[path: string, content: Buffer][]>}
 */
async function bundles(page) {
  const { outputFiles } = await build({
    absWorkingDir: page,
    entryPoints: ENTRIES,
    outdir: page,
    outbase: page,
    bundle: true,
    external: [`*/${FIRST}`, `*/${LAZY}`],
    format: "esm",
    target: "esnext",
    minify: true,
    write: false,
  });
  return outputFiles.map(({ path, contents }) => [pathIn(page, path), Buffer.from(contents)]);
}

/**
 * @param {string} folder
 * @param {string} path
 */
function pathIn(folder, path) {
  return relative(folder, path).replaceAll("\\", "/");
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  try {
    await writeBundledPage(join(ROOT, "target", "page"));
  } catch (error) {
    console.error(`error: ${/** @type {Error} */ (error).message}`);
    process.exitCode = 2;
  }
}
