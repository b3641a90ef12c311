// Bundles the tests of tests/www and runs them in Node: node scripts/test-www.mjs. They need www/pkg/constants.ts.

import { spawnSync } from "node:child_process";
import { readdir, rm } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
import { bundling } from "./build-page.mjs";

const ROOT = join(dirname(fileURLToPath(import.meta.url)), "..");
const TESTS = join(ROOT, "tests/www");
const OUT = join(ROOT, "target/tests-www");

const names = (await readdir(TESTS)).filter((name) => name.endsWith(".test.ts"));
await rm(OUT, { recursive: true, force: true });
await build({
  ...bundling(),
  entryPoints: names.map((name) => join(TESTS, name)),
  outdir: OUT,
  outExtension: { ".js": ".mjs" },
  platform: "node",
  sourcemap: "inline",
});
const files = names.map((name) => join(OUT, name.replace(/\.ts$/, ".mjs")));
const { status } = spawnSync(process.execPath, ["--enable-source-maps", "--test", ...process.argv.slice(2), ...files], {
  stdio: "inherit",
});
process.exitCode = status ?? 1;
