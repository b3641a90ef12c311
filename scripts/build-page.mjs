// Builds the page from www-next into target/page-next: node scripts/build-page.mjs [--watch] (needs www-next/pkg).
//
// With --watch it serves the page on PORT, builds it again when a file changes, and loads it again in the browser.

import { cp, mkdir, rm } from "node:fs/promises";
import { existsSync } from "node:fs";
import { basename, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { context } from "esbuild";

const ROOT = join(dirname(fileURLToPath(import.meta.url)), "..");
const SOURCES = join(ROOT, "www-next");
export const OUT = join(ROOT, "target", "page-next");
/** What is served as it is, and where. */
const COPIES = [
  ["www-next/index.html", "index.html"],
  ["www-next/style.css", "style.css"],
  ["www-next/icon.svg", "icon.svg"],
  ["www-next/first-look.js", "first-look.js"],
  ["www-next/manifest.webmanifest", "manifest.webmanifest"],
  ["www-next/icons", "icons"],
  ["www-next/exhibits/exhibits.css", "exhibits.css"],
  ["www-next/exhibits/learns.html", "learns.html"],
  ["www-next/exhibits/results.html", "results.html"],
  ["www-next/pkg/page/pathlight_bg.wasm", "pkg/page/pathlight_bg.wasm"],
  ["www-next/pkg/worker/pathlight_bg.wasm", "pkg/worker/pathlight_bg.wasm"],
  ["www-next/pkg/worker/licences.txt", "licences.txt"],
  ["CITATION.cff", "CITATION.cff"],
  ["assets", "assets"],
];
/** Bundled one by one: no page loads two of them, and parts in common would be a further file to wait for. */
const ENTRIES = [
  "main.ts",
  "element.ts",
  "model/worker.ts",
  ...["learns.ts", "learns-worker.ts", "results.ts"].map((name) => `exhibits/${name}`),
];
const RELOAD = 'new EventSource("/esbuild").addEventListener("change", () => location.reload());';

/**
 * What esbuild is told; the tests are bundled alike.
 * @returns {import("esbuild").BuildOptions}
 */
export function bundling() {
  return {
    absWorkingDir: ROOT,
    bundle: true,
    format: "esm",
    target: "es2022",
    // lit-html is installed beside the tools.
    nodePaths: [join(ROOT, "scripts", "node_modules")],
    tsconfigRaw: {},
    loader: { ".css": "text" },
    // The exhibits import the package by its name, as other pages do.
    alias: { pathlight: join(SOURCES, "api/index.ts") },
    logLevel: "warning",
  };
}

/**
 * @param {boolean} isWatching
 */
export async function buildPage(isWatching) {
  const missing = COPIES.map(([from]) => join(ROOT, from)).find((path) => !existsSync(path));
  if (missing) throw new Error(`${missing} is missing: scripts/build-wasm builds it`);
  await rm(OUT, { recursive: true, force: true });
  await mkdir(OUT, { recursive: true });
  for (const [from, to] of COPIES) await cp(join(ROOT, from), join(OUT, to), { recursive: true });
  return Promise.all(ENTRIES.map((path) => context(entryOptions(path, isWatching))));
}

/**
 * @param {string} path
 * @param {boolean} isWatching
 * @returns {import("esbuild").BuildOptions}
 */
function entryOptions(path, isWatching) {
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

async function copyAgain() {
  for (const [from, to] of COPIES.slice(0, 9)) await cp(join(ROOT, from), join(OUT, to), { recursive: true });
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const isWatching = process.argv.includes("--watch");
  try {
    const builds = await buildPage(isWatching);
    await Promise.all(builds.map((build) => build.rebuild()));
    if (isWatching) {
      await Promise.all(builds.map((build) => build.watch()));
      const { port } = await builds[0].serve({
        servedir: OUT,
        port: Number(process.env.PORT ?? 8080),
        host: "127.0.0.1",
      });
      console.log(`http://127.0.0.1:${port}/`);
    } else {
      await Promise.all(builds.map((build) => build.dispose()));
    }
  } catch (error) {
    console.error(`error: ${/** @type {Error} */ (error).message}`);
    process.exitCode = 2;
  }
}
