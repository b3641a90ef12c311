// An empty page in Chromium, to run implementations in: the repository's files from a server of its own.

import { once } from "node:events";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { launch } from "../../tests/browser/harness.mjs";

const TYPES = { ".mjs": "text/javascript", ".js": "text/javascript", ".wasm": "application/wasm" };

/** `{ implementation([module, what]), stop() }`; an implementation's wasm runs on the page's thread. */
export async function openPage(root) {
  const browser = await launch();
  const server = createServer(async ({ url }, answer) => {
    const path = normalize(url);
    const body = path === "/" ? "<!doctype html>" : await readFile(join(root, path)).catch(() => null);
    answer.writeHead(body === null ? 404 : 200, {
      "content-type": path === "/" ? "text/html" : (TYPES[extname(path)] ?? "application/octet-stream"),
      // Cross-origin isolated pages have a finer clock.
      "cross-origin-opener-policy": "same-origin",
      "cross-origin-embedder-policy": "require-corp",
    });
    answer.end(body);
  });
  server.listen(0, "127.0.0.1");
  await once(server, "listening");
  const page = await browser.newPage();
  await page.goto(`http://127.0.0.1:${server.address().port}/`);
  return {
    async implementation(module) {
      const result = await page.evaluate(async (module) => {
        const { implementation } = await import("/benches/web/implementation.mjs");
        const read = async (path) => {
          const answer = await fetch(`/${path}`);
          if (!answer.ok) throw new Error(`no ${path}`);
          return new Uint8Array(await answer.arrayBuffer());
        };
        globalThis[module] = await implementation(module, read);
        return globalThis[module].result;
      }, module);
      return {
        result,
        times: (repetitions) => page.evaluate(([module, n]) => globalThis[module].times(n), [module, repetitions]),
      };
    },
    async stop() {
      await browser.close();
      server.close();
    },
  };
}
