// Builds of dist/ in temporary folders, for tests that upload another version.

import { appendFile, cp, mkdtemp, rm } from "node:fs/promises";
import { rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { buildDist } from "../../scripts/build-dist.mjs";

const www = join(dirname(fileURLToPath(import.meta.url)), "..", "..", "www");

/** An empty folder that goes with the process. */
export async function temporaryFolder() {
  const folder = await mkdtemp(join(tmpdir(), "pathlight-"));
  process.once("exit", () => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

/** A build of the page as it is, not compressed. */
export async function plainDist() {
  const folder = await temporaryFolder();
  return { folder, files: await buildDist({ out: folder, quality: 0 }) };
}

/** A build of another version: a file of the page has one more line. */
export async function changedDist(path = "page/main.js", line = "globalThis.changed = true;") {
  const [page, folder] = [await temporaryFolder(), await temporaryFolder()];
  await cp(www, page, { recursive: true });
  await appendFile(join(page, path), `${line}\n`);
  const files = await buildDist({ page, out: folder, quality: 0 });
  await rm(page, { recursive: true });
  return { folder, files };
}
