// Prints the licences of everything in the page and the npm package: node scripts/licences.mjs. With the argument
// wheel, it also prints those of the Python wheel, whose widget is the page's element. scripts/build-wasm writes the
// first list to www/pkg/licences.txt, which the dialog “About Pathlight” links to; scripts/build-widget.mjs writes the
// second.
//
// The crates are those that cargo links into the wasm, and into the wheel on any platform. Texts shared by several
// parts are printed once.

import { execFileSync } from "node:child_process";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const ROOT = join(dirname(fileURLToPath(import.meta.url)), "..");
/** The npm packages that become part of the page; they are installed with the build tools. */
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
  // Lines are “name vVERSION”, with a mark on repetitions.
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
 * Returns the texts of a package's licences. If there is a choice that includes MIT, returns only MIT, the shortest.
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
  "Pathlight is licensed under the Apache License, version 2.0. It includes the following parts, each under its own licence. The texts are below.",
  "",
  ...parts.map(({ name, version, licence }) => `${name} ${version}: ${licence}`),
];
for (const [text, names] of texts) lines.push("", "=".repeat(80), `${names.join(", ")}:`, "", text);
// With a byte order mark, because servers send plain text without its encoding.
console.log(`\uFEFF${lines.join("\n")}`);
