// Builds the page into target/page, with compressed copies of its files: node scripts/build-page.mjs [--watch] (needs
// www/pkg).
//
// With --watch it serves the page on PORT, rebuilds it when a file changes, and reloads it in the browser.

import { existsSync, readFileSync } from "node:fs";
import { readFile, readdir, stat } from "node:fs/promises";
import { basename, dirname, join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import { build, context } from "esbuild";
import { replaceFolder, writeFiles } from "./compress.mjs";

const ROOT = join(dirname(fileURLToPath(import.meta.url)), "..");
const SOURCES = join(ROOT, "www");
const OUT = join(ROOT, "target", "page");
const models = JSON.parse(readFileSync(join(ROOT, "assets/model.json"), "utf8"));
/** Files that are served unchanged, and their addresses. These are sources, which `make dev` watches. */
const COPIES = [
  ["www/index.html", "index.html"],
  ["www/style.css", "style.css"],
  ["www/icon.svg", "icon.svg"],
  ["www/first-look.js", "first-look.js"],
  ["www/manifest.webmanifest", "manifest.webmanifest"],
  ["www/icons", "icons"],
  ["www/exhibits/exhibits.css", "exhibits.css"],
  ["www/exhibits/learns.html", "learns.html"],
  ["www/exhibits/results.html", "results.html"],
];
/** `make play` first builds the page without the model. */
const hasModel = existsSync(join(ROOT, "www/pkg/worker"));
const BUILT = [
  ...(hasModel ? ["page", "worker"] : ["page"])
    .map((side) => `pkg/${side}/pathlight_bg.wasm`)
    .map((path) => [`www/${path}`, path]),
  ["www/pkg/licences.txt", "licences.txt"],
  ["CITATION.cff", "CITATION.cff"],
  ...["home.json", "results.json", ...models.models.map(({ file }) => file)].map((file) => [
    `assets/${file}`,
    `assets/${file}`,
  ]),
];
/** Bundled separately: no page loads two of them, and a shared chunk would be one more file to wait for. */
const ENTRIES = [
  "main.ts",
  ...(hasModel ? ["element", "model/worker", "exhibits/learns", "exhibits/learns-worker", "exhibits/results"] : []).map(
    (name) => `${name}.ts`,
  ),
];
/** Brotli's quality for large files, which load later: the best takes 40 times as long and saves 13 % of the wasm. */
const QUALITY = 5;
const RELOAD = 'new EventSource("/esbuild").addEventListener("change", () => location.reload());';

/** @typedef {Map<string, Buffer>} Files contents by path; paths use `/` */

/**
 * Returns the options of esbuild, for the page and for its tests.
 * @returns {import("esbuild").BuildOptions}
 */
export function bundling() {
  return {
    absWorkingDir: ROOT,
    bundle: true,
    format: "esm",
    target: "es2022",
    // lit-html is installed with the build tools.
    nodePaths: [join(ROOT, "scripts", "node_modules")],
    tsconfigRaw: {},
    loader: { ".css": "text" },
    // The exhibits import the npm package by its name, as any other page does.
    alias: { pathlight: join(SOURCES, "api/index.ts") },
    logLevel: "warning",
  };
}

/**
 * Returns all files of the page.
 * @returns {Promise<Files>}
 */
export async function pageFiles() {
  const files = await copied([...COPIES, ...BUILT]);
  for (const path of ENTRIES) {
    const { outputFiles } = await build({ ...entryOptions(path), write: false });
    for (const { path, contents } of outputFiles ?? []) files.set(relative(OUT, path), Buffer.from(contents));
  }
  return files;
}

/**
 * @param {string} path
 * @param {boolean} [isWatching]
 * @returns {import("esbuild").BuildOptions}
 */
function entryOptions(path, isWatching = false) {
  const isPage = path === ENTRIES[0];
  return {
    ...bundling(),
    entryPoints: [{ in: join(SOURCES, path), out: basename(path, ".ts") }],
    outdir: OUT,
    chunkNames: `chunks/${isPage ? "" : `${basename(path, ".ts")}/`}[name]-[hash]`,
    splitting: true,
    minify: !isWatching,
    sourcemap: isWatching && "inline",
    banner: isWatching && isPage ? { js: RELOAD } : {},
    plugins: isWatching && isPage ? [{ name: "copies", setup: (build) => build.onStart(copyAgain) }] : [],
  };
}

/**
 * @param {string[][]} list
 * @returns {Promise<Files>}
 */
async function copied(list) {
  const missing = list.map(([from]) => join(ROOT, from)).find((path) => !existsSync(path));
  if (missing) throw new Error(`${missing} is missing: scripts/build-wasm builds it`);
  /** @type {Files} */
  const files = new Map();
  for (const [from, to] of list) {
    const source = join(ROOT, from);
    if (!(await stat(source)).isDirectory()) files.set(to, await readFile(source));
    else for (const name of await readdir(source)) files.set(`${to}/${name}`, await readFile(join(source, name)));
  }
  return files;
}

async function copyAgain() {
  await writeFiles(OUT, await copied(COPIES), 0);
}

async function watch() {
  await replaceFolder(OUT, await copied([...COPIES, ...BUILT]), 0);
  const builds = await Promise.all(ENTRIES.map((path) => context(entryOptions(path, true))));
  await Promise.all(builds.map((one) => one.watch()));
  const { port } = await builds[0].serve({ servedir: OUT, port: Number(process.env.PORT ?? 8080), host: "127.0.0.1" });
  console.log(`http://127.0.0.1:${port}/`);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  try {
    if (process.argv.includes("--watch")) await watch();
    else await replaceFolder(OUT, await pageFiles(), QUALITY);
  } catch (error) {
    console.error(`error: ${/** @type {Error} */ (error).message}`);
    process.exitCode = 2;
  }
}
