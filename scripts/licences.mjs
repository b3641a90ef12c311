// Prints the licences of all that the page and the npm package are made of: node scripts/licences.mjs. With the word
// wheel also those of the Python wheel, whose widget is the page's element. scripts/build-wasm keeps the first in
// www/pkg/licences.txt, to which the sheet “About Pathlight” leads; scripts/build-widget.mjs keeps the others.
//
// The crates are those that cargo links into the wasm, and into the wheel on any platform. Texts that several have in
// common are printed once.

import { execFileSync } from "node:child_process";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const ROOT = join(dirname(fileURLToPath(import.meta.url)), "..");
/** The packages of npm that are served; their files lie beside the other tools of the build. */
const NPM = ["lean-qr", "lit-html"];

/** @typedef {{ name: string, version: string, licence: string, texts: string[] }} Part */

/** @param {string[]} words */
const cargo = (words) => execFileSync("cargo", words, { cwd: ROOT, encoding: "utf8", maxBuffer: 1e9 });

/**
 * @param {string} manifest
 * @param {string} target "all" for every platform
 * @returns {Part[]}
 */
function crates(manifest, target) {
  const tree = cargo([
    "tree",
    "--locked",
    "--manifest-path",
    manifest,
    "--target",
    target,
    "--edges",
    "normal,no-proc-macro",
    "--prefix",
    "none",
    "--format",
    "{p}",
  ]);
  // “name vVERSION”, with a mark where it is named again
  const linked = new Set(tree.split("\n").map((line) => line.split(" ").slice(0, 2).join(" ")));
  const platform = target === "all" ? [] : ["--filter-platform", target];
  const { packages } = JSON.parse(
    cargo(["metadata", "--locked", "--manifest-path", manifest, "--format-version", "1", ...platform]),
  );
  const used = packages.filter(({ name, version, source }) => source && linked.has(`${name} v${version}`));
  return used.map(({ name, version, license, manifest_path }) => ({
    name,
    version,
    licence: license,
    texts: textsIn(dirname(manifest_path), license),
  }));
}

/** @returns {Part[]} */
function npmPackages() {
  return NPM.map((name) => join(ROOT, "scripts/node_modules", name))
    .filter((folder) => existsSync(folder))
    .map((folder) => {
      const { name, version, license } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
      return { name, version, licence: license, texts: textsIn(folder, license) };
    });
}

/**
 * The texts of a package's licences; where one may choose, that of MIT, which is the shortest.
 * @param {string} folder
 * @param {string} licence
 */
function textsIn(folder, licence) {
  const files = readdirSync(folder, { withFileTypes: true })
    .filter((entry) => entry.isFile() && /^(licen[cs]e|copying|notice|copyright)/i.test(entry.name))
    .map(({ name }) => name)
    .sort();
  const chosen = / OR |\//.test(licence) ? files.filter((name) => /mit/i.test(name)) : [];
  return (chosen.length > 0 ? chosen : files).map((name) =>
    readFileSync(join(folder, name), "utf8").replaceAll("\r\n", "\n").trim(),
  );
}

const wheel = process.argv[2] === "wheel" ? crates("python/Cargo.toml", "all") : [];
const all = [...crates("Cargo.toml", "wasm32-unknown-unknown"), ...wheel, ...npmPackages()];
const parts = [...new Map(all.map((part) => [`${part.name} ${part.version}`, part])).values()].sort((one, other) =>
  one.name < other.name ? -1 : 1,
);
/** @type {Map<string, string[]>} */
const texts = new Map(
  ["NOTICE", "LICENSE"].map((file) => [readFileSync(join(ROOT, file), "utf8").trim(), ["Pathlight"]]),
);
for (const { name, texts: own } of parts) for (const text of own) texts.set(text, [...(texts.get(text) ?? []), name]);

const lines = [
  "Pathlight is under the Apache License, version 2.0. It is made with the following, each under its own licence; the texts are below.",
  "",
  ...parts.map(({ name, version, licence }) => `${name} ${version}: ${licence}`),
];
for (const [text, names] of texts) lines.push("", "=".repeat(80), `${names.join(", ")}:`, "", text);
// With the mark of UTF-8, as servers send plain text without its encoding.
console.log(`\uFEFF${lines.join("\n")}`);
