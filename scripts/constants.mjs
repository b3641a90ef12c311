// Prints what the page's modules know of the wasm from their first line on, as a module: the constants that both sides
// share, and the templates. scripts/build-wasm keeps it in www/pkg/constants.js.

import { readFileSync } from "node:fs";
import { constants, initSync, templates } from "../www/pkg/pathlight.js";

initSync({ module: readFileSync(new URL("../www/pkg/pathlight_bg.wasm", import.meta.url)) });

console.log("// Written by scripts/build-wasm. src/web/types.d.ts describes the constants.\n");
for (const [name, value] of Object.entries(constants())) {
  console.log(`/** @type {import("./pathlight.js").Constants["${name}"]} */`);
  console.log(`export const ${name.toUpperCase()} = ${JSON.stringify(value)};`);
}
console.log('/** @type {import("./pathlight.js").Template[]} */');
console.log(`export const TEMPLATES = ${JSON.stringify(templates())};`);
