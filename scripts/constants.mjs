// Prints what the page's modules know of the wasm from their first line on, as a module: the constants that both sides
// share, the colours, and the templates. scripts/build-wasm keeps it in www/pkg/constants.js.
//
//     node scripts/constants.mjs FOLDER    of the wasm package

import { readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const folder = resolve(process.argv[2]);
const module = await import(pathToFileURL(join(folder, "pathlight.js")).href);
/** @type {typeof import("../www/pkg/pathlight.js")} */
const { constants, initSync, palette, templates } = module;

initSync({ module: readFileSync(join(folder, "pathlight_bg.wasm")) });

console.log("// Written by scripts/build-wasm. src/web/types.d.ts describes the constants.\n");
for (const [name, value] of Object.entries(constants())) {
  console.log(`/** @type {import("./pathlight.js").Constants["${name}"]} */`);
  console.log(`export const ${name.toUpperCase()} = ${JSON.stringify(value)};`);
}
for (const [name, dark] of [
  ["LIGHT", false],
  ["DARK", true],
]) {
  console.log('/** @type {import("./pathlight.js").Palette} */');
  console.log(`export const ${name}_PALETTE = ${JSON.stringify(palette(dark))};`);
}
// The ids of the 2,500 tasks, each with its template's, would be a tenth of all that the page starts with.
const packed = templates().map((template) => ({
  ...template,
  tasks: template.tasks.map((task) => task.slice(template.id.length + 1)).join(" "),
}));
console.log('/** @type {import("./pathlight.js").Template[]} */');
console.log(`export const TEMPLATES = ${JSON.stringify(packed)}.map((template) => ({
  ...template,
  tasks: template.tasks.split(" ").map((task) => template.id + ":" + task),
}));`);
