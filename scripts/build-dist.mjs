// Builds dist/, a folder for any static host: node scripts/build-dist.mjs (needs www/pkg; `make dist` builds that
// first).
//
// - index.html, manifest.webmanifest, icon.svg, icons/ and service-worker.js keep their addresses in all versions.
// - VERSION/ holds the bundled code, the wasm and the list of models. VERSION is a hash of the whole page, so a page
//   that is open during an update never gets files of the new version.
// - assets/ holds the weights, named by their own hashes, since most versions share them.
//
// All addresses are relative. Beside every file that compresses well are FILE.br and FILE.gz, for hosts that send
// them. The same sources give the same bytes.

import { createHash } from "node:crypto";
import { existsSync } from "node:fs";
import { readFile, readdir } from "node:fs/promises";
import { dirname, extname, join, posix } from "node:path";
import { fileURLToPath } from "node:url";
import { SOURCES, bundledPage } from "./bundle-page.mjs";
import { isCompressible, replaceFolder } from "./compress.mjs";

const ROOT = join(dirname(fileURLToPath(import.meta.url)), "..");
const SERVICE_WORKER = "offline/service-worker.js";
/** Beside index.html; everything else belongs to a version. */
const UNVERSIONED = /^(manifest\.webmanifest|icon\.svg|icons\/.*\.png)$/;
/** What the page reads of the assets when somebody asks for it. */
const LAZY_ASSETS = ["home.json", "results.json", "attempts.jsonl"];
const VERSIONED = /\.(js|css|wasm|txt)$/;
/** Stands for the version until it is known. */
const PLACEHOLDER = "VERSION";

/** @typedef {import("./bundle-page.mjs").Files} Files */

/**
 * Builds the folder and returns its files without the compressed ones.
 * @param {{ page?: string, assets?: string, out?: string, quality?: number }} [options] folders of the page, of the
 *     weights and of the result, whose contents are replaced; brotli's quality, by default the best, 0 to compress
 *     nothing
 */
export async function buildDist({
  page = SOURCES,
  assets = join(ROOT, "assets"),
  out = join(ROOT, "dist"),
  quality,
} = {}) {
  if (existsSync(out) && !existsSync(join(out, "service-worker.js")) && (await readdir(out)).length > 0) {
    throw new Error(`${out} holds files that are not a built page: empty it, or name another folder`);
  }
  const files = await distFiles(page, assets);
  await replaceFolder(out, files, quality);
  return files;
}

/**
 * @param {string} page
 * @param {string} assets
 * @returns {Promise<Files>}
 */
async function distFiles(page, assets) {
  const sources = await bundledPage(page);
  const { list, weights } = await modelFiles(assets);
  const unversioned = pick(sources, (path) => UNVERSIONED.test(path));
  const versioned = pick(sources, (path) => VERSIONED.test(path) && path !== SERVICE_WORKER).set(
    "assets/model.json",
    list,
  );
  for (const path of LAZY_ASSETS.filter((one) => existsSync(join(assets, one))))
    versioned.set(`assets/${path}`, await readFile(join(assets, path)));
  const index = indexOf(contentOf(sources, "index.html").toString(), versioned);
  const worker = contentOf(sources, SERVICE_WORKER).toString();

  const everything = [...versioned, ...unversioned, ...weights, ["index.html", index], [SERVICE_WORKER, worker]];
  const version = hash(everything.map(([path, content]) => `${path} ${hash(content)}\n`).join(""));
  /** @type {Files} */
  const files = new Map([
    ...unversioned,
    ["index.html", Buffer.from(index.replaceAll(`${PLACEHOLDER}/`, `${version}/`))],
  ]);
  for (const [path, content] of versioned) files.set(`${version}/${path}`, content);
  for (const [path, content] of weights) files.set(path, content);
  files.set("service-worker.js", Buffer.from(workerOf(worker, version, files)));
  return new Map([...files].sort(([one], [other]) => (one < other ? -1 : 1)));
}

/**
 * The weights, named by their hash, and the list that names them so.
 * @param {string} assets
 */
async function modelFiles(assets) {
  const { models } = JSON.parse(await readFile(join(assets, "model.json"), "utf8"));
  /** @type {Files} */
  const weights = new Map();
  for (const model of models) {
    const content = await readFile(join(assets, model.file));
    const sha256 = createHash("sha256").update(content).digest("hex");
    if (sha256 !== model.sha256)
      throw new Error(
        `${join(assets, model.file)} is not the file that model.json names: write both again by ` +
          "`pathlight-lab publish weights`",
      );
    const path = `assets/${model.name}-${hash(content)}${extname(model.file)}`;
    weights.set(path, content);
    // The list stands in VERSION/assets.
    model.file = posix.relative(`${PLACEHOLDER}/assets`, path);
  }
  return { list: Buffer.from(`${JSON.stringify({ models }, null, 2)}\n`), weights };
}

/**
 * index.html with addresses into the folder of its version, and with the script that starts the service worker.
 * @param {string} html
 * @param {Files} versioned
 */
function indexOf(html, versioned) {
  const addressed = html.replace(/\b(href|src)="([^"#]+)/g, (all, name, path) =>
    versioned.has(path) ? `${name}="${PLACEHOLDER}/${path}` : all,
  );
  return addressed.replace(
    "</head>",
    `<script type="module" src="${PLACEHOLDER}/offline/updates.js" fetchpriority="low"></script>\n</head>`,
  );
}

/**
 * The service worker with the list of what it keeps.
 * @param {string} source
 * @param {string} version
 * @param {Files} files
 */
function workerOf(source, version, files) {
  const kept = [...files].map(([path, content]) => [
    path === "index.html" ? "./" : path,
    `sha256-${createHash("sha256").update(content).digest("base64")}`,
  ]);
  const line = /^const PRECACHE = .*$/m;
  if (!line.test(source))
    throw new Error(`${SERVICE_WORKER} has no line for the list of files, \`const PRECACHE = …\``);
  return source.replace(line, () => `const PRECACHE = ${JSON.stringify({ version, files: kept.sort() })};`);
}

/**
 * @param {Files} files
 * @param {(path: string) => boolean} isPicked
 * @returns {Files}
 */
function pick(files, isPicked) {
  return new Map([...files].filter(([path]) => isPicked(path)));
}

/**
 * @param {Files} files
 * @param {string} path
 */
function contentOf(files, path) {
  const content = files.get(path);
  if (!content) throw new Error(`the page has no ${path}`);
  return content;
}

/** @param {string | Buffer} content */
function hash(content) {
  return createHash("sha256").update(content).digest("hex").slice(0, 12);
}

/**
 * Prints the sizes of a built folder by part, as a browser downloads them.
 * @param {string} out
 * @param {Files} files
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
  const out = join(ROOT, "dist");
  try {
    await printSizes(out, await buildDist({ out }));
  } catch (error) {
    console.error(`error: ${/** @type {Error} */ (error).message}`);
    process.exitCode = 2;
  }
}
