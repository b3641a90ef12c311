// The example of a component for React, checked with the types of React 18 and 19, and played with React 18.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { cpSync, mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { build } from "vite";
import { startOn } from "../browser/harness.mjs";
import { serveStatic } from "../browser/static-server.mjs";
import { open, solve } from "./playing.mjs";
import { entryOf, example, makeProject, root } from "./project.mjs";

const tools = join(root, "tests/package/node_modules");
const project = makeProject();
const { load } = await import(entryOf(project));
writeFileSync(join(project, "puzzle.tsx"), example(project, "puzzle.tsx"));
const compilerOptions = {
  strict: true,
  noEmit: true,
  jsx: "react-jsx",
  target: "es2022",
  lib: ["es2022", "dom"],
  module: "esnext",
  moduleResolution: "bundler",
};
writeFileSync(join(project, "tsconfig.json"), JSON.stringify({ compilerOptions, files: ["puzzle.tsx", "wrong.tsx"] }));

let session;
before(async () => (session = await startOn(await serveStatic(project))));
after(() => session.stop());

/** Puts packages into the project, under other names if they are given. */
function install(packages) {
  for (const [name, source = name] of packages)
    cpSync(join(tools, source), join(project, "node_modules", name), { recursive: true });
}

/** Values that the attributes do not have. */
const WRONG = `import "pathlight/element";
// @ts-expect-error
export const green = <pathlight-puzzle theme="green" />;
// @ts-expect-error
export const yes = <pathlight-puzzle remember="yes" />;
export const heard = <pathlight-puzzle onattempt={({ detail }) => detail.solved} class="wide" id="puzzle" />;
`;

for (const source of ["@types/react", "@types/react-19"]) {
  test(`it compiles with ${source}`, () => {
    install([["@types/react", source], ["csstype"], ["@types/prop-types"]]);
    writeFileSync(join(project, "wrong.tsx"), WRONG);
    const tsc = join(root, "scripts/node_modules/.bin/tsc");
    assert.equal(spawnSync(tsc, ["--project", project], { encoding: "utf8" }).stdout, "");
  });
}

test("it plays, and React 18's remember={false} keeps nothing", async () => {
  install([["react"], ["react-dom"], ["scheduler"], ["loose-envify"], ["js-tokens"]]);
  mkdirSync(join(project, "src"));
  writeFileSync(
    join(project, "src/main.tsx"),
    `import { createRoot } from "react-dom/client";
import { Puzzle } from "../puzzle";
const remember = new URLSearchParams(location.search).has("remember");
createRoot(document.getElementById("root")).render(<Puzzle task="00002:007" remember={remember} />);
`,
  );
  const page = '<!doctype html><html lang="en"><title>React</title><div id="root"></div>';
  writeFileSync(join(project, "index.html"), `${page}<script type="module" src="./src/main.tsx"></script>`);
  await build({ root: project, configFile: false, base: "./", logLevel: "warn" });
  const pathlight = await load();
  for (const [query, kept] of [
    ["", false],
    ["?remember", true],
  ]) {
    const page = await open(session, `${session.origin}/dist/index.html${query}`);
    await solve(page.locator("pathlight-puzzle"), pathlight);
    await page.getByText("Attempts: 1").waitFor();
    assert.equal(await page.evaluate(() => localStorage.length > 0), kept);
  }
});
