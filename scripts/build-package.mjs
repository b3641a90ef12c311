// Packs target/pathlight-VERSION.tgz, the npm package: the modules that scripts and other pages use, their
// declarations, the wasm as scripts/build-wasm made it, one model, and the README of package/. Prints the sizes by
// part.

import { execFileSync } from "node:child_process";
import {
  appendFileSync,
  copyFileSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  rmSync,
  statSync,
  writeFileSync,
} from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

/** The model inside. */
const MODEL = "within-0";

/** The examples that use the package. */
const EXAMPLES = ["auccess.mjs", "page.html", "imagine.html", "puzzle.tsx"];

const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const target = join(root, "target");
const stage = join(target, "package");
const read = (path) => readFileSync(join(root, path), "utf8");
const place = (from, to) => {
  mkdirSync(dirname(join(stage, to)), { recursive: true });
  copyFileSync(join(root, from), join(stage, to));
};
const entry = JSON.parse(read("assets/model.json")).models.find(({ name }) => name === MODEL);
const sheets = [...read("www/element/style-sheets.js").matchAll(/new URL\("\.\.\/([^"]+\.css)"/g)];

/**
 * Modules that are others in the package. Bundlers find a file only by a literal address; and small files, which Vite
 * makes data: addresses of, must not be fetched, because the policy of a page may forbid that.
 */
const OWN_MODULES = {
  "api/model-files.js": `// The model of this package.

const MODELS = [${JSON.stringify(entry)}];

export const readModelList = async () => MODELS;

export const weightsAddress = () => new URL("../assets/${entry.file}", import.meta.url);
`,
  "element/style-sheets.js": `// The style sheets of a puzzle; all puzzles of a page adopt the same ones.

const TEXTS = ${JSON.stringify(
    sheets.map(([, path]) => read(join("www", path))),
    null,
    2,
  )};

/** @type {Promise<CSSStyleSheet[]> | null} */
let loaded = null;

export const loadStyleSheets = () =>
  (loaded ??= Promise.all(TEXTS.map((text) => new CSSStyleSheet().replace(text))));
`,
};

/**
 * What a bundler gets of the package, and Node of the element. Before version 8, Vite's development server packs
 * modules of packages into a folder of its own, where their addresses lead nowhere; those that are not called .js it
 * leaves where they are. And Parcel finds these files by their names, without `exports`.
 */
const ENTRY_MODULES = {
  "pathlight.jsx": 'export * from "./api/index.js";\n',
  "element.jsx": 'export * from "./element/pathlight-puzzle.js";\n',
  // Where a server renders a page, the element is a tag; the browser makes a puzzle of it.
  "element-in-node.js": "export {};\n",
};

rmSync(stage, { recursive: true, force: true });
execFileSync(join(root, "scripts/node_modules/.bin/tsc"), ["--project", join(root, "package/tsconfig.json")], {
  stdio: "inherit",
});
const declarations = readdirSync(stage, { recursive: true, encoding: "utf8" }).filter((path) => path.endsWith(".d.ts"));
for (const path of declarations) {
  const module = path.replace(/\.d\.ts$/, ".js");
  if (!(module in OWN_MODULES)) place(join("www", module), module);
}
for (const [path, code] of Object.entries({ ...OWN_MODULES, ...ENTRY_MODULES })) writeFileSync(join(stage, path), code);
for (const file of ["pathlight.js", "pathlight_bg.wasm", "licences.txt"]) place(`www/pkg/${file}`, `pkg/${file}`);
// Projects for Node alone have no types of the web; without them the declarations do not compile.
const libraries = ["dom", "esnext.disposable"].map((name) => `/// <reference lib="${name}" />\n`).join("");
writeFileSync(join(stage, "pkg/pathlight.d.ts"), libraries + read("www/pkg/pathlight.d.ts"));
appendFileSync(join(stage, "element/pathlight-puzzle.d.ts"), read("package/element.d.ts"));
writeFileSync(join(stage, "README.md"), read("package/README.md").replaceAll("](../examples/", "](examples/"));
for (const file of EXAMPLES) place(`examples/${file}`, `examples/${file}`);
for (const file of ["LICENSE", "NOTICE"]) place(file, file);
place("assets/scene.schema.json", "scene.schema.json");
for (const file of [entry.file, "attempts.jsonl"]) place(`assets/${file}`, `assets/${file}`);

const cargo = (key) => read("Cargo.toml").match(new RegExp(`^${key} = "(.*)"$`, "m"))[1];
const { name, ...rest } = JSON.parse(read("package/package.json"));
// npm states where a package was built (provenance) only if its manifest names that repository.
const repository = process.env.REPOSITORY && { type: "git", url: `git+${process.env.REPOSITORY}.git` };
const manifest = { name, version: cargo("version"), license: cargo("license"), ...rest, repository };
writeFileSync(join(stage, "package.json"), `${JSON.stringify(manifest, null, 2)}\n`);

const answer = execFileSync("npm", ["pack", "--json", "--pack-destination", target], { cwd: stage, encoding: "utf8" });
const [{ filename, files, size }] = JSON.parse(answer);

const kB = (bytes) => `${(bytes / 1000).toFixed(0)} kB`;
const parts = { weights: /^assets\//, wasm: /\.wasm$/, declarations: /\.d\.ts$/, modules: /\.jsx?$/, "the rest": /./ };
const sizes = Object.fromEntries(Object.keys(parts).map((part) => [part, 0]));
for (const { path } of files) {
  const part = Object.keys(parts).find((name) => parts[name].test(path));
  sizes[part] += statSync(join(stage, path)).size;
}
console.table(Object.fromEntries(Object.entries(sizes).map(([part, bytes]) => [part, { size: kB(bytes) }])));
console.log(`target/${filename}: ${files.length} files, ${kB(size)} packed`);
