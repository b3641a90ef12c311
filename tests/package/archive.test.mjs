// The archive of the player's program, unpacked elsewhere: everything that it serves and reads by default is in it.

import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { once } from "node:events";
import { existsSync, mkdtempSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { test } from "node:test";
import { root } from "./project.mjs";

test("the archive serves the page, and its program finds the models", async (context) => {
  const folder = mkdtempSync(join(tmpdir(), "pathlight-archive-"));
  context.after(() => rmSync(folder, { recursive: true, force: true }));
  execFileSync(process.execPath, ["scripts/build-page.mjs"], { cwd: root });
  const built = "target/release/pathlight";
  assert.ok(existsSync(join(root, built)), `${built} is missing: run make build`);
  const printed = execFileSync("scripts/pack-binary", [built], { cwd: root, encoding: "utf8" });
  execFileSync("tar", ["-xzf", join(root, printed.trim()), "-C", folder]);
  const cwd = join(folder, readdirSync(folder)[0]);
  const program = join(cwd, "pathlight");

  const server = spawn(program, ["serve", "--port", "0"], { cwd, stdio: ["ignore", "pipe", "inherit"] });
  context.after(() => server.kill());
  const [line] = await once(createInterface(server.stdout), "line");
  const page = /http:\S+/.exec(line)?.[0] ?? "";
  const get = async (/** @type {string} */ path) => {
    const response = await fetch(page + path);
    assert.equal(response.status, 200, path);
    return response;
  };
  assert.match(await (await get("")).text(), /<title>/);
  await get("pkg/page/pathlight_bg.wasm");
  const { models } = await (await get("assets/model.json")).json();
  for (const { file } of models) await get(`assets/${file}`);

  const args = ["propose", "--task", "00007:008", "--attempts", "1"];
  assert.match(execFileSync(program, args, { cwd, encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] }), /"balls"/);
});
