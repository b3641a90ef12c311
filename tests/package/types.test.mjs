// The declarations of the installed package, in a strict TypeScript project that knows nothing of browsers.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { makeProject, root } from "./project.mjs";

const project = makeProject();
const installed = join(project, "node_modules/pathlight");

/** Compiles a file that uses the package. Returns what the compiler says. */
function compile(code) {
  writeFileSync(join(project, "use.ts"), code);
  const options = [
    "--strict",
    "--noEmit",
    "--module",
    "nodenext",
    "--target",
    "es2022",
    "--lib",
    "es2022",
    "--types",
    "",
  ];
  return spawnSync(join(root, "scripts/node_modules/.bin/tsc"), [...options, "use.ts"], {
    cwd: project,
    encoding: "utf8",
  }).stdout;
}

test("its types are complete and strict", () => {
  assert.equal(
    compile(`
    import { load, type Ball, type CodedError, type Pathlight, type Rollout } from "pathlight";
    const pathlight: Pathlight = await load({ weights: null, onProgress: (fraction: number | null) => fraction });
    const ball: Ball = [128, 200, 12];
    const rollout: Rollout = pathlight.simulate(pathlight.fold("cross", 3).dev[0]!, ball);
    const poses: Float32Array = rollout.poses;
    const success: Float32Array | undefined = pathlight.imagine("00007:008").success;
    for (const { ending: { solved } } of pathlight.turn("00007:008", { seed: 1 })) if (solved) break;
    const code: CodedError["code"] = "no_weights";
    export { code, success, poses };
  `),
    "",
  );
  assert.equal(
    compile(`
    import "pathlight/element";
    import type { PathlightPuzzle } from "pathlight/element";
    const puzzle: PathlightPuzzle = document.querySelector("pathlight-puzzle")!;
    const task: string | null = puzzle.task;
    puzzle.addEventListener("attempt", ({ detail: { number, solved } }) => console.log(number + 1, solved === true));
    puzzle.addEventListener("statechange", ({ detail }) => detail.ball?.at(0), { once: true });
    puzzle.addEventListener("modelchange", ({ detail: { status } }) => status === "ready");
    puzzle.addEventListener("click", (event) => event.clientX);
    puzzle.addEventListener("soup", (event: Event) => event.type);
    export { task };
  `),
    "",
  );
  assert.match(
    compile(`
    import "pathlight/element";
    document.querySelector("pathlight-puzzle")!.addEventListener("attempt", ({ detail }) => detail.soup);
  `),
    /'soup' does not exist/,
  );
  assert.match(compile('import { load } from "pathlight"; (await load()).simulate("00007:008", [1, 2]);'), /error TS/);
  assert.match(compile('import { load } from "pathlight"; (await load()).fold("both", 0);'), /error TS/);
});

test("they carry the docs", () => {
  assert.match(readFileSync(join(installed, "element.d.ts"), "utf8"), /\/\*\* The puzzle, "00007:008"/);
  const declarations = readFileSync(join(installed, "api/benchmark.d.ts"), "utf8");
  assert.match(declarations, /\/\*\*(?:(?!\*\/).)*Simulates a task with a ball(?:(?!\*\/).)*\*\/\s*simulate\(/s);
  assert.match(readFileSync(join(installed, "pkg/worker/pathlight.d.ts"), "utf8"), /poses: Float32Array/);
});
