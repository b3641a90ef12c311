// An empty project in which the packed package is installed, as others install it; every test of the package begins
// with it. `make package` packs it.

import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

export const root = join(dirname(fileURLToPath(import.meta.url)), "..", "..");

const version = /^version = "(.*)"$/m.exec(readFileSync(join(root, "Cargo.toml"), "utf8"))?.[1];
const packed = join(root, "target", `pathlight-${version}.tgz`);

/** Makes a project and installs the package in it, without a registry. Returns its folder. */
export function makeProject() {
  if (!existsSync(packed)) throw new Error(`${packed} is missing: run make package`);
  const folder = mkdtempSync(join(tmpdir(), "pathlight-package-"));
  process.once("exit", () => rmSync(folder, { recursive: true, force: true }));
  writeFileSync(join(folder, "package.json"), '{ "name": "project", "private": true, "type": "module" }');
  execFileSync("npm", ["install", "--offline", "--no-audit", "--no-fund", "--loglevel=error", packed], { cwd: folder });
  return folder;
}

/**
 * Returns the module that a script gets of the package in a project.
 * @param {string} project
 */
export const entryOf = (project) => join(project, "node_modules/pathlight/pathlight.js");

/**
 * Returns an example of the installed package.
 * @param {string} project
 * @param {string} file
 */
export const example = (project, file) => readFileSync(join(project, "node_modules/pathlight/examples", file), "utf8");

/**
 * Returns the first piece of code of the installed README in a language.
 * @param {string} project
 * @param {string} language
 */
export function readmeCode(project, language) {
  const readme = readFileSync(join(project, "node_modules/pathlight/README.md"), "utf8");
  return new RegExp(`^\`\`\`${language}\n(.*?)^\`\`\``, "ms").exec(readme)?.[1] ?? "";
}
