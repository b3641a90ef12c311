// Builds dist/, a folder for any static host: node scripts/build-dist.mjs (needs www/pkg).
//
// - Pages, manifest, icons and service-worker.js keep their addresses in all versions.
// - VERSION/ holds code, wasm and data. VERSION is a hash of the whole page, so a page that is open during an update
//   never gets files of the new version.
// - assets/ holds the weights, named by their hashes, because most versions share them.
//
// All addresses are relative. Every file that compresses well also has FILE.br and FILE.gz, for hosts that serve
// precompressed files. The build is reproducible.

import { createHash } from "node:crypto";
import { existsSync } from "node:fs";
import { readFile, readdir } from "node:fs/promises";
import { dirname, join, posix } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
import { bundling, pageFiles } from "./build-page.mjs";
import { isCompressible, replaceFolder } from "./compress.mjs";

const ROOT = join(dirname(fileURLToPath(import.meta.url)), "..");
const OUT = join(ROOT, "dist");
const VERSIONED = /\.(js|css|wasm|json|jsonl)$/;
const WEIGHTS = /^assets\/.*\.safetensors$/;
/** Left out: other pages get the element from the npm package. */
const ELEMENT = /^(element\.js|chunks\/element\/.*)$/;
const SERVICE_WORKER = "service-worker.js";
/** Placeholder for the version, which is a hash of all files. */
const PLACEHOLDER = "VERSION";

/**
 * Builds the folder.
 * @param {{ out?: string, quality?: number, change?: (files: Map<string, Buffer>) => void }} [options] the output
 *   folder, whose contents are replaced; the quality of brotli, 0 for no compression; a hook for tests that changes the
 *   page's files
 */
export async function buildDist({ out = OUT, quality, change } = {}) {
  if (existsSync(out) && !existsSync(join(out, SERVICE_WORKER)) && (await readdir(out)).length > 0)
    throw new Error(`${out} holds files that are not a built page: empty it, or name another folder`);
  const page = [...(await pageFiles())].filter(([path]) => !ELEMENT.test(path));
  const files = new Map([...page, ...(await offlineFiles())]);
  change?.(files);
  const dist = await versioned(files);
  await replaceFolder(out, dist, quality);
  return dist;
}

/** The scripts that exist only in dist/. */
async function offlineFiles() {
  const { outputFiles } = await build({
    ...bundling(),
    entryPoints: [join(ROOT, "www/offline/updates.ts"), join(ROOT, "www/offline/service-worker.ts")],
    outdir: "/",
    minify: true,
    write: false,
  });
  return new Map(outputFiles.map(({ path, contents }) => [path.slice(1), Buffer.from(contents)]));
}

/**
 * Returns all files by their paths in dist/.
 * @param {Map<string, Buffer>} files
 */
async function versioned(files) {
  /** @type {Map<string, string>} */
  const places = new Map();
  for (const [path, content] of files) {
    if (WEIGHTS.test(path)) places.set(path, path.replace(/(?=\.\w+$)/, `-${hash(content)}`));
    else places.set(path, VERSIONED.test(path) && path !== SERVICE_WORKER ? `${PLACEHOLDER}/${path}` : path);
  }
  /** @type {Map<string, Buffer>} */
  const placed = new Map();
  for (const [path, content] of files) placed.set(places.get(path) ?? path, addressed(path, content, places));
  const parts = [...placed].map(([path, content]) => `${path} ${hash(content)}\n`).sort();
  const version = hash(parts.join(""));
  /** @type {Map<string, Buffer>} */
  const dist = new Map();
  for (const [path, content] of placed)
    dist.set(
      path.replace(`${PLACEHOLDER}/`, `${version}/`),
      path.endsWith(".html") ? Buffer.from(content.toString().replaceAll(`${PLACEHOLDER}/`, `${version}/`)) : content,
    );
  dist.set(SERVICE_WORKER, workerOf(version, dist));
  return new Map([...dist].sort(([one], [other]) => (one < other ? -1 : 1)));
}

/**
 * Rewrites the addresses in a file: pages refer to files of their version, scripts refer to the weights.
 * @param {string} path
 * @param {Buffer} content
 * @param {Map<string, string>} places
 */
function addressed(path, content, places) {
  if (path.endsWith(".html")) {
    const html = content
      .toString()
      .replace(/\b(href|src)="([^"#]+)/g, (all, name, file) =>
        places.has(file) ? `${name}="${places.get(file)}` : all,
      );
    const updates = `<script type="module" src="${PLACEHOLDER}/updates.js" fetchpriority="low"></script>\n</head>`;
    return Buffer.from(path === "index.html" ? html.replace("</head>", updates) : html);
  }
  if (!path.endsWith(".js")) return content;
  let text = content.toString();
  for (const [from, to] of places)
    if (WEIGHTS.test(from))
      text = text
        // Names of files are relative to VERSION/assets, addresses with ./ to the script.
        .replaceAll(`"${from.slice("assets/".length)}"`, `"../../${to}"`)
        .replaceAll(`"./${from}"`, `"../${to}"`);
  return Buffer.from(text);
}

/**
 * Returns the service worker with the list of files that it caches.
 * @param {string} version
 * @param {Map<string, Buffer>} dist
 */
function workerOf(version, dist) {
  const kept = [...dist]
    .filter(([path]) => path !== SERVICE_WORKER)
    .map(([path, content]) => [
      path === "index.html" ? "./" : path,
      `sha256-${createHash("sha256").update(content).digest("base64")}`,
    ]);
  const list = `const PRECACHE = ${JSON.stringify({ version, files: kept.sort() })};\n`;
  return Buffer.from(list + dist.get(SERVICE_WORKER));
}

/** @param {string | Buffer} content */
function hash(content) {
  return createHash("sha256").update(content).digest("hex").slice(0, 12);
}

/**
 * Prints the download sizes of a built folder by part.
 * @param {string} out
 * @param {Map<string, Buffer>} files
 */
async function printSizes(out, files) {
  /** @type {(path: string) => string} */
  const partOf = (path) =>
    path.endsWith(".wasm") ? "wasm" : path.endsWith(".safetensors") ? `weights ${posix.basename(path)}` : "page";
  /** @type {Map<string, { files: number, raw: number, gz: number, br: number }>} */
  const parts = new Map();
  for (const [path, content] of files) {
    const sizeOf = async (/** @type {string} */ suffix) =>
      isCompressible(path) ? (await readFile(join(out, path + suffix))).length : content.length;
    const [gz, br] = [await sizeOf(".gz"), await sizeOf(".br")];
    for (const part of [partOf(path), "all"]) {
      const sum = parts.get(part) ?? { files: 0, raw: 0, gz: 0, br: 0 };
      parts.set(part, { files: sum.files + 1, raw: sum.raw + content.length, gz: sum.gz + gz, br: sum.br + br });
    }
  }
  const rows = [...parts].sort(([one], [other]) => Number(one === "all") - Number(other === "all"));
  const width = Math.max(...rows.map(([part]) => part.length));
  const line = (/** @type {string} */ part, /** @type {(string | number)[]} */ cells) =>
    console.log(part.padEnd(width) + cells.map((cell) => cell.toLocaleString("en").padStart(12)).join(""));
  line("bytes", ["files", "raw", "gz", "br"]);
  for (const [part, sizes] of rows) line(part, Object.values(sizes));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  try {
    await printSizes(OUT, await buildDist());
  } catch (error) {
    console.error(`error: ${/** @type {Error} */ (error).message}`);
    process.exitCode = 2;
  }
}
