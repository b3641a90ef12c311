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
const { constants, initSync, sceneLimits, templates } = module;

initSync({ module: readFileSync(join(folder, "pathlight_bg.wasm")) });

/** @type {(name: string, value: string) => void} */
const print = (name, value) => console.log(`export const ${name} = ${value};`);

console.log("// Written by scripts/build-wasm. src/web/constants.rs describes the constants.\n");
console.log('import type { MapName, SceneLimits, Template } from "./page/pathlight.js";\n');
for (const [name, value] of Object.entries(constants()))
  print(name.toUpperCase() + (name === "maps" ? ": MapName[]" : ""), JSON.stringify(value));
print("SCENE_LIMITS: SceneLimits", JSON.stringify(sceneLimits()));
// The ids of the 2,500 tasks, each with its template's, would be a tenth of all that the page starts with.
const packed = templates().map((template) => ({
  ...template,
  tasks: template.tasks.map((task) => task.slice(template.id.length + 1)).join(" "),
}));
print(
  "TEMPLATES: Template[]",
  `${JSON.stringify(packed)}.map((template) => ({
  ...template,
  tasks: template.tasks.split(" ").map((task) => template.id + ":" + task),
}))`,
);
