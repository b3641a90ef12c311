// The browser's half of the notebook widget, with a kernel that this page plays: the widget is imported from a blob,
// gets its files in a message, and asks no server. python/tests/test_widget.py tests the other half.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { startOn } from "./harness.mjs";
import { serveStatic } from "./static-server.mjs";

const root = join(import.meta.dirname, "..", "..");
const FILES = [
  "worker.js",
  "pkg/page/pathlight_bg.wasm",
  "pkg/worker/pathlight_bg.wasm",
  "assets/within-0.safetensors",
];

const folder = mkdtempSync(join(tmpdir(), "pathlight-widget-"));
let session;
before(async () => {
  execFileSync("node", [join(root, "scripts/build-widget.mjs")]);
  symlinkSync(join(root, "python/pathlight_phyre/page"), join(folder, "page"));
  symlinkSync(join(root, "assets"), join(folder, "assets"));
  writeFileSync(
    join(folder, "index.html"),
    '<!doctype html><html lang="en"><title>Notebook</title><body></body></html>',
  );
  session = await startOn(await serveStatic(folder));
});
after(async () => {
  await session.stop();
  rmSync(folder, { recursive: true });
});

/** Renders a widget of this state. Returns the state, and what a kernel can do. */
async function renderWidget({ state, files }) {
  const bytes = async (address) => new DataView(await (await fetch(address)).arrayBuffer());
  const script = new Blob([await bytes("page/widget.js")], { type: "text/javascript" });
  const listeners = {};
  let asked = 0;
  const model = {
    get: (name) => state[name],
    set: (name, value) => (state[name] = value),
    save_changes() {},
    on: (event, listener) => (listeners[event] = listener),
    off: (event) => delete listeners[event],
    async send({ wants }) {
      asked++;
      const paths = files.map((file) => (file.startsWith("assets/") ? file : `page/${file}`));
      listeners["msg:custom"]({ [wants]: files }, await Promise.all(paths.map(bytes)));
    },
  };
  const { default: widget } = await import(URL.createObjectURL(script));
  const el = document.body.appendChild(document.createElement("div"));
  const remove = await widget.render({ model, el });
  const change = (name, value) => {
    state[name] = value;
    listeners[`change:${name}`]();
  };
  return { state, change, remove, asked: () => asked };
}

test("a puzzle is played in a widget, and Python learns of it", async () => {
  const page = await session.open("/index.html", { reducedMotion: "reduce" });
  const state = { task: "00007:008", panel: "play", ball: null, attempts: [] };
  const widget = await page.evaluateHandle(renderWidget, { state, files: FILES });
  const drop = page.getByRole("button", { name: "Drop it" });
  await drop.waitFor();
  await widget.evaluate(({ change }) => change("ball", [178, 218, 19]));
  await drop.click();
  await page.waitForFunction(({ state }) => state.attempts.length > 0, widget);
  const { attempts } = await widget.evaluate(({ state }) => state);
  assert.deepEqual(attempts, [{ task: "00007:008", ball: [178, 218, 19], solved: true }]);

  // What a person places.
  await widget.evaluate(({ change }) => change("task", "00002:007"));
  const canvas = page.locator("pathlight-puzzle canvas").first();
  const { width, height } = await canvas.boundingBox();
  await canvas.click({ position: { x: width / 2, y: height / 4 } });
  await page.waitForFunction(({ state }) => state.task === "00002:007" && state.ball !== null, widget);
  const [x] = await widget.evaluate(({ state }) => state.ball);
  assert.ok(Math.abs(x - 128) < 8, `${x}`);

  // The nets come from a blob, too. A second widget asks for nothing.
  await widget.evaluate(({ remove }) => remove());
  const second = await page.evaluateHandle(renderWidget, { state: { ...state, panel: "imagine" }, files: [] });
  const puzzle = page.locator("pathlight-puzzle").nth(1);
  await puzzle.getByText("If you do nothing").filter({ visible: true }).first().waitFor({ timeout: 60_000 });
  // It has one model, so there is none to choose, and no Make, for Python names a task.
  await puzzle.getByRole("tab", { name: "Data" }).click();
  await puzzle.getByRole("spinbutton", { name: "radius" }).waitFor();
  const others = [puzzle.getByRole("combobox", { name: "Model" }), puzzle.getByRole("tab", { name: "Make" })];
  assert.deepEqual(await Promise.all(others.map((one) => one.count())), [0, 0]);
  const asked = await Promise.all([widget, second].map((one) => one.evaluate(({ asked }) => asked())));
  assert.deepEqual(asked, [1, 0]);
  await page.close();
});
