// What may import what, and what only one file does: a stranger who reads core/ needs to know nothing else.

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";

const PAGE = "www";
/** Each folder, or file of the top, imports only those before it, and itself. */
const LAYERS = [
  "pkg",
  "text",
  "offline",
  "core",
  "model",
  "simulator",
  "opening",
  "effects",
  "stage",
  "view",
  "app",
  "element",
  "widget",
  "main",
  "api",
  "exhibits",
];
/** The package knows nothing of the page, and the exhibits know the package as other pages do, and the texts. */
const ONLY: Record<string, readonly string[]> = { api: ["pkg", "api"], exhibits: ["pkg", "text", "exhibits"] };
/** What is not the page's own, and may be imported there. */
const OTHERS: Record<string, readonly string[]> = {
  view: ["lit-html"],
  app: ["lit-html"],
  exhibits: ["lit-html", "pathlight"],
};

/** Words, the files or folders that alone may hold them, and why. */
const RULES: readonly [words: RegExp, files: readonly string[], reason: string][] = [
  [
    /innerHTML|outerHTML|insertAdjacentHTML|document\.write|unsafe\w+\(/,
    [],
    "what people write must not become markup",
  ],
  [
    /localStorage|sessionStorage|indexedDB|document\.cookie/,
    ["effects/keeping.ts", "effects/old-keeping.ts", "exhibits/"],
    "one file knows how a browser stores",
  ],
  [/\bhistory\./, ["effects/address.ts"], "one file writes the address"],
  [/\bserviceWorker\b/, ["offline/"], "the page works without one"],
  [/\bnew Worker\(/, ["model/shared.ts", "exhibits/"], "puzzles of a page share one"],
];

const sources = () =>
  readdirSync(PAGE, { recursive: true, encoding: "utf8" }).filter(
    (path) => path.endsWith(".ts") && !path.endsWith(".d.ts") && !path.startsWith("pkg"),
  );
const textOf = (path: string) => readFileSync(`${PAGE}/${path}`, "utf8");

function importsOf(path: string): string[] {
  const source = textOf(path);
  // Types are erased: they tie nothing together when the page runs.
  const values = source.replaceAll(/^import type [^;]+;$/gms, "");
  return [...values.matchAll(/^(?:import|export) [^;]*?from "([^"]+)";$/gms)].map(([, name]) => name!);
}

const layerOf = (path: string) => path.split(/[/.]/)[0]!;

test("each part of the page imports only those below it, and core/ neither a browser's library nor wasm", () => {
  const files = sources();
  assert.ok(files.length > 20, "the page was found");
  for (const path of files) {
    const place = LAYERS.indexOf(layerOf(path));
    assert.ok(place >= 0, `${path} belongs to no layer`);
    for (const name of importsOf(path)) {
      if (name.endsWith(".css") || name.startsWith("../../assets/") || name.startsWith("../assets/")) continue;
      const isRelative = name.startsWith(".");
      const target = isRelative ? new URL(name, `file:///${path}`).pathname.slice(1) : name;
      const what = `${path} imports ${name}`;
      if (!isRelative) assert.ok(OTHERS[layerOf(path)]?.includes(layerOf(name)), what);
      else assert.ok(LAYERS.indexOf(layerOf(target)) <= place, what);
      assert.ok(!isRelative || (ONLY[layerOf(path)] ?? [layerOf(target)]).includes(layerOf(target)), what);
      if (layerOf(path) === "core") assert.ok(!target.startsWith("pkg/page") && !target.startsWith("pkg/worker"), what);
    }
  }
});

test("what one file does is done by no other", () => {
  for (const path of sources())
    for (const [words, files, reason] of RULES) {
      const code = textOf(path).replaceAll(/^\s*(\/\/|\/?\*).*$/gm, "");
      assert.ok(!words.test(code) || files.some((one) => path.startsWith(one)), `${path}: ${words}: ${reason}`);
    }
});
