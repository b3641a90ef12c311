// What may import what: a stranger who reads core/ needs to know nothing else.

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";

const PAGE = "www-next";
/** Each folder, or file of the top, imports only those before it, and itself. */
const LAYERS = [
  "pkg",
  "text",
  "offline",
  "core",
  "model",
  "simulator",
  "actions",
  "effects",
  "stage",
  "view",
  "app",
  "element",
  "main",
];

function importsOf(path: string): string[] {
  const source = readFileSync(`${PAGE}/${path}`, "utf8");
  // Types are erased: they tie nothing together when the page runs.
  const values = source.replaceAll(/^import type [^;]+;$/gms, "");
  return [...values.matchAll(/^(?:import|export) [^;]*?from "([^"]+)";$/gms)].map(([, name]) => name!);
}

const layerOf = (path: string) => path.split(/[/.]/)[0]!;

test("each part of the page imports only those below it, and core/ neither a browser's library nor wasm", () => {
  const files = readdirSync(PAGE, { recursive: true, encoding: "utf8" }).filter(
    (path) => path.endsWith(".ts") && !path.endsWith(".d.ts") && !path.startsWith("pkg"),
  );
  assert.ok(files.length > 20, "the page was found");
  for (const path of files) {
    const place = LAYERS.indexOf(layerOf(path));
    assert.ok(place >= 0, `${path} belongs to no layer`);
    for (const name of importsOf(path)) {
      if (name.endsWith(".css") || name.startsWith("../../assets/") || name.startsWith("../assets/")) continue;
      const isRelative = name.startsWith(".");
      const target = isRelative ? new URL(name, `file:///${path}`).pathname.slice(1) : name;
      const what = `${path} imports ${name}`;
      if (!isRelative) assert.ok(layerOf(path) === "view" || path === "app.ts", what);
      else assert.ok(LAYERS.indexOf(layerOf(target)) <= place, what);
      if (layerOf(path) === "core") assert.ok(!target.startsWith("pkg/page") && !target.startsWith("pkg/worker"), what);
    }
  }
});
