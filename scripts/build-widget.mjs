// Builds the files of the Python package's notebook widget into python/pathlight_phyre/page: the widget with the
// element in one file, the worker, the wasm (needs www/pkg), and the licences of everything in the wheel. The weights
// are in the package's native library.

import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
import { bundling } from "./build-page.mjs";

const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const out = join(root, "python/pathlight_phyre/page");

rmSync(out, { recursive: true, force: true });
/** The widget offers only the first model. */
const oneModel = {
  name: "one model",
  setup({ onLoad }) {
    onLoad({ filter: /model\.json$/ }, ({ path }) => {
      const { models } = JSON.parse(readFileSync(path, "utf8"));
      return { contents: JSON.stringify({ models: models.slice(0, 1) }), loader: "json" };
    });
  },
};
await build({
  ...bundling(),
  entryPoints: [
    { in: join(root, "www/widget.ts"), out: "widget" },
    { in: join(root, "www/model/worker.ts"), out: "worker" },
  ],
  outdir: out,
  minify: true,
  plugins: [oneModel],
});
for (const side of ["page", "worker"]) {
  mkdirSync(join(out, "pkg", side), { recursive: true });
  copyFileSync(join(root, `www/pkg/${side}/pathlight_bg.wasm`), join(out, `pkg/${side}/pathlight_bg.wasm`));
}
writeFileSync(join(out, "licences.txt"), execFileSync("node", [join(root, "scripts/licences.mjs"), "wheel"]));
