// Packs target/pathlight-VERSION.tgz, the npm package. It holds the API for scripts and the element, each as one
// bundle, the worker, the declarations that tsc writes, the wasm, one model and the README of package/. Prints the
// sizes by part.

import { execFileSync } from "node:child_process";
import { appendFileSync, copyFileSync, mkdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
import { bundling } from "./build-page.mjs";

/** The model in the package. */
const MODEL = "within-0";
/** The examples that use the package. */
const EXAMPLES = ["auccess.mjs", "page.html", "imagine.html", "puzzle.tsx"];

const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const sources = join(root, "www");
const target = join(root, "target");
const stage = join(target, "package");
const declarations = join(target, "package-types");
const read = (path) => readFileSync(join(root, path), "utf8");
const write = (path, text) => {
  mkdirSync(dirname(join(stage, path)), { recursive: true });
  writeFileSync(join(stage, path), text);
};
const place = (from, to) => {
  mkdirSync(dirname(join(stage, to)), { recursive: true });
  copyFileSync(join(root, from), join(stage, to));
};
const entry = JSON.parse(read("assets/model.json")).models.find(({ name }) => name === MODEL);

/**
 * The differences between the package and the page. The package has one model. Its glue code stays next to the wasm,
 * where bundlers look for it, except in the worker, which bundlers copy unchanged.
 */
const packaging = {
  name: "packaging",
  setup({ onLoad, onResolve }) {
    onLoad({ filter: /model\.json$/ }, () => ({ contents: JSON.stringify({ models: [entry] }), loader: "json" }));
    onResolve({ filter: /pkg\/\w+\/pathlight\.js$/ }, ({ path, importer }) =>
      importer.endsWith("worker.ts") ? null : { path: `./${path.replace(/^[./]+/, "")}`, external: true },
    );
    onLoad({ filter: /pkg\/\w+\/pathlight\.js$/ }, ({ path }) => ({
      contents: readFileSync(path, "utf8").replace("new URL('pathlight_bg.wasm', import.meta.url)", "undefined"),
    }));
  },
};

for (const folder of [stage, declarations]) rmSync(folder, { recursive: true, force: true });
for (const [path, name] of [
  ["api/index.ts", "pathlight"],
  ["element.ts", "element"],
  ["model/worker.ts", "worker"],
]) {
  await build({
    ...bundling(),
    entryPoints: [{ in: join(sources, path), out: name }],
    outdir: stage,
    chunkNames: "chunks/[name]-[hash]",
    splitting: true,
    // The API for scripts stays readable, for debugging.
    minify: name !== "pathlight",
    plugins: [packaging],
  });
}

execFileSync(
  join(root, "scripts/node_modules/.bin/tsc"),
  [
    ...["--project", sources, "--noEmit", "false", "--declaration", "--emitDeclarationOnly"],
    ...["--rootDir", root, "--outDir", declarations],
  ],
  { stdio: "inherit" },
);
/** Copies the declarations of a module and of its imports. */
function declare(path, placed = new Set()) {
  if (placed.has(path)) return;
  placed.add(path);
  if (path.startsWith("pkg/")) return placeWasmTypes(path);
  const text = readFileSync(join(declarations, "www", path), "utf8");
  for (const [, name] of text.matchAll(/(?:from |import\()"(\.[^"]+)"/g))
    declare(join(dirname(path), name).replace(/(\.ts|\.js)?$/, ".d.ts"), placed);
  // tsc imports inferred types without a file extension, which Node's resolution requires.
  write(path, text.replaceAll(/((?:from |import\()"\.[^"]+?)(\.ts|\.js)?"/g, '$1.js"'));
}
/** Adds the types of the web, without which the declarations do not compile in projects for Node. */
function placeWasmTypes(path) {
  const libraries = ["dom", "esnext.disposable"].map((name) => `/// <reference lib="${name}" />\n`).join("");
  write(path, libraries + read(`www/${path}`));
}
declare("api/index.d.ts");
declare("element.d.ts");
appendFileSync(join(stage, "element.d.ts"), read("package/react.d.ts"));

for (const side of ["page", "worker"])
  for (const file of ["pathlight.js", "pathlight_bg.wasm"]) place(`www/pkg/${side}/${file}`, `pkg/${side}/${file}`);
// Before version 8, Vite's development server moves the .js modules of packages into another folder, where their
// relative addresses are broken. It leaves .jsx modules in place. Parcel finds these files by their names.
write("pathlight.jsx", 'export * from "./pathlight.js";\n');
write("element.jsx", 'export * from "./element.js";\n');
// On a server that renders pages, the element is only a tag; the browser turns it into a puzzle.
write("element-in-node.js", "export {};\n");
write("README.md", read("package/README.md").replaceAll("](../examples/", "](examples/"));
for (const file of EXAMPLES) place(`examples/${file}`, `examples/${file}`);
for (const file of ["LICENSE", "NOTICE"]) place(file, file);
place("www/pkg/licences.txt", "licences.txt");
place("assets/scene.schema.json", "scene.schema.json");
for (const file of [entry.file, "attempts.jsonl"]) place(`assets/${file}`, `assets/${file}`);

const cargo = (key) => read("Cargo.toml").match(new RegExp(`^${key} = "(.*)"$`, "m"))[1];
const { name, ...rest } = JSON.parse(read("package/package.json"));
// npm records where a package was built (provenance) only if its manifest names that repository.
const repository = process.env.REPOSITORY && { type: "git", url: `git+${process.env.REPOSITORY}.git` };
const manifest = { name, version: cargo("version"), license: cargo("license"), ...rest, repository };
write("package.json", `${JSON.stringify(manifest, null, 2)}\n`);

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
