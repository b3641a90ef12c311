// Bundles the page: node scripts/bundle-page.mjs writes target/page, which `make play` serves (needs www/pkg). Beside
// the files are their compressed forms.
//
// A browser spends some 8 ms on every file that it asks for, so that fifty modules would hold up the first puzzle for
// longer than all the rest. The bundle of an entry takes the entry's own place, and the addresses in it, which are
// relative to a folder beside that of the module ("../pkg/…"), lead where they led before. The sources work without it.

import { existsSync } from "node:fs";
import { readFile, readdir } from "node:fs/promises";
import { dirname, join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
import { replaceFolder } from "./compress.mjs";

const ROOT = join(dirname(fileURLToPath(import.meta.url)), "..");
export const SOURCES = join(ROOT, "www");
const ASSETS = join(ROOT, "assets");
/** What compiles the wasm while the rest is read. */
const FIRST = "loading/compile-wasm.js";
/** The words of another language, for those who read it. */
const WORDS = "text/de/index.js";
/** With them, what the page starts with, and what its worker does. */
const ENTRIES = ["loading/first-look.js", FIRST, "page/main.js", "model/worker.js", WORDS];
/** What a page of dist/ has besides. */
const OFFLINE = /^offline\//;
const MODULE = /\.(js|d\.ts)$/;
/** What the page loads only when it is asked for, as it is. */
const LAZY = "pkg/lean-qr.js";
/** Brotli's for a page that is served from here: the best takes 40 times as long, and saves 13 % of the wasm. */
const QUALITY = 5;
/** Written anew beside the files that are served. */
const COMPRESSED = /\.(br|gz)$/;

/** @typedef {Map<string, Buffer>} Files contents by path, with `/` */

/**
 * Returns all files of the page, sorted by path, with its modules bundled.
 * @param {string} page the folder of the sources
 * @returns {Promise<Files>}
 */
export async function bundledPage(page) {
  const missing = ["pkg/pathlight.js", "pkg/pathlight_bg.wasm"].find((path) => !existsSync(join(page, path)));
  if (missing) throw new Error(`${join(page, missing)} is missing: scripts/build-wasm builds it`);
  const files = await filesIn(
    page,
    (path) => (OFFLINE.test(path) || path === LAZY || !MODULE.test(path)) && !COMPRESSED.test(path),
  );
  return new Map([...files, ...(await bundles(page))].sort(([one], [other]) => (one < other ? -1 : 1)));
}

/**
 * Writes what a server needs of it, with the assets and all compressed forms, to a folder, whose contents are replaced.
 * @param {string} out
 */
export async function writeBundledPage(out) {
  const page = [...(await bundledPage(SOURCES))].filter(([path]) => !OFFLINE.test(path));
  /** @type {Files} */
  const files = new Map(page);
  for (const [path, content] of await filesIn(ASSETS)) files.set(`assets/${path}`, content);
  await replaceFolder(out, files, QUALITY);
}

/**
 * Reads the files below a folder.
 * @param {string} folder
 * @param {(path: string) => boolean} [isRead]
 */
async function filesIn(folder, isRead = () => true) {
  const entries = await readdir(folder, { recursive: true, withFileTypes: true });
  const paths = entries
    .filter((entry) => entry.isFile())
    .map((entry) => pathIn(folder, join(entry.parentPath, entry.name)));
  const read = paths.filter(isRead).map(async (path) => {
    return /** @type {[path: string, content: Buffer]} */ ([path, await readFile(join(folder, path))]);
  });
  return Promise.all(read);
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
    external: [FIRST, LAZY, WORDS].map((path) => `*/${path}`),
    format: "esm",
    target: "esnext",
    minify: true,
    // Not the project's, whose strictness esbuild would write into each module, which is strict anyway.
    tsconfigRaw: {},
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
