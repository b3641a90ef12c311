// Prints what the page's modules know of the wasm from their first line on, as a module: the constants that both sides
// share, the colours, and the templates. scripts/build-wasm keeps it in www/pkg/constants.ts.
//
//     node scripts/constants.mjs FOLDER    of the wasm package

import { readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const folder = resolve(process.argv[2]);
const module = await import(pathToFileURL(join(folder, "pathlight.js")).href);
/** @type {typeof import("../www/pkg/worker/pathlight.js")} */
const { constants, initSync, palette, sceneLimits, templates } = module;

initSync({ module: readFileSync(join(folder, "pathlight_bg.wasm")) });

/** @type {(type: string, name: string, value: string) => void} */
const print = (type, name, value) => console.log(`export const ${name}: ${type} = ${value};`);

console.log("// Written by scripts/build-wasm. src/web/types.d.ts describes the constants.\n");
console.log('import type { Constants, Palette, SceneLimits, Template } from "./page/pathlight.js";\n');
for (const [name, value] of Object.entries(constants()))
  print(`Constants["${name}"]`, name.toUpperCase(), JSON.stringify(value));
print("Palette", "LIGHT_PALETTE", JSON.stringify(palette(false)));
print("Palette", "DARK_PALETTE", JSON.stringify(palette(true)));
print("SceneLimits", "SCENE_LIMITS", JSON.stringify(sceneLimits()));
// The ids of the 2,500 tasks, each with its template's, would be a tenth of all that the page starts with.
const packed = templates().map((template) => ({
  ...template,
  tasks: template.tasks.map((task) => task.slice(template.id.length + 1)).join(" "),
}));
print(
  "Template[]",
  "TEMPLATES",
  `${JSON.stringify(packed)}.map((template) => ({
  ...template,
  tasks: template.tasks.split(" ").map((task) => template.id + ":" + task),
}))`,
);
