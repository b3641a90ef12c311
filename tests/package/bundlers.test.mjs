// The installed package as bundlers take it: each builds one page out of the package's examples, in which puzzles are
// played and a picture is drawn, under a policy that allows nothing but the page's own files.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { startOn } from "../browser/harness.mjs";
import { serveStatic } from "../browser/static-server.mjs";
import { drawn, open, playBoth } from "./playing.mjs";
import { entryOf, example, makeProject, readmeCode, root } from "./project.mjs";

const POLICY = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'";
const tools = join(root, "tests/package/node_modules");
const project = makeProject();
const installed = join(project, "node_modules/pathlight");
const { load } = await import(entryOf(project));
const pathlight = await load();

/** The page, with a script at an address. */
const pageOf = (script) => `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${POLICY}">
<title>Bundled</title>
${markup}
<script type="module" src="${script}"></script>
`;
const puzzles = example(project, "page.html");
const drawing = example(project, "imagine.html");
const markup = puzzles.slice(puzzles.indexOf("<h1>")) + '<canvas id="picture" width="512" height="512"></canvas>';
const [, script] = /<script type="module">(.*)<\/script>/s.exec(drawing) ?? [];
const [, ...lines] = script?.trim().split("\n") ?? [];
// In a function: by default Vite 5 refuses to await outside of one.
const main = `import "pathlight/element";
import { load } from "pathlight";
async function draw() {
${lines.join("\n")}
}
draw();
`;
assert.doesNotMatch(main + markup, /node_modules/);
writeFileSync(join(project, "main.js"), main);
writeFileSync(join(project, "index.html"), pageOf("./main.js"));

let session;
before(async () => (session = await startOn(await serveStatic(project))));
after(() => session.stop());

/** Plays a page of the project, or of another server. */
async function play(path) {
  const page = await open(session, new URL(path, `${session.origin}/`).href);
  await playBoth(page, pathlight);
  await drawn(page);
  await page.close();
}

/** Makes a folder for a bundle whose page and bundle lie beside each other. */
function folderOf(name, script) {
  mkdirSync(join(project, name));
  writeFileSync(join(project, name, "index.html"), pageOf(script));
  return join(project, name);
}

for (const version of ["vite", "vite-5"]) {
  test(`${version} builds it`, async () => {
    const { build } = await import(version);
    const outDir = `${version}-built`;
    await build({ root: project, configFile: false, base: "./", logLevel: "warn", build: { outDir } });
    await play(`${outDir}/index.html`);
  });

  test(`${version} serves it while it is developed`, async () => {
    const { createServer } = await import(version);
    const cacheDir = `${version}-cache`;
    const server = await createServer({
      root: project,
      configFile: false,
      cacheDir,
      logLevel: "warn",
      server: { host: "127.0.0.1" },
    });
    await server.listen();
    await play(server.resolvedUrls.local[0]);
    await server.close();
  });
}

test("webpack builds it", async () => {
  const { default: webpack } = await import("webpack");
  const path = folderOf("webpack", "./main.js");
  // Minified it takes twice as long.
  const optimization = { minimize: false };
  /** @type {import("webpack").Configuration} */
  const options = { mode: "production", context: project, entry: "./main.js", output: { path }, optimization };
  const stats = await new Promise((resolve, reject) =>
    webpack(options, (error, stats) => (error ? reject(error) : resolve(stats))),
  );
  assert.ok(!stats.hasErrors(), stats.toString("errors-only"));
  await play("webpack/index.html");
});

test("Parcel builds it", async () => {
  const options = ["--dist-dir", "parcel", "--public-url", "./", "--no-cache", "--no-source-maps", "--no-autoinstall"];
  execFileSync(join(tools, ".bin/parcel"), ["build", "index.html", ...options], { cwd: project, stdio: "inherit" });
  await play("parcel/index.html");
});

/** Where the README puts such a bundle, below the page. */
const [, below] = /--outdir=dist\/?(\w*)/.exec(readFileSync(join(installed, "README.md"), "utf8")) ?? [];

/** Puts the files of the package where bundles look for them that leave addresses as they are. */
function copyFiles(folder) {
  const command = readmeCode(project, "sh");
  execFileSync("sh", ["-euc", command.replaceAll("dist", folder)], { cwd: project });
}

test("esbuild builds it, with the files of the package beside it", async () => {
  const { build } = await import("esbuild");
  const out = folderOf("esbuild", `./${join(below, "main.js")}`);
  await build({ entryPoints: [join(project, "main.js")], bundle: true, format: "esm", outdir: join(out, below) });
  copyFiles("esbuild");
  await play("esbuild/index.html");
});

test("Rollup builds it, with the files of the package beside it", async () => {
  const [{ rollup }, { nodeResolve }] = await Promise.all([import("rollup"), import("@rollup/plugin-node-resolve")]);
  const out = folderOf("rollup", `./${join(below, "main.js")}`);
  const bundle = await rollup({ input: join(project, "main.js"), plugins: [nodeResolve({ browser: true })] });
  await bundle.write({ dir: join(out, below), format: "es" });
  await bundle.close();
  copyFiles("rollup");
  await play("rollup/index.html");
});

test("a bundle that is imported from a blob finds its files by a base", async () => {
  const { build } = await import("esbuild");
  const out = folderOf("blob", "");
  writeFileSync(
    join(project, "blob.js"),
    `import { load } from "pathlight";
import { PathlightPuzzle } from "pathlight/element";
export async function start(base) {
  const why = await load().catch(({ code, message }) => code + ": " + message);
  PathlightPuzzle.base = base;
  document.body.append(Object.assign(document.createElement("pathlight-puzzle"), { task: "00002:007" }));
  const pathlight = await load({ base });
  return [why, pathlight.propose("00002:007", { count: 1 }).length];
}`,
  );
  await build({ entryPoints: [join(project, "blob.js")], bundle: true, format: "esm", outdir: out });
  copyFiles("blob");
  writeFileSync(join(out, "index.html"), '<!doctype html><html lang="en"><title>Blob</title><body></body></html>');
  const page = await open(session, `${session.origin}/blob/index.html`);
  const [why, count] = await page.evaluate(async () => {
    const script = await (await fetch("blob.js")).blob();
    const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
    return (await import(address)).start(document.baseURI);
  });
  assert.match(why, /^no_wasm: .*name its folder with load\(\{ base: /);
  assert.equal(count, 1);
  await page.getByRole("button", { name: "Drop it" }).waitFor();
  await page.close();
});
