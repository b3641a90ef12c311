// Prints a module with the values that the page needs before the wasm is loaded: the constants that both sides share,
// the colours, and the templates. scripts/build-wasm writes it to www/pkg/constants.ts.
//
//     node scripts/constants.mjs FOLDER    the folder of the wasm package

import { readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const folder = resolve(process.argv[2]);
const module = await import(pathToFileURL(join(folder, "pathlight.js")).href);
/** @type {typeof import("../www/pkg/page/pathlight.js")} */
const { constants, fold, initSync, sceneLimits, templates } = module;

initSync({ module: readFileSync(join(folder, "pathlight_bg.wasm")) });

/** @type {(name: string, value: string) => void} */
const print = (name, value) => console.log(`export const ${name} = ${value};`);

console.log("// Written by scripts/build-wasm. src/web/constants.rs describes the constants.\n");
console.log('import type { MapName, SceneLimits, Setup, Template } from "./page/pathlight.js";\n');
for (const [name, value] of Object.entries(constants()))
  print(name.toUpperCase() + (name === "maps" ? ": MapName[]" : ""), JSON.stringify(value));
print("SCENE_LIMITS: SceneLimits", JSON.stringify(sceneLimits()));
// The tasks that are new to the model of a setup, as one bit per task, four in each hexadecimal digit. Computing them
// takes too long for the page.
const { models } = JSON.parse(readFileSync(new URL("../assets/model.json", import.meta.url), "utf8"));
const tasks = templates().flatMap((template) => template.tasks);
const unseen = models.map(({ name }) => {
  const [setup, number] = name.split("-");
  const test = new Set(fold(setup, Number(number)).test);
  const digits = Array(Math.ceil(tasks.length / 4)).fill(0);
  tasks.forEach((task, index) => (digits[index >> 2] |= Number(test.has(task)) << (index & 3)));
  return [setup, digits.map((digit) => digit.toString(16)).join("")];
});
print("UNSEEN: Record<Setup, string>", JSON.stringify(Object.fromEntries(unseen)));
// Without the template's id, because the full ids of the 2,500 tasks would be a tenth of the page's first download.
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
