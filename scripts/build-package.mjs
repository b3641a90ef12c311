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

const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const target = join(root, "target");
const stage = join(target, "package");
const read = (path) => readFileSync(join(root, path), "utf8");
const place = (from, to) => {
  mkdirSync(dirname(join(stage, to)), { recursive: true });
  copyFileSync(join(root, from), join(stage, to));
};

rmSync(stage, { recursive: true, force: true });
execFileSync(join(root, "scripts/node_modules/.bin/tsc"), ["--project", join(root, "package/tsconfig.json")], {
  stdio: "inherit",
});
const declarations = readdirSync(stage, { recursive: true, encoding: "utf8" }).filter((path) => path.endsWith(".d.ts"));
for (const path of declarations) {
  const module = path.replace(/\.d\.ts$/, ".js");
  place(join("www", module), module);
  for (const [, sheet] of read(join("www", module)).matchAll(/new URL\("([^"]+\.css)", import\.meta\.url\)/g)) {
    const path = join(dirname(module), sheet);
    place(join("www", path), path);
  }
}
for (const file of ["pathlight.js", "pathlight_bg.wasm", "licences.txt"]) place(`www/pkg/${file}`, `pkg/${file}`);
// Projects for Node alone have no types of the web; without them the declarations do not compile.
const libraries = ["dom", "esnext.disposable"].map((name) => `/// <reference lib="${name}" />\n`).join("");
writeFileSync(join(stage, "pkg/pathlight.d.ts"), libraries + read("www/pkg/pathlight.d.ts"));
// JSDoc cannot say what a tag name stands for.
appendFileSync(
  join(stage, "element/pathlight-puzzle.d.ts"),
  `declare global {
    interface HTMLElementTagNameMap {
        "pathlight-puzzle": PathlightPuzzle;
    }
}
`,
);
place("package/README.md", "README.md");
place("LICENSE", "LICENSE");
place("assets/scene.schema.json", "scene.schema.json");

const entry = JSON.parse(read("assets/model.json")).models.find(({ name }) => name === MODEL);
place(`assets/${entry.file}`, `assets/${entry.file}`);
writeFileSync(join(stage, "assets/model.json"), `${JSON.stringify({ models: [entry] }, null, 2)}\n`);

const cargo = (key) => read("Cargo.toml").match(new RegExp(`^${key} = "(.*)"$`, "m"))[1];
const { name, ...rest } = JSON.parse(read("package/package.json"));
const manifest = { name, version: cargo("version"), license: cargo("license"), ...rest };
writeFileSync(join(stage, "package.json"), `${JSON.stringify(manifest, null, 2)}\n`);

const answer = execFileSync("npm", ["pack", "--json", "--pack-destination", target], { cwd: stage, encoding: "utf8" });
const [{ filename, files, size }] = JSON.parse(answer);

const kB = (bytes) => `${(bytes / 1000).toFixed(0)} kB`;
const parts = {
  weights: /^assets\//,
  wasm: /\.wasm$/,
  declarations: /\.d\.ts$/,
  "modules and styles": /\.(js|css)$/,
  "the rest": /./,
};
const sizes = Object.fromEntries(Object.keys(parts).map((part) => [part, 0]));
for (const { path } of files) {
  const part = Object.keys(parts).find((name) => parts[name].test(path));
  sizes[part] += statSync(join(stage, path)).size;
}
console.table(Object.fromEntries(Object.entries(sizes).map(([part, bytes]) => [part, { size: kB(bytes) }])));
console.log(`target/${filename}: ${files.length} files, ${kB(size)} packed`);
