// Builds dist-next/ from www-next, a folder for any static host: node scripts/build-dist-next.mjs (needs www-next/pkg).
//
// - Pages, manifest, icons and service-worker.js keep their addresses in all versions.
// - VERSION/ holds code, wasm and data. VERSION is a hash of the whole page, so a page that is open during an update
//   never gets files of the new version.
// - assets/ holds the weights, named by their own hashes, since most versions share them.
//
// All addresses are relative. Beside every file that compresses well are FILE.br and FILE.gz, for hosts that send
// them. The same sources give the same bytes.

import { createHash } from "node:crypto";
import { readFile, readdir } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
import { OUT as PAGE, buildPage, bundling } from "./build-page.mjs";
import { replaceFolder } from "./compress.mjs";

const ROOT = join(dirname(fileURLToPath(import.meta.url)), "..");
const VERSIONED = /\.(js|css|wasm|json|jsonl)$/;
const WEIGHTS = /^assets\/.*\.safetensors$/;
/** Reports and films that the page does not read. */
const LEFT_OUT = /\.(gif|schema\.json)$|^assets\/solutions\.jsonl$/;
const SERVICE_WORKER = "service-worker.js";
/** Stands for the version until it is known. */
const PLACEHOLDER = "VERSION";

/**
 * Builds the folder.
 * @param {{ out?: string, quality?: number, change?: (files: Map<string, Buffer>) => void }} [options] the result,
 *   whose contents are replaced; brotli's quality, 0 to compress nothing; what a test changes of the page's files
 */
export async function buildDist({ out = join(ROOT, "dist-next"), quality, change } = {}) {
  const files = await pageFiles();
  change?.(files);
  const dist = await versioned(files);
  await replaceFolder(out, dist, quality);
  return dist;
}

/** The built page, and the scripts that only dist/ has. */
async function pageFiles() {
  const builds = await buildPage(false);
  await Promise.all(builds.map(async (one) => (await one.rebuild(), one.dispose())));
  /** @type {Map<string, Buffer>} */
  const files = new Map();
  for (const entry of await readdir(PAGE, { recursive: true, withFileTypes: true })) {
    const path = join(entry.parentPath, entry.name).slice(PAGE.length + 1);
    if (entry.isFile() && !LEFT_OUT.test(path)) files.set(path, await readFile(join(PAGE, path)));
  }
  const { outputFiles } = await build({
    ...bundling(),
    entryPoints: [join(ROOT, "www-next/offline/updates.ts"), join(ROOT, "www-next/offline/service-worker.ts")],
    outdir: "/",
    minify: true,
    write: false,
  });
  for (const { path, contents } of outputFiles) files.set(path.slice(1), Buffer.from(contents));
  return files;
}

/**
 * Gives every file its place.
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
 * A file with the addresses of what it names: pages name files of their version, scripts the weights.
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
        // Relative to VERSION/assets, as names of files are, or to the script.
        .replaceAll(`"${from.slice("assets/".length)}"`, `"../../${to}"`)
        .replaceAll(`"./${from}"`, `"../${to}"`);
  return Buffer.from(text);
}

/**
 * The service worker with the list of what it keeps.
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

if (process.argv[1] === fileURLToPath(import.meta.url)) await buildDist();
